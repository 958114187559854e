using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>The shots of the gallery that hit something: frames, nets, a head, a wall.</summary>
internal static class ThingShots
{
    private const double Radius = 0.11;

    public static IReadOnlyList<GalleryShot> All { get; } = [OffTheBar(), OffBothPosts(), HeadedCorner(), RoundTheWall(), OverTheKeeper(), DownTheSlope()];

    private static GalleryShot OffTheBar() => new()
    {
        Id = "off-the-bar",
        Name = "Off the bar and in",
        About = "From 20 m against the underside of the bar: the ball comes down half a metre behind the line.",
        Scenario = Shot(new Vector3d(0, Radius, 0), ViewFrame.Direction(29.6, 3, 13.8), 0, 0) with { Scene = new Scene { Goals = [Furniture.Goal(20)] } },
        DrawnTo = 24,
    };

    private static GalleryShot OffBothPosts()
    {
        var scene = new Scene { Goals = [Furniture.Goal(20)] };
        var simulator = new Simulator(scene);
        var from = new Vector3d(0, Radius, -10);

        // The range of suitable directions is only a hundredth of a degree wide, so search for it.
        Vector3d velocity = Enumerable.Range(0, 200).Select(i => ViewFrame.Direction(30, 19.6 + (0.0025 * i), 12))
            .First(kick => Touched(simulator, from, kick) is ["right post", "left post", "goal", ..]);
        return new GalleryShot
        {
            Id = "off-both-posts",
            Name = "In off both posts",
            About = "From 10 m against one post, across the goal mouth against the other post, and in. A hundredth of a degree decides it.",
            Scenario = Shot(from, velocity, 0, 0) with { Scene = scene },
            DrawnTo = 24,
        };
    }

    /// <summary>Returns the names of the objects that a ball hits within two seconds, including the goal.</summary>
    private static string[] Touched(Simulator simulator, Vector3d from, Vector3d velocity)
    {
        var log = new StepLog();
        BallState state = simulator.Launch(from, velocity, Vector3d.Zero);
        simulator.Run(ref state, Scenario.DefaultTimeStep, 2, StopAt.Rest, log);
        return [.. log.Events.Span.ToArray().Where(item => item.Kind is BallEventKind.Impact or BallEventKind.Goal).Select(item => item.Kind == BallEventKind.Goal ? "goal" : simulator.NameOf(item.ColliderIndex) ?? "")];
    }

    private static GalleryShot HeadedCorner()
    {
        // The view is along the goal line from the corner to the right of the goal. The pitch is on the left.
        var head = new Obstacle { Name = "head", Shape = new SphereShape(new Vector3d(-11.89, 1.65, -29.23), 0.11), Surface = SurfaceMaterial.Head, Velocity = new Vector3d(4.7, 0.4, -1.4) };
        return new GalleryShot
        {
            Id = "headed-corner",
            Name = "Corner, headed in",
            About = "A corner to the edge of the six-yard box, headed in under the bar on the run. Dashed: without the header.",
            Scenario = Shot(new Vector3d(0, Radius, 0), ViewFrame.Direction(25, 16, 20), -10, -20) with
            {
                Scene = new Scene { Goals = [new Goal { Center = new Vector3d(0, 0, -34), Facing = new Vector3d(-1, 0, 0) }], Obstacles = [head] },
            },
            Comparison = Shot(new Vector3d(0, Radius, 0), ViewFrame.Direction(25, 16, 20), -10, -20),
            ComparisonName = "nobody there",
            DrawnTo = 44,
        };
    }

    private static GalleryShot RoundTheWall()
    {
        var request = new AimRequest
        {
            From = new Vector3d(0, Radius, 0),
            Target = new Vector3d(2.6, 0.6, -22),
            Speed = 26,
            MaximumElevationDegrees = 15,
            MaximumTopSpin = 0,
            MaximumSideSpin = 100,
            SpinIsFree = true,
        };
        Scene scene = new() { Goals = [Furniture.Goal(22)], Obstacles = [Furniture.Wall(9.15, -1.7, 0.8, 1.9)] };
        AimResult straight = new Aimer(scene).Find(request with { SpinIsFree = false });
        AimResult round = new Aimer(scene).Find(request);
        Scenario kick = Shot(request.From, round.Velocity, 0, 0) with { Scene = scene, Spin = round.Spin };
        return new GalleryShot
        {
            Id = "round-the-wall",
            Name = "Round the wall",
            About = $"Straight for the corner it hits the {straight.BlockedBy} (dashed). The library found another kick at the same speed, which bends round the outside.",
            Scenario = kick,
            Comparison = Shot(request.From, straight.Velocity, 0, 0) with { Scene = scene, Spin = straight.Spin },
            ComparisonName = "without spin",
            Points = [request.Target],
            DrawnTo = 26,
        };
    }

    private static GalleryShot OverTheKeeper()
    {
        Obstacle keeper = new()
        {
            Name = "keeper",
            Shape = new CapsuleShape(new Vector3d(0, 0.2, -13), new Vector3d(0, 1.7, -13), 0.2),
            Surface = SurfaceMaterial.Boot,
        };
        return new GalleryShot
        {
            Id = "over-the-keeper",
            Name = "Chip over the keeper",
            About = "The keeper is nine metres off the line: over him, and down under the bar.",
            Scenario = Shot(new Vector3d(0, Radius, 0), ViewFrame.Direction(16.5, 0, 38), 0, 0) with { Scene = new Scene { Goals = [Furniture.Goal(22)], Obstacles = [keeper] } },
            DrawnTo = 26,
        };
    }

    private static GalleryShot DownTheSlope()
    {
        Obstacle wall = new()
        {
            Name = "board",
            Shape = new BoxShape(new Vector3d(2, -1.2, -13), new Vector3d(4, 1, 0.2), Quaterniond.FromAxisAngle(Vector3d.Up, 0.35)),
            Surface = SurfaceMaterial.Wood,
        };
        return new GalleryShot
        {
            Id = "down-the-slope",
            Name = "Down a slope into a board",
            About = "Pushed down a slope of one in ten, it rolls on almost as fast, hits an oblique board, and rolls up and sideways until it rests.",
            SceneFields = ["ground.normal=[0,1,-0.1]"],
            SceneCode = "Scene.Measured with { Ground = new Ground { Normal = new Vector3d(0, 1, -0.1) } }",
            Scenario = Shot(new Vector3d(0, 0, 0), new Vector3d(1.2, -0.7, -7), 0, 0) with
            {
                Scene = Scene.Measured with { Ground = new Ground { Normal = new Vector3d(0, 1, -0.1) }, Obstacles = [wall] },
            },
        };
    }

    private static Scenario Shot(Vector3d position, Vector3d velocity, double top, double side) =>
        GalleryShots.Shot(position, velocity, KickVectors.Spin(velocity, top, side)) with { Duration = 60 };
}
