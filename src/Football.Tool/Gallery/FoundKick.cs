using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>A free kick that the two-point solver finds: through a point above the wall, into the corner behind it.</summary>
internal static class FoundKick
{
    private const double Goal = 22;
    private const double Wall = 9.15;

    /// <summary>The target in the corner of the goal, in m.</summary>
    public static Vector3d Target { get; } = new(-3.3, 0.6, -Goal);

    /// <summary>The waypoint just above the wall, in m.</summary>
    public static Vector3d Through { get; } = new(-2.2, 2.35, -Wall);

    /// <summary>Finds the kick, and returns its shot.</summary>
    public static GalleryShot Shot()
    {
        var request = new AimRequest
        {
            From = new Vector3d(0, 0.11, 0),
            Target = Target,
            Waypoint = Through,
            Speed = 24,
            MaximumTopSpin = 60,
            MaximumSideSpin = 60,
        };
        AimResult found = new Aimer(Scene.Measured).Find(request);
        Scenario kick = GalleryShots.Shot(request.From, found.Velocity, found.Spin) with
        {
            Scene = Scene.Measured with { Obstacles = [Furniture.Wall(Wall, 0.4, 3.4, 1.9)], Goals = [Furniture.Goal(Goal)] },
        };
        return new GalleryShot
        {
            Id = "found-free-kick",
            Name = "Free kick found for two points",
            About = "The library found this kick: from 22 m at 86 km/h, just over the heads of the wall and into the bottom corner. Dashed: the same kick without spin.",
            Scenario = kick,
            Comparison = kick with { Spin = Vector3d.Zero },
            ComparisonName = "without spin",
            Points = [Through, Target],
            DrawnTo = 30,
        };
    }
}
