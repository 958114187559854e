using FootballPhysics.Aiming;
using FootballPhysics.Shapes;

namespace FootballPhysics.Headless;

/// <summary>A kick and its scene.</summary>
/// <param name="Name">The name.</param>
/// <param name="Scene">The ball, the air, the ground, the goals and the walls.</param>
/// <param name="From">The position of the ball before the kick, m.</param>
/// <param name="Velocity">Velocity, m/s.</param>
/// <param name="Spin">Spin, rad/s.</param>
internal sealed record Shot(string Name, Scene Scene, Vector3d From, Vector3d Velocity, Vector3d Spin);

/// <summary>The shots of the sample. y is up, −z is forward, x is to the right.</summary>
internal static class Shots
{
    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -25), Facing = new Vector3d(0, 0, 1) };
    private static readonly Scene s_goalAhead = new() { Goals = [s_goal] };

    // Four players stand shoulder to shoulder, 9.15 m from the ball.
    private static readonly Scene s_wall = s_goalAhead with
    {
        Obstacles = [new Obstacle { Name = "wall", Shape = new BoxShape(new Vector3d(-1.2, 0.9, -9.15), new Vector3d(1, 0.9, 0.2)), Surface = SurfaceMaterial.Boot }],
    };

    public static IEnumerable<Shot> All()
    {
        var spot = new Vector3d(0, 0.11, 0);
        yield return FreeKick(spot);
        yield return Kick("a shot off the post", s_goalAhead, spot + new Vector3d(0, 0, -14), speed: 26, elevation: 3, azimuth: 18.45);
        yield return Kick("a dipping shot", s_goalAhead, spot, speed: 29, elevation: 16, azimuth: 4, topSpin: 55);
        yield return Kick("a goal kick in the wind", new Scene { Air = new Air { Wind = new Vector3d(6, 0, 2) } }, spot, speed: 30, elevation: 40, topSpin: -30);
        yield return Kick("a pass over wet turf", new Scene { Ground = Ground.Of(SurfaceMaterial.WetTurf) }, spot, speed: 14, elevation: 1, sideSpin: 10);
    }

    /// <summary>A kick over the wall into the upper left corner, which the library finds.</summary>
    private static Shot FreeKick(Vector3d spot)
    {
        var corner = new Vector3d(-3.3, 2.0, -25);
        AimResult found = new Aimer(s_wall).Find(new AimRequest
        {
            From = spot,
            Target = corner,
            Waypoint = new Vector3d(-1.2, 2.3, -9.15),
            WaypointTolerance = 0.3,
            Speed = 25,
            TopSpin = -5,
            SideSpin = 45,
        });
        return new Shot($"a free kick over the wall ({found.Status}, {1000 * found.Miss:F1} mm off)", s_wall, spot, found.Velocity, found.Spin);
    }

    private static Shot Kick(
        string name, Scene scene, Vector3d from, double speed, double elevation, double azimuth = 0, double topSpin = 0, double sideSpin = 0)
    {
        KickVectors.FromAngles(speed, elevation, azimuth, topSpin, sideSpin, out Vector3d velocity, out Vector3d spin);
        return new Shot(name, scene, from, velocity, spin);
    }
}
