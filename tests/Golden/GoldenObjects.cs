using FootballPhysics.Engines;
using FootballPhysics.Laws;
using FootballPhysics.Shapes;

// The objects of the golden scenes: shapes by name, custom shapes, an engine with its colliders. All numbers are exact on every runtime.

namespace FootballPhysics.Golden;

internal static class GoldenObjects
{
    public const double Radius = 0.11;

    /// <summary>The shape of a player about the point between his feet.</summary>
    public static IShape PlayerShape { get; } = new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25);

    public static SurfaceMaterial Smooth { get; } = SurfaceMaterial.GoalFrame with
    {
        SlidingFriction = 0,
        ImpactFriction = 0,
        RollingResistance = 0,
        RollingResistancePerSpeed = 0,
        TorsionalPatchRadius = 0,
    };

    /// <summary>A surface on which a ball never slips and which does not slow a roll.</summary>
    public static SurfaceMaterial Rough { get; } = SurfaceMaterial.GoalFrame with
    {
        NormalRestitution = 0.5,
        ImpactFriction = 5,
        SlidingFriction = 5,
        RollingResistance = 0,
        RollingResistancePerSpeed = 0,
        TorsionalPatchRadius = 0,
    };

    public static Obstacle Thing(string name, IShape shape, SurfaceMaterial? surface = null, Vector3d velocity = default, Vector3d spin = default, double mass = double.PositiveInfinity)
    {
        return new Obstacle { Name = name, Shape = shape, Surface = surface ?? SurfaceMaterial.Board, Velocity = velocity, Spin = spin, Mass = mass };
    }

    /// <summary>A box from one corner to the opposite one.</summary>
    public static IShape Box(double x0, double y0, double z0, double x1, double y1, double z1)
    {
        return new BoxShape(new Vector3d(0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.5 * (z0 + z1)), new Vector3d(0.5 * (x1 - x0), 0.5 * (y1 - y0), 0.5 * (z1 - z0)));
    }

    public static IShape Plane(double x, double y, double z, double nx, double ny, double nz)
    {
        return new PlaneShape(new Vector3d(x, y, z), new Vector3d(nx, ny, nz));
    }

    /// <summary>A board of 1 m along x: its face is at z.</summary>
    public static Obstacle BoardAlongX(double z, double from = -50, double to = 50)
    {
        return Thing("board", Box(from, 0, z - 0.1, to, 1, z));
    }

    /// <summary>A board of 1 m along z: its face is at x.</summary>
    public static Obstacle BoardAlongZ(double x)
    {
        return Thing("side board", Box(x - 0.1, 0, -50, x, 1, 50));
    }

    public static Scene With(this Scene scene, params Obstacle[] obstacles)
    {
        return scene with { Obstacles = obstacles };
    }

    public static Scene InWind(this Scene scene, double x, double y, double z)
    {
        return scene with { Air = new Air { Wind = new Vector3d(x, y, z) } };
    }

    /// <summary>The scene without ground: the balls are on objects alone.</summary>
    public static Scene InSpace(this Scene scene)
    {
        return scene with { Ground = scene.Ground with { Height = double.NegativeInfinity } };
    }

    /// <summary>Ground of heights that are given by a function, 0.5 m apart over 10 m × 10 m.</summary>
    public static Scene OnHills(this Scene scene, Func<double, double, double> height)
    {
        return scene with { Ground = new Ground { Material = scene.Ground.Material, Aerodynamics = scene.Ground.Aerodynamics, Heights = Hills(height) } };
    }

    public static HeightField Hills(Func<double, double, double> height)
    {
        var values = new double[21, 21];
        for (int i = 0; i <= 20; i++)
        {
            for (int j = 0; j <= 20; j++)
            {
                values[i, j] = height((0.5 * i) - 5, (0.5 * j) - 5);
            }
        }

        return HeightField.FromControlValues(-5, -5, 0.5, values);
    }
}

/// <summary>The inside of a pipe along x: a concave shape of the game's own.</summary>
internal sealed class GoldenPipe : IShape
{
    private readonly Vector3d _center;
    private readonly double _radius;

    public GoldenPipe(Vector3d center, double radius)
    {
        _center = center;
        _radius = radius;
    }

    public double MaximumConcaveCurvature => 1 / _radius;

    public Bounds3d Bounds => Bounds3d.Everywhere;

    public ShapePoint At(in Vector3d point)
    {
        Vector3d from = point - _center;
        from = new Vector3d(0, from.Y, from.Z);
        double l = from.Length;
        Vector3d normal = l > 0 ? -from / l : Vector3d.Up;
        return new ShapePoint(_radius - l, in normal, SymmetricMatrix3d.AroundAxis(in normal, new Vector3d(1, 0, 0), -l));
    }
}

/// <summary>The inside of a sphere: a concave shape of the game's own.</summary>
internal sealed class GoldenBowl : IShape
{
    private readonly Vector3d _center;
    private readonly double _radius;

    public GoldenBowl(Vector3d center, double radius)
    {
        _center = center;
        _radius = radius;
    }

    public double MaximumConcaveCurvature => 1 / _radius;

    public Bounds3d Bounds => Bounds3d.Everywhere;

    public ShapePoint At(in Vector3d point)
    {
        Vector3d from = point - _center;
        double l = from.Length;
        Vector3d normal = l > 0 ? -from / l : Vector3d.Up;
        return new ShapePoint(_radius - l, in normal, SymmetricMatrix3d.AroundPoint(in normal, -l));
    }
}

/// <summary>Stripes along z, 0.7 m wide: two of three have a material of their own.</summary>
internal sealed class GoldenStripes : ISurfacePattern
{
    public IReadOnlyList<SurfaceMaterial> Surfaces { get; } = new[] { SurfaceMaterial.WetTurf, SurfaceMaterial.Concrete };

    public double MinimumWidth => 0.7;

    public int At(double x, double z)
    {
        int stripe = (int)Math.Floor(x / 0.7);
        return (((stripe % 3) + 3) % 3) - 1;
    }
}

/// <summary>An engine that finds all of its colliders in every cast. Those without a shape are planes.</summary>
internal sealed class GoldenEngine : IEngineColliders
{
    private readonly List<EngineCollider> _colliders = new List<EngineCollider>();
    private readonly List<(EngineCollider Collider, Vector3d Point, Vector3d Normal, Vector3d Velocity)> _surfaces = new List<(EngineCollider, Vector3d, Vector3d, Vector3d)>();

    public double Time { get; set; }

    public double MaximumSpeed { get; set; }

    /// <summary>Adds a collider of a known shape.</summary>
    public EngineCollider Add(string name, IShape shape, SurfaceMaterial? surface = null, double mass = double.PositiveInfinity)
    {
        var collider = new EngineCollider(name, shape, surface) { Mass = mass };
        _colliders.Add(collider);
        return collider;
    }

    /// <summary>Adds a plane without a known shape.</summary>
    public void AddSurface(string name, Vector3d point, Vector3d normal, Vector3d velocity = default)
    {
        _surfaces.Add((new EngineCollider(name, SurfaceMaterial.Wood), point, normal / normal.Length, velocity));
    }

    public void Cast(in SphereCast cast, EngineHits hits)
    {
        foreach (EngineCollider collider in _colliders)
        {
            hits.Add(collider);
        }

        foreach ((EngineCollider collider, Vector3d point, Vector3d normal, Vector3d velocity) in _surfaces)
        {
            Vector3d from = cast.From;
            Vector3d to = cast.From + (cast.Distance * cast.Direction);
            double first = Vector3d.Dot(from - point, normal);
            double last = Vector3d.Dot(to - point, normal);
            Vector3d near = first < last ? from : to;
            double distance = Math.Min(first, last);
            if (distance <= cast.Radius)
            {
                collider.TouchAt(near - (distance * normal), normal, velocity);
                hits.Add(collider);
            }
        }
    }
}
