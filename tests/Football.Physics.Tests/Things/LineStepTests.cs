using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Things;

/// <summary>Whole steps of a ball between stationary surfaces, against the general law: a force of the game's own, which does nothing, leaves a scene to that.</summary>
public sealed class LineStepTests
{
    private const double Radius = 0.11;
    private const int Kinds = 5;

    /// <summary>Kinds of surfaces of a scene.</summary>
    public enum Of
    {
        /// <summary>Obstacles.</summary>
        Obstacles,

        /// <summary>Bodies that stand.</summary>
        Bodies,

        /// <summary>Colliders of an engine.</summary>
        Colliders,
    }

    /// <summary>Balls that roll along two tilted planes, stick to both, or spin on their spot between two or three, in any wind.</summary>
    [Theory]
    [InlineData(Of.Obstacles, Integrator.Rk4)]
    [InlineData(Of.Obstacles, Integrator.Rk2)]
    [InlineData(Of.Bodies, Integrator.Rk4)]
    [InlineData(Of.Colliders, Integrator.Rk4)]
    public void Steps_end_where_the_general_law_leads(Of of, Integrator integrator)
    {
        var random = new Random(20 + (int)of);
        long stages = integrator == Integrator.Rk4 ? 4 : 2;
        int[] whole = new int[Kinds];
        for (int draw = 0; draw < 100 * Kinds; draw++)
        {
            int kind = draw % Kinds;
            (Scene scene, Vector3d position, Vector3d velocity, Vector3d spin) = Draw(random, of, kind);
            var settings = new SolverSettings { Integrator = integrator };
            var subject = new Simulator(scene, settings);
            var general = new Simulator(Generally(scene), settings);
            BallState state = general.Launch(position, velocity, spin);
            double dt = 0.001 * random.Next(2, 20);
            for (int i = 0; i < 12; i++)
            {
                (long taken, long asked) = Compare(subject, general, ref state, dt, FormattableString.Invariant($"draw {draw}, kind {kind}, step {i}"));
                MotionState motion = kind == 4 ? MotionState.Sliding : MotionState.Rolling;
                whole[kind] += taken == stages && (asked > stages || kind is 0 or 4) && state.Motion == motion ? 1 : 0;
            }
        }

        foreach (int steps in whole)
        {
            Assert.InRange(steps, 200, int.MaxValue);
        }
    }

    /// <summary>A board that stands on turf of two materials, and ends: the ball rolls or slides along it, beyond the border and the end.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Steps_along_a_board_end_with_its_face_and_its_ground(bool rolls)
    {
        var random = new Random(7);
        int whole = 0;
        for (int draw = 0; draw < 60; draw++)
        {
            double Any(double low, double high) => low + ((high - low) * random.NextDouble());
            var strip = new SurfaceRectangles((new Vector3d(-1, 0, -2), new Vector3d(1, 0, -1), SurfaceMaterial.DryTurf));
            var scene = new Scene
            {
                Air = new Air { Wind = new Vector3d(Any(2, 8), 0, Any(-3, 3)) },
                Ground = new Ground { Pattern = strip },
                Obstacles = [new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0.16, 0.5, 0), new Vector3d(0.05, 0.5, 3)), Surface = SurfaceMaterial.Board }],
            };
            var subject = new Simulator(scene);
            var general = new Simulator(Generally(scene));
            double speed = Any(1, 7);
            Vector3d spin = rolls ? new Vector3d(-speed / Radius, Any(-9, 9), 0) : new Vector3d(Any(-20, 20), Any(-20, 20), Any(-20, 20));
            BallState state = general.Launch(new Vector3d(0, Radius, Any(-0.5, 0.5)), new Vector3d(0, 0, -speed), spin);
            for (int i = 0; i < 80 && Math.Abs(state.Position.X) <= 1e-9; i++)
            {
                // Off the board, the whole steps on flat ground differ by the error of the method.
                (long taken, _) = Compare(subject, general, ref state, 0.01, FormattableString.Invariant($"draw {draw}, step {i}"), 1e4);
                whole += taken == 4 && state.Position.Z > -3 ? 1 : 0;
            }
        }

        Assert.InRange(whole, 600, int.MaxValue);
    }

    /// <summary>The path that an observer gets of a whole step passes through the middle of the step.</summary>
    [Fact]
    public void The_path_of_a_step_is_where_half_a_step_leads()
    {
        var random = new Random(31);
        int[] whole = new int[Kinds];
        for (int draw = 0; draw < 60 * Kinds; draw++)
        {
            int kind = draw % Kinds;
            (Scene scene, Vector3d position, Vector3d velocity, Vector3d spin) = Draw(random, Of.Obstacles, kind);
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
            (Scene scene, Vector3d position, Vector3d velocity, Vector3d spin) = Draw(random, Of.Obstacles, kind);
            foreach (Scene one in new[] { scene, Generally(scene) })
            {
                var simulator = new Simulator(one);
                BallState coarse = simulator.Launch(position, velocity, spin);
                BallState fine = coarse;
                simulator.Run(ref coarse, 0.1, 1.2, StopAt.Time, new StepLog());
                simulator.Run(ref fine, 0.002, 1.2, StopAt.Time, new StepLog());
                string at = FormattableString.Invariant($"draw {draw}: {coarse:R} for {fine:R}");
                Assert.True((coarse.Position - fine.Position).Length <= 3e-5, at);
                Assert.True((coarse.Velocity - fine.Velocity).Length <= 1e-4, at);
            }
        }
    }

    /// <summary>The same scene with a force that does nothing.</summary>
    private static Scene Generally(Scene scene) => scene with { Forces = scene.Forces with { CustomForces = [IForce.From(_ => Vector3d.Zero)] } };

    /// <summary>Takes a step from one state by both, and compares the ends.</summary>
    /// <param name="subject">Takes whole steps.</param>
    /// <param name="general">Takes pieces.</param>
    /// <param name="state">The state.</param>
    /// <param name="dt">Length of the step, s.</param>
    /// <param name="when">For messages.</param>
    /// <param name="inPieces">How much farther a step in several pieces may be off.</param>
    /// <returns>The evaluations of each.</returns>
    private static (long Taken, long Asked) Compare(Simulator subject, Simulator general, ref BallState state, double dt, string when, double inPieces = 1)
    {
        BallState line = state;
        var log = new StepLog();
        var generalLog = new StepLog();
        subject.Step(ref line, dt, log);
        general.Step(ref state, dt, generalLog);
        string at = FormattableString.Invariant($"{when}: {line:R} for {state:R}");
        Assert.True(line.Motion == state.Motion, at);
        Assert.True(line.Carrier == state.Carrier, at);
        double within = generalLog.Steps > 1 ? inPieces : 1;
        Assert.True((line.Position - state.Position).Length <= within * 1e-12, at);
        Assert.True((line.Velocity - state.Velocity).Length <= within * 1e-11, at);
        Assert.True((line.Spin - state.Spin).Length <= within * 1e-10, at);
        Assert.True(Cosine(line.Orientation, state.Orientation) >= 1 - (within * 1e-14), at);
        return (log.Evaluations, generalLog.Evaluations);
    }

    private static double Cosine(Quaterniond a, Quaterniond b) => Math.Abs((a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W));

    private static (Scene Scene, Vector3d Position, Vector3d Velocity, Vector3d Spin) Draw(Random random, Of of, int kind)
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
        switch (of)
        {
            case Of.Obstacles:
                return (scene with { Obstacles = [.. normals.Select(n => new Obstacle { Name = "side", Shape = new PlaneShape(Vector3d.Zero, n), Surface = Material() })] }, position, speed * along, spin);
            case Of.Bodies:
                var bodies = new KinematicBodies();
                foreach (Vector3d n in normals)
                {
                    bodies.Add("side", new PlaneShape(Vector3d.Zero, n), Material());
                }

                return (scene with { Bodies = bodies }, position, speed * along, spin);
            default:
                var engine = new ShapesAsEngine();
                foreach (Vector3d n in normals)
                {
                    engine.Add("side", new PlaneShape(Vector3d.Zero, n));
                }

                return (scene with { EngineColliders = engine }, position, speed * along, spin);
        }
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
