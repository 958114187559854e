namespace FootballPhysics.Labs.Zones;

/// <summary>Random kicks through zones of every shape.</summary>
internal static class ZoneDraw
{
    /// <summary>The shapes of zones.</summary>
    public static readonly string[] Shapes = ["box", "sphere", "capsule", "plane", "hills", "ring"];

    private static readonly double[] s_steps = [0.01, 1.0 / 60, 0.02, 0.05];
    private static readonly Integrator[] s_methods = [Integrator.Rk4, Integrator.Rk4, Integrator.Rk4, Integrator.Rk2, Integrator.SemiImplicitEuler];

    /// <summary>Draws a case: a scene without zones, a kick in it, and the step.</summary>
    public static ZoneCase Kick(SeededRandom random)
    {
        int among = (int)random.Uniform(0, 4);
        Scene scene = (random.Uniform(0, 1) < 0.7 ? Scene.Measured : Scene.Published) with
        {
            Obstacles = among == 1 ? [new Obstacle { Shape = new BoxShape(new Vector3d(0, 0, -6), new Vector3d(4, 3, 0.2)) }, new Obstacle { Shape = new SphereShape(new Vector3d(0, 0.4, 3), 0.5) }] : [],
            Goals = among == 2 ? [new Goal { Center = new Vector3d(0, 0, -8), Facing = new Vector3d(0, 0, 1) }] : [],
            Air = among == 3 ? new Air { Wind = new Vector3d(random.Uniform(-8, 8), 0, random.Uniform(-8, 8)) } : new Air(),
        };
        bool rolls = random.Uniform(0, 1) < 0.3;
        double speed = random.Uniform(0.2, rolls ? 12 : 32);
        Vector3d direction = random.Direction();
        Vector3d velocity = speed * (rolls ? new Vector3d(direction.X, 0, direction.Z) : new Vector3d(direction.X, Math.Abs(direction.Y) * random.Uniform(0, 1), direction.Z));
        Vector3d spin = random.Uniform(0, 90) * random.Direction();
        double height = rolls ? scene.Ball.Radius : scene.Ball.Radius + random.Uniform(0, 2);
        var settings = new SolverSettings { Integrator = s_methods[(int)random.Uniform(0, s_methods.Length)] };
        double step = s_steps[(int)random.Uniform(0, s_steps.Length)];
        return new ZoneCase(scene, settings, step, new Vector3d(random.Uniform(-3, 3), height, random.Uniform(-3, 3)), velocity, spin);
    }

    /// <summary>Draws a zone near a point of the path.</summary>
    public static Zone Zone(SeededRandom random, int index, Vector3d near)
    {
        int shape = (int)random.Uniform(0, Shapes.Length);
        double size = Math.Exp(random.Uniform(Math.Log(0.02), Math.Log(4)));
        Vector3d center = near + (size * random.Uniform(0, 1.3) * random.Direction());
        return new Zone
        {
            Name = FormattableString.Invariant($"{Shapes[shape]} {index}"),
            Of = random.Uniform(0, 1) < 0.5 ? ZonePart.Ball : ZonePart.Center,
            Shape = shape switch
            {
                0 => new BoxShape(center, new Vector3d(size * random.Uniform(0.1, 1), size * random.Uniform(0.1, 1), size * random.Uniform(0.1, 1)), Rotation(random)),
                1 => new SphereShape(center, size),
                2 => new CapsuleShape(center, center + (size * random.Direction()), size * random.Uniform(0.05, 0.6)),
                3 => new PlaneShape(center, random.Direction()),
                4 => LabMath.Hills(near.X - 6, near.Z - 6, 1.2, 12, (_, _) => near.Y + random.Uniform(-0.3, 0.3)),
                _ => new RingShape(center, 0.5 + size, Math.Max(0.01, 0.2 * size)),
            },
        };
    }

    private static Quaterniond Rotation(SeededRandom random)
    {
        while (true)
        {
            var q = new Quaterniond(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
            if (q.LengthSquared is > 1e-3 and <= 1)
            {
                return q.Normalized();
            }
        }
    }
}

/// <summary>A kick in a scene without zones.</summary>
internal sealed record ZoneCase(Scene Scene, SolverSettings Settings, double Step, Vector3d Position, Vector3d Velocity, Vector3d Spin);

/// <summary>A ring around a vertical axis, as a custom shape: it has a hole, and a hollow inside.</summary>
internal sealed class RingShape(Vector3d center, double radius, double thickness) : IShape
{
    public double MaximumConcaveCurvature => 1.0 / (radius - thickness);

    public Bounds3d Bounds => Bounds3d.Around(center, radius + thickness, thickness, radius + thickness);

    public ShapePoint At(in Vector3d point)
    {
        Vector3d from = point - center;
        Vector3d flat = from.Horizontal;
        Vector3d nearest = flat.Length > 0 ? radius / flat.Length * flat : new Vector3d(radius, 0, 0);
        Vector3d away = from - nearest;
        double distance = away.Length;
        Vector3d normal = distance > 0 ? away / distance : Vector3d.Up;
        return new ShapePoint(distance - thickness, in normal, SymmetricMatrix3d.AroundPoint(in normal, Math.Max(distance, 1e-9)));
    }
}
