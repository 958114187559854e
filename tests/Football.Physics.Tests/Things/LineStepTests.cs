using Football.Physics.Laws;

namespace Football.Physics.Tests.Things;

/// <summary>Whole steps of a ball between stationary surfaces, against the general law: a force of the game's own, which does nothing, leaves a scene to that.</summary>
public sealed class LineStepTests
{
    private const double Radius = 0.11;

    /// <summary>What the surfaces of a scene are.</summary>
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
        int[] whole = new int[4];
        for (int draw = 0; draw < 400; draw++)
        {
            int kind = draw % 4;
            (Scene scene, Vector3d position, Vector3d velocity, Vector3d spin) = Draw(random, of, kind);
            var settings = new SolverSettings { Integrator = integrator };
            var subject = new Simulator(scene, settings);
            var general = new Simulator(scene with { Forces = scene.Forces with { Custom = [IForce.From(_ => Vector3d.Zero)] } }, settings);
            BallState state = general.Launch(position, velocity, spin);
            double dt = 0.001 * random.Next(2, 20);
            for (int i = 0; i < 12; i++)
            {
                BallState line = state;
                var log = new StepLog();
                var generalLog = new StepLog();
                subject.Step(ref line, dt, log);
                general.Step(ref state, dt, generalLog);
                bool isWhole = log.Evaluations == stages && (generalLog.Evaluations > stages || kind == 0) && line.Motion == MotionState.Rolling;
                whole[kind] += isWhole ? 1 : 0;
                string at = FormattableString.Invariant($"draw {draw} kind {kind} step {i}: {line:R} for {state:R}");
                Assert.True(line.Motion == state.Motion, at);
                Assert.True(line.Carrier == state.Carrier, at);
                Assert.True((line.Position - state.Position).Length <= 1e-12, at);
                Assert.True((line.Velocity - state.Velocity).Length <= 1e-11, at);
                Assert.True((line.Spin - state.Spin).Length <= 1e-10, at);
                Assert.True(Cosine(line.Orientation, state.Orientation) >= 1 - 1e-14, at);
            }
        }

        foreach (int steps in whole)
        {
            Assert.InRange(steps, 200, int.MaxValue);
        }
    }

    private static double Cosine(Quaterniond a, Quaterniond b) => Math.Abs((a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W));

    private static (Scene Scene, Vector3d Position, Vector3d Velocity, Vector3d Spin) Draw(Random random, Of of, int kind)
    {
        double Any(double low, double high) => low + ((high - low) * random.NextDouble());
        SurfaceMaterial Material() => SurfaceMaterial.Board with
        {
            SlidingFriction = kind == 1 ? Any(0.5, 1.2) : Any(0.05, 0.7),
            RollingFriction = Any(0.01, 0.1),
            RollingFrictionBySpeed = Any(0, 0.01),
            SpinDamping = Any(0, 1e-4),
            DrillingLength = Any(0, 0.02),
        };

        // Kinds: along a wall, in a gutter, on its spot at a wall, on its spot in a corner.
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
        double speed = kind < 2 ? Any(0.5, 6) * (random.Next(2) == 0 ? -1 : 1) : 0;
        double about = kind == 0 ? Any(-8, 8) : kind == 1 ? 0 : Any(10, 80) * (random.Next(2) == 0 ? -1 : 1);
        Vector3d spin = kind == 1
            ? speed / (Radius * (1 + cosine)) * Vector3d.Cross(up + wall, along)
            : (speed / Radius * Vector3d.Cross(up, along)) + (about * up);
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
                var bodies = new Bodies();
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
}
