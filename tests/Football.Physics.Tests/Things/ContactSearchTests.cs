using FootballPhysics.Contacts;
using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Things;

/// <summary>The time of impact on paths that bend, against looking at every thing at four thousand places of the path.</summary>
public sealed class ContactSearchTests
{
    private const double Radius = 0.11;
    private const int Samples = 4000;

    /// <summary>The end of a path, whoever made it.</summary>
    private struct Ended : ISweep
    {
        public double Length { get; init; }

        public Vector3d Position { get; init; }

        public Vector3d Velocity { get; init; }

        public readonly Vector3d StartAcceleration => default;

        public int Evaluations { get; set; }

        public readonly void Step(double h)
        {
        }

        public readonly void Nudge(double dt)
        {
        }

        public readonly Vector3d EndAcceleration() => default;

        public readonly void MoveTo(ref BallState s)
        {
        }
    }

    public static TheoryData<string> Kinds() => ["hills", "flat", "still", "moving"];

    [Theory]
    [MemberData(nameof(Kinds))]
    public void The_first_thing_on_a_path_is_met_where_dense_samples_meet_it(string kind)
    {
        var random = new Random(kind.Length + 60);
        Vector3d Any(double size) => size * new Vector3d(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);
        int met = 0;
        int free = 0;
        for (int i = 0; i < 150; i++)
        {
            World world = WorldOf(kind, random, Any);
            double time = 0.3 + random.NextDouble();
            double length = 0.02 + (0.25 * random.NextDouble());
            var from = new Vector3d(4 * (random.NextDouble() - 0.5), 0.3 + (1.5 * random.NextDouble()), 4 * (random.NextDouble() - 0.5));
            Vector3d velocity = Any(30);
            var sweep = new Ended { Length = length, Position = from + (length * (velocity + Any(12))), Velocity = velocity + Any(40) };
            var path = PathCubic.Between(in from, in velocity, sweep.Position, sweep.Velocity, length, isQuadratic: i % 2 == 0);
            BallState state = default;
            state.Position = from;
            state.Velocity = velocity;
            state.Time = time;
            state.Motion = MotionState.Airborne;
            if (Gap(world, path.At(0), time, out _) < 1e-6)
            {
                continue;
            }

            double found = new ContactSearch(world, in path, time).First(in state, -1, out Separation first);
            double dt = length / Samples;
            int sampled = -1;
            for (int k = 0; k <= Samples && sampled < 0; k++)
            {
                double gap = Gap(world, path.At(k * dt), time + (k * dt), out int thing);
                sampled = gap < -1e-9 ? k : -1;
            }

            string what = $"{kind} {i}: found {found}, sampled {sampled * dt} of {length}";
            if (found <= length)
            {
                met++;

                // It touches what is told, comes closer to it, and was in nothing before.
                double within = 1e-9 + (path.VelocityAt(found).Length + 20) * 1e-7 * length;
                Assert.InRange(Gap(world, path.At(found), time + found, out _), -within, within);
                Collider told = world.Colliders[first.Index];
                Assert.InRange(told.At(path.At(found), time + found).Distance - Radius, -within, within);
                Assert.True(sampled < 0 || (sampled * dt) >= found - (2e-7 * length) - 1e-9, what);
                Assert.True(sampled >= 0 && (sampled - 1) * dt <= found + (2 * dt) || Shallow(world, in path, time, found, dt), what);
            }
            else
            {
                free++;
                Assert.True(sampled < 0, what);
            }
        }

        Assert.True(met > 30 && free > 20, $"{met} met, {free} free");
    }

    /// <summary>In a hollow, a straight path ends where the ball touches the sphere from the inside: |p₀ + v t − c| = R − r, however flat it meets the wall.</summary>
    [Theory]
    [InlineData(0.25)]
    [InlineData(0.4)]
    [InlineData(3)]
    public void A_hollow_is_met_where_the_circle_says(double hollow)
    {
        var center = new Vector3d(0.3, 2, -0.7);
        World world = new Simulator(new Scene
        {
            Ball = new BallProperties { Radius = Radius },
            Ground = Ground.None,
            Obstacles = [new Obstacle { Shape = new Hollow(center, hollow) }],
        }).World!;
        var random = new Random(90);
        Vector3d Any() => new((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
        for (int i = 0; i < 200; i++)
        {
            // From near the wall, and along it, or from anywhere.
            double depth = (hollow - Radius) * (i % 2 == 0 ? 1 - (0.05 * random.NextDouble()) : random.NextDouble());
            Vector3d n = Any().Normalized();
            Vector3d from = center + (depth * n);
            Vector3d velocity = Any() * 10;
            velocity -= i % 2 == 0 ? 0.98 * Vector3d.Dot(velocity, n) * n : Vector3d.Zero;
            double b = Vector3d.Dot(from - center, velocity);
            double c = (from - center).LengthSquared - ((hollow - Radius) * (hollow - Radius));
            double expected = (-b + Math.Sqrt((b * b) - (velocity.LengthSquared * c))) / velocity.LengthSquared;
            var path = PathCubic.Line(in from, in velocity, 2 * expected);
            BallState state = new() { Position = from, Velocity = velocity, Motion = MotionState.Airborne };
            Assert.Equal(expected, new ContactSearch(world, in path, 0).First(in state, -1, out _), 3e-7 * expected);
        }
    }

    /// <summary>The inside of a sphere.</summary>
    private sealed class Hollow(Vector3d center, double radius) : IShape
    {
        public double MaximumConcaveCurvature => 1 / radius;

        public Bounds3d Bounds => new(center - new Vector3d(9, 9, 9), center + new Vector3d(9, 9, 9));

        public ShapePoint At(in Vector3d point)
        {
            Vector3d off = point - center;
            double distance = off.Length;
            Vector3d n = distance > 0 ? -off / distance : Vector3d.Up;
            return new ShapePoint(radius - distance, in n, SymmetricMatrix3d.AroundPoint(in n, -Math.Max(distance, 1e-9)));
        }
    }

    /// <summary>Between two samples a ball may touch and leave again.</summary>
    private static bool Shallow(World world, in PathCubic path, double time, double found, double dt)
    {
        double least = double.PositiveInfinity;
        for (double t = found; t < Math.Min(path.Length, found + (2 * dt)); t += 0.01 * dt)
        {
            least = Math.Min(least, Gap(world, path.At(t), time + t, out _));
        }

        return least > -1e-4;
    }

    private static double Gap(World world, Vector3d place, double time, out int thing)
    {
        double least = double.PositiveInfinity;
        thing = -1;
        for (int i = 0; i < world.Colliders.Length; i++)
        {
            double gap = world.Colliders[i].At(in place, time).Distance - Radius;
            thing = gap < least ? i : thing;
            least = Math.Min(least, gap);
        }

        return least;
    }

    private static World WorldOf(string kind, Random random, Func<double, Vector3d> any)
    {
        Ground ground = Ground.Of(SurfaceMaterial.DryTurf);
        if (kind == "hills")
        {
            double[,] heights = new double[12, 12];
            for (int i = 0; i < 12; i++)
            {
                for (int j = 0; j < 12; j++)
                {
                    heights[i, j] = 0.22 * random.NextDouble();
                }
            }

            ground = ground with { Heights = HeightField.FromControlValues(-3, -3, 0.55, heights) };
        }

        bool moves = kind == "moving";
        bool flat = kind == "flat";
        Obstacle Made(string name, IShape shape) => new() { Name = name, Shape = shape, Velocity = moves ? any(10) : default, Spin = moves ? any(12) : default, Pivot = moves ? any(2) : default };
        Vector3d Place() => new(5 * (random.NextDouble() - 0.5), 0.2 + random.NextDouble(), 5 * (random.NextDouble() - 0.5));
        Vector3d at = Place();
        return new Simulator(new Scene
        {
            Ball = new BallProperties { Radius = Radius },
            Ground = ground,
            Obstacles = flat
                ? [new Obstacle { Name = "ramp", Shape = new PlaneShape(new Vector3d(0, -1, 0), new Vector3d(0.3, 1, -0.2).Normalized()) }]
                : [Made("sphere", new SphereShape(Place(), 0.3)), Made("post", new CapsuleShape(at, at + any(3), 0.06)), Made("box", new BoxShape(Place(), new Vector3d(0.4, 0.2, 0.1)))],
        }).World!;
    }
}
