using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Draws worlds: goals, posts, boxes, balls, walls, nets, slopes and bumps around the origin, and a shot among them.</summary>
internal sealed class WorldDraw
{
    private readonly Random _random;
    private readonly Ground _ground;

    public WorldDraw(int seed, bool moves, Profile profile)
    {
        _random = new Random(seed);
        int count = 1 + _random.Next(12);
        _ground = profile.Ground();
        Scene = profile.Scene() with
        {
            Forces = seed % 4 == 0 ? Scene.Vacuum.Forces : seed % 4 == 1 ? ForceSet.Measured with { KnuckleSeed = seed } : profile.Forces(),
            Ground = DrawGround(),
            Obstacles = [.. Enumerable.Range(0, count).Select(_ => DrawObstacle(moves && _random.Next(3) == 0))],
            Goals = _random.Next(2) == 0 ? [new Goal { Center = new Vector3d(0, 0, -8), Facing = new Vector3d(Range(-0.3, 0.3), 0, 1) }] : [],
            Nets = _random.Next(3) == 0
                ? [new Net { Center = Place(1), Normal = new Vector3d(Range(-1, 1), 0, 1), Along = Vector3d.Up, HalfLength = 1, HalfWidth = 2 }]
                : [],
        };
        Velocity = new Vector3d(Range(-25, 25), Range(-5, 15), Range(-30, 10));
        Spin = new Vector3d(Range(-60, 60), Range(-60, 60), Range(-60, 60));
    }

    public Scene Scene { get; private set; }

    public Vector3d Velocity { get; }

    public Vector3d Spin { get; }

    /// <summary>A place where the ball overlaps nothing.</summary>
    public Vector3d FreePlace()
    {
        while (true)
        {
            Vector3d place = Place(3);
            if (Scene.Obstacles.All(item => item.Shape.At(place).Distance > 0.12)
                && Scene.Goals.SelectMany(goal => goal.Frame(Scene.Forces)).All(item => item.Shape.At(place).Distance > 0.12))
            {
                return place;
            }
        }
    }

    private Ground DrawGround()
    {
        Ground flat = _ground with { Material = _ground.Material with { ImpactFriction = _random.Next(2) == 0 ? double.PositiveInfinity : Range(0.1, 1.2) } };
        switch (_random.Next(3))
        {
            case 0:
                return flat;
            case 1:
                return flat with { Normal = new Vector3d(Range(-0.3, 0.3), 1, Range(-0.3, 0.3)) };
            default:
                double[,] values = new double[12, 12];
                for (int i = 0; i < 144; i++)
                {
                    values[i / 12, i % 12] = Range(0, 0.5);
                }

                return flat with { Heights = HeightField.FromControlValues(-11, -11, 2, values) };
        }
    }

    private Obstacle DrawObstacle(bool moves)
    {
        Vector3d at = Place(2);
        IShape shape = _random.Next(4) switch
        {
            0 => new SphereShape(at, Range(0.05, 0.6)),
            1 => new CapsuleShape(at, at + new Vector3d(Range(-1, 1), Range(0.1, 2), Range(-1, 1)), Range(0.03, 0.3)),
            2 => new BoxShape(at, new Vector3d(Range(0.05, 1), Range(0.05, 1), Range(0.05, 1)), Quaterniond.FromAxisAngle(Vector3d.Up, Range(0, 6))),
            _ => new PlaneShape(new Vector3d(0, 0, _random.Next(2) == 0 ? -12 : 14), new Vector3d(0, 0, _random.Next(2) == 0 ? 1 : -1)),
        };
        if (shape is PlaneShape plane)
        {
            shape = new PlaneShape(plane.Normal.Z > 0 ? new Vector3d(0, 0, -12) : new Vector3d(0, 0, 14), plane.Normal);
            moves = false;
        }

        return new Obstacle
        {
            Shape = shape,
            Velocity = moves ? new Vector3d(Range(-8, 8), 0, Range(-8, 8)) : default,
            Surface = SurfaceMaterial.GoalFrame with { NormalRestitution = Range(0, 0.95), TangentialRestitution = Range(-0.5, 0.9), ImpactFriction = Range(0, 1.2) },
        };
    }

    private Vector3d Place(double height) => new(Range(-9, 9), Range(0.7, 0.7 + height), Range(-9, 9));

    private double Range(double low, double high) => low + ((high - low) * _random.NextDouble());
}
