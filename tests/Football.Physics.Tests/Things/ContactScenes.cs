using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>Balls with several contacts, drawn at random.</summary>
internal static class ContactScenes
{
    private const double Radius = 0.11;

    /// <summary>Spheres about a ball that goes anywhere: a set of contacts with gaps, frictions and velocities of their own.</summary>
    public static World WorldOf(Random random, int count, bool moves, bool resists, double gap, out BallState state)
    {
        Vector3d Any(double size) => size * new Vector3d(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
        var place = new Vector3d(0.3, 40, -0.2);
        var obstacles = new List<Obstacle>();
        Vector3d middle = Any(2).Normalized();
        for (int i = 0; i < count; i++)
        {
            // Most of them on one side, so that there is somewhere to go.
            Vector3d n = (middle + Any(2.2)).Normalized();
            double free = random.Next(2) == 0 ? 0 : gap * random.NextDouble();
            obstacles.Add(new Obstacle
            {
                Name = $"sphere {i}",
                Shape = new SphereShape(place - ((Radius + 0.5 + free) * n), 0.5),
                Velocity = moves ? Any(2) : Vector3d.Zero,
                Surface = SurfaceMaterial.GoalFrame with
                {
                    SlidingFriction = 0.1 + random.NextDouble(),
                    RollingResistance = resists ? 0.05 : 0,
                    RollingResistancePerSpeed = resists ? 0.01 : 0,
                    SpinDamping = resists ? 0.01 : 0,
                    TorsionalPatchRadius = resists ? 0.02 : 0,
                },
            });
        }

        Scene scene = new()
        {
            Ball = new BallProperties { Radius = Radius },
            Ground = Ground.None,
            Obstacles = obstacles,
        };
        var simulator = new Simulator(scene);

        // Sometimes it rolls, so that the resistance to rolling acts.
        Vector3d velocity = (Any(6) - (2 * random.NextDouble() * middle));
        Vector3d spin = random.Next(2) == 0 ? Any(120) : Vector3d.Zero;
        if (resists && random.Next(2) == 0)
        {
            Vector3d n = ((place - ((SphereShape)obstacles[0].Shape).Center) / (place - ((SphereShape)obstacles[0].Shape).Center).Length).Normalized();
            Vector3d relative = velocity - obstacles[0].Velocity;
            relative -= Vector3d.Dot(in relative, in n) * n;
            spin = Vector3d.Cross(in n, in relative) / Radius;
        }

        state = simulator.Launch(place, velocity, spin);
        return simulator.World!;
    }
}
