using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Things;

/// <summary>Steps of a ball between stationary surfaces: it rolls or slides along two planes, or spins on its spot between two or three.</summary>
public sealed class ContactSetStepTests
{
    private const double Radius = 0.11;
    private const int Kinds = 5;

    /// <summary>The path that an observer gets of a whole step passes through the middle of the step.</summary>
    [Fact]
    public void The_path_of_a_step_is_where_half_a_step_leads()
    {
        var random = new Random(31);
        int[] whole = new int[Kinds];
        for (int draw = 0; draw < 60 * Kinds; draw++)
        {
            int kind = draw % Kinds;
            (Scene scene, Vector3d position, Vector3d velocity, Vector3d spin) = Draw(random, kind);
            var simulator = new Simulator(scene);
            BallState half = simulator.Launch(position, velocity, spin);
            simulator.Step(ref half, 0.01, new StepLog());
            BallState end = half;
            var seen = new Pieces();
            simulator.Step(ref end, 0.02, new StepLog { Observer = seen });
            simulator.Step(ref half, 0.01, new StepLog());
            if (seen.All.Count == 1 && end.Motion == half.Motion)
            {
                whole[kind]++;
                Assert.InRange((seen.All[0].PositionAt(half.Time) - half.Position).Length, 0, 2e-8);
                Assert.InRange((seen.All[0].VelocityAt(half.Time) - half.Velocity).Length, 0, 2e-5);
            }
        }

        Assert.InRange(whole[0] + whole[1], 40, 120);
        Assert.InRange(whole[4], 20, 60);
    }

    /// <summary>Slips, rolls and loads that end within long steps end where short steps lead.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(4)]
    public void Long_steps_end_where_short_ones_lead(int kind)
    {
        var random = new Random(90 + kind);
        for (int draw = 0; draw < 60; draw++)
        {
            (Scene scene, Vector3d position, Vector3d velocity, Vector3d spin) = Draw(random, kind);
            var simulator = new Simulator(scene);
            BallState coarse = simulator.Launch(position, velocity, spin);
            BallState fine = coarse;
            simulator.Run(ref coarse, 0.1, 1.2, StopAt.Time, new StepLog());
            simulator.Run(ref fine, 0.002, 1.2, StopAt.Time, new StepLog());
            string at = FormattableString.Invariant($"draw {draw}: {coarse:R} for {fine:R}");
            Assert.True((coarse.Position - fine.Position).Length <= 3e-5, at);
            Assert.True((coarse.Velocity - fine.Velocity).Length <= 1e-4, at);
        }
    }

    private static (Scene Scene, Vector3d Position, Vector3d Velocity, Vector3d Spin) Draw(Random random, int kind)
    {
        double Any(double low, double high) => low + ((high - low) * random.NextDouble());
        SurfaceMaterial Material() => SurfaceMaterial.Board with
        {
            SlidingFriction = kind == 1 ? Any(0.5, 1.2) : Any(0.05, 0.7),
            RollingResistance = Any(0.01, 0.1),
            RollingResistancePerSpeed = Any(0, 0.01),
            SpinDamping = Any(0, 1e-4),
            TorsionalPatchRadius = Any(0, 0.02),
        };

        // Kinds: along a wall, in a gutter, on its spot at a wall, on its spot in a corner, in a slide along a wall.
        var up = new Vector3d(Any(-0.1, 0.1), 1, Any(-0.1, 0.1)).Normalized();
        double turn = Any(0, 2 * Math.PI);
        var aside = new Vector3d(Math.Cos(turn), Any(-0.2, 0.4), Math.Sin(turn));
        Vector3d wall = aside.Normalized();
        if (kind == 1)
        {
            double side = Any(0.3, 0.8);
            wall = ((Math.Cos(side) * up) + (Math.Sin(side) * new Vector3d(Math.Cos(turn), 0, Math.Sin(turn)))).Normalized();
            up = ((Math.Cos(side) * up) - (Math.Sin(side) * new Vector3d(Math.Cos(turn), 0, Math.Sin(turn)))).Normalized();
        }

        Vector3d along = Vector3d.Cross(up, wall).Normalized();
        double cosine = Vector3d.Dot(up, wall);
        Vector3d position = Radius / (1 + cosine) * (up + wall);
        double speed = kind is 0 or 1 or 4 ? Any(0.5, 6) * (random.Next(2) == 0 ? -1 : 1) : 0;
        double about = kind == 0 ? Any(-8, 8) : kind == 1 ? 0 : Any(10, 80) * (random.Next(2) == 0 ? -1 : 1);
        Vector3d spin = kind == 1
            ? speed / (Radius * (1 + cosine)) * Vector3d.Cross(up + wall, along)
            : (speed / Radius * Vector3d.Cross(up, along)) + (about * up);
        spin = kind == 4 ? random.Next(3) == 0 ? Vector3d.Zero : new Vector3d(Any(-40, 40), Any(-40, 40), Any(-40, 40)) : spin;
        var normals = new List<Vector3d> { up, wall };
        if (kind == 3)
        {
            normals.Add((along + (Any(-0.3, 0.6) * wall)).Normalized());
            position += (Radius - Vector3d.Dot(position, normals[2])) / Vector3d.Dot(along, normals[2]) * along;
        }

        // A wind that presses the ball onto the walls.
        Vector3d wind = (Any(0, 9) * -wall.Horizontal) - (kind == 3 ? Any(0, 9) * normals[2].Horizontal : Vector3d.Zero);
        var scene = new Scene { Air = new Air { Wind = wind.Horizontal }, Ground = Ground.None with { Aerodynamics = GroundAerodynamics.Full } };
        return (scene with { Obstacles = [.. normals.Select(n => new Obstacle { Name = "side", Shape = new PlaneShape(Vector3d.Zero, n), Surface = Material() })] }, position, speed * along, spin);
    }

    private sealed class Pieces : PieceObserver
    {
        public List<PathSegment> All { get; } = [];

        public override bool WantsEndAcceleration => true;

        public override bool Add(in PathSegment piece)
        {
            All.Add(piece);
            return false;
        }
    }
}
