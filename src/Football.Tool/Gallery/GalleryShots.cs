using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>The shots of the gallery.</summary>
internal static class GalleryShots
{
    private const double Radius = 0.11;

    public static IReadOnlyList<GalleryShot> All { get; } =
    [
        FreeKick(), FoundKick.Shot(), Corner(), GoalKick(), GoalKickInVacuum(), DrivenPass(), Chip(),
        NoSpinDrive(), DroppedWithTopspin(), GroundPass(), LongRoll(), InTheWind(), Beach(), .. ThingShots.All,
        QueryShots.Beaten(), QueryShots.Saved(), QueryShots.OneBounce(), QueryShots.OffThePost(), QueryShots.Ellipse(),
    ];

    private static GalleryShot FreeKick()
    {
        Scenario kick = Kick(25.5, left: -16, up: 19, top: 12, side: 60) with
        {
            Scene = new Scene { Obstacles = [Furniture.Wall(9.35, -3.1, 0.1, 1.85)], Goals = [Furniture.Goal(22)] },
        };
        return new GalleryShot
        {
            Id = "free-kick",
            Name = "Free kick over the wall",
            About = "From 22 m, over the wall, bent to the left by sidespin and just inside the post on the kicker's right. Without spin it misses.",
            Scenario = kick,
            Comparison = kick with { Spin = Vector3d.Zero },
            ComparisonName = "without spin",
            DrawnTo = 30,
        };
    }

    private static GalleryShot Corner()
    {
        // The view is along the goal line from the corner to the right of the goal. The pitch is on the left.
        Scenario kick = Kick(25, left: 19, up: 25, top: -10, side: -52) with
        {
            Scene = new Scene { Goals = [new Goal { Center = new Vector3d(0, 0, -34), Facing = new Vector3d(-1, 0, 0) }] },
        };
        return new GalleryShot
        {
            Id = "corner",
            Name = "Inswinging corner",
            About = "The ball starts out over the six-yard box, and the sidespin swings it back towards the goal. The view is along the goal line.",
            Scenario = kick,
            Comparison = kick with { Spin = Vector3d.Zero },
            ComparisonName = "without spin",
            DrawnTo = 56,
        };
    }

    private static GalleryShot GoalKick() => new()
    {
        Id = "goal-kick",
        Name = "Goal kick",
        About = "Long and high with some backspin. The air takes nearly a third of the range that it would have in a vacuum.",
        Scenario = Kick(30, left: 0, up: 36, top: -25, side: 0),
        Comparison = Kick(30, left: 0, up: 36, top: -25, side: 0) with { Scene = Scene.Published },
        ComparisonName = "by the published laws",
        Markings = [Furniture.HalfwayLine],
    };

    private static GalleryShot GoalKickInVacuum()
    {
        Scenario kick = Kick(30, left: 0, up: 36, top: -25, side: 0);
        return new GalleryShot
        {
            Id = "goal-kick-in-vacuum",
            Name = "The same in a vacuum",
            About = "The goal kick without air: a parabola. The dashed line is the kick in air.",
            Scenario = kick with { Scene = Scene.Measured with { Forces = ForceSet.None } },
            SceneCode = "Scene.Measured with { Forces = ForceSet.None }",
            SceneFields = ["forces.buoyancy=false", "forces.drag=none", "forces.magnus=none", "forces.spinDecay=none"],
            Comparison = kick,
            ComparisonName = "in air",
            DrawnTo = 160,
            Markings = [Furniture.HalfwayLine],
        };
    }

    private static GalleryShot DrivenPass() => new()
    {
        Id = "driven-pass",
        Name = "Driven pass",
        About = "Low and fast with backspin, which holds it up; it skips on wet turf.",
        Scenario = Kick(26, left: 0, up: 8, top: -35, side: 0) with { Scene = Scene.Measured with { Ground = Ground.Of(SurfaceMaterial.WetTurf) } },
        Comparison = Kick(26, left: 0, up: 8, top: -35, side: 0) with { Scene = Scene.Published with { Ground = Ground.Presets["publishedWetTurf"] } },
        ComparisonName = "by the published laws",
        SceneCode = "Scene.Measured with { Ground = Ground.Of(SurfaceMaterial.WetTurf) }",
        SceneFields = ["ground.surface=wetTurf"],
    };

    private static GalleryShot Chip() => new()
    {
        Id = "chip",
        Name = "Chip that checks",
        About = "A steep chip with strong backspin: it hangs, and the spin throws it back at the first bounce.",
        Scenario = Kick(15, left: 0, up: 52, top: -75, side: 0),
    };

    private static GalleryShot NoSpinDrive()
    {
        Scenario kick = Kick(31, left: 0, up: 11, top: 0, side: 0);
        return new GalleryShot
        {
            Id = "no-spin-drive",
            Name = "Drive without spin",
            About = "Struck clean through the middle: fast, flat and straight. Dashed: with backspin, which holds it up.",
            Scenario = kick,
            Comparison = Kick(31, left: 0, up: 11, top: -40, side: 0),
            ComparisonName = "with backspin 40 rad/s",
        };
    }

    private static GalleryShot DroppedWithTopspin() => new()
    {
        Id = "dropped-with-topspin",
        Name = "Dropped with topspin",
        About = "Dropped from 3 m with 70 rad/s of topspin: each bounce turns spin into forward speed.",
        Scenario = Shot(new Vector3d(0, 3, 0), Vector3d.Zero, KickVectors.Spin(ViewFrame.Direction(1, 0, 0), 70, 0)),
    };

    private static GalleryShot GroundPass() => new()
    {
        Id = "ground-pass",
        Name = "Ground pass",
        About = "Pushed along the ground: it skids first, loses two fifths of its pace, and rolls from there.",
        Scenario = Kick(13, left: 0, up: 0, top: 0, side: 0),
    };

    private static GalleryShot LongRoll()
    {
        Vector3d velocity = ViewFrame.Direction(11, 0, 0);
        return new GalleryShot
        {
            Id = "long-roll",
            SceneCode = "new Scene { Ground = Ground.Of(SurfaceMaterial.Indoor), Air = new Air { Wind = new Vector3d(-2, 0, 0) } }",
            SceneFields = ["ground.surface=indoor", "air.wind=[-2,0,0]"],
            Name = "Long roll",
            About = "It rolls from the start on an indoor court, and a crosswind of 2 m/s carries it to the left.",
            Scenario = Shot(new Vector3d(0, Radius, 0), velocity, KickVectors.Spin(velocity, 11 / Radius, 0)) with
            {
                Scene = Scene.Measured with { Ground = Ground.Of(SurfaceMaterial.Indoor), Air = new Air { Wind = new Vector3d(-2, 0, 0) } },
            },
        };
    }

    private static GalleryShot InTheWind()
    {
        Scenario kick = Kick(27, left: 0, up: 50, top: -20, side: 0);
        return new GalleryShot
        {
            Id = "high-ball-in-the-wind",
            SceneCode = "Scene.Windy(new Vector3d(-7.778, 0, 7.778)) with { Ground = new Ground { Aerodynamics = GroundAerodynamics.None } }",
            SceneFields = ["air.wind=[-7.778,0,7.778]", "ground.aerodynamics=none"],
            Name = "High ball in the wind",
            About = "A high ball into a wind of 11 m/s from ahead and from the right. Dashed: in still air. The wind does not act on the ground here, or the ball would never stop.",
            Scenario = kick with
            {
                Scene = Scene.Windy(new Vector3d(-7.778, 0, 7.778)) with { Ground = new Ground { Aerodynamics = GroundAerodynamics.None } },
            },
            Comparison = kick,
            ComparisonName = "in still air",
        };
    }

    private static GalleryShot Beach() => new()
    {
        Id = "beach-ball",
        SceneCode = "new Scene { Ball = BallProperties.BeachBall, Ground = Ground.Presets[\"publishedSand\"] }",
        SceneFields = ["ball.type=beachBall", "ground.surface=publishedSand"],
        Name = "Beach ball",
        About = "Large and light: the air stops it within metres, sidespin throws it aside, and it stops where it lands on the sand.",
        Scenario = Shot(new Vector3d(0, 1, 0), ViewFrame.Direction(16, 0, 30), KickVectors.Spin(ViewFrame.Direction(1, 0, 0), 0, 25)) with
        {
            Scene = Scene.Measured with { Ball = BallProperties.BeachBall, Ground = Ground.Presets["publishedSand"] },
        },
    };

    private static Scenario Kick(double speed, double left, double up, double top, double side)
    {
        Vector3d velocity = ViewFrame.Direction(speed, left, up);
        return Shot(new Vector3d(0, Radius, 0), velocity, KickVectors.Spin(velocity, top, side));
    }

    /// <summary>Returns a shot until the ball rests.</summary>
    public static Scenario Shot(Vector3d position, Vector3d velocity, Vector3d spin) => new()
    {
        Scene = Scene.Measured,
        Position = position,
        Velocity = velocity,
        Spin = spin,
        StopAt = StopAt.Rest,
        Duration = 120,
        Samples = true,
    };
}
