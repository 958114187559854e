using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Obstacles;

/// <summary>Shots at a post that all should hit it: the number that pass through, and the error of the others' rebound.</summary>
/// <param name="Passed">The number that passed through.</param>
/// <param name="Mean">The mean error of the rebound's direction, over the shots that hit, degrees.</param>
/// <param name="Worst">The largest error, degrees.</param>
internal sealed record PostShots(int Passed, double Mean, double Worst)
{
    private const double BallRadius = 0.11;
    private const double PostRadius = 0.06;
    private const double Reach = BallRadius + PostRadius;

    /// <summary>The distance of the post, m.</summary>
    private const double Away = 5;

    private const double Restitution = 0.7;

    private static readonly Vector3d s_post = new(0, 0, -Away);

    /// <summary>Shoots with the method of a rigid-body engine.</summary>
    public static PostShots ByEngine(SeededRandom random, int shots, double speed, double step) => Measure(random, shots, speed, (from, velocity) => EngineShot(from, velocity, step));

    /// <summary>Shoots with the library.</summary>
    public static PostShots Here(SeededRandom random, int shots, double speed, double step)
    {
        var post = new Obstacle
        {
            Shape = new CapsuleShape(s_post - new Vector3d(0, 9, 0), s_post + new Vector3d(0, 9, 0), PostRadius),
            Surface = SurfaceMaterial.PublishedGoalFrame with { NormalRestitution = Restitution, ImpactFriction = 0 },
        };
        var simulator = new Simulator(Scene.Vacuum with { Obstacles = [post], Ground = Ground.None, Gravity = 0 });
        var log = new StepLog();
        return Measure(random, shots, speed, (from, velocity) =>
        {
            BallState state = simulator.Launch(from, velocity, Vector3d.Zero);
            log.Clear();
            for (double time = 0; time * speed < 2 * Away; time += step)
            {
                simulator.Step(ref state, step, log);
            }

            return state.Velocity;
        });
    }

    private static PostShots Measure(SeededRandom random, int shots, double speed, Func<Vector3d, Vector3d, Vector3d> play)
    {
        int passed = 0;
        double sum = 0;
        double worst = 0;
        for (int i = 0; i < shots; i++)
        {
            // Off the post's axis by up to nine tenths of the reach; the start is random within a step.
            var from = new Vector3d(random.Uniform(-0.9, 0.9) * Reach, 0, random.Next());
            var velocity = new Vector3d(0, 0, -speed);
            Vector3d after = play(from, velocity);
            if (after == velocity)
            {
                passed++;
                continue;
            }

            // v − (1 + e)(v·n) n, if the centre comes within both radii of the axis.
            double x = from.X / Reach;
            var normal = new Vector3d(x, 0, Math.Sqrt(1 - (x * x)));
            Vector3d exact = velocity - ((1 + Restitution) * Vector3d.Dot(in velocity, in normal) * normal);
            double sine = Vector3d.Cross(in after, in exact).Length;
            double angle = Math.Atan2(sine, Vector3d.Dot(in after, in exact)) * 180 / Math.PI;
            sum += angle;
            worst = Math.Max(worst, angle);
        }

        return new PostShots(passed, passed < shots ? sum / (shots - passed) : 0, worst);
    }

    private static Vector3d EngineShot(Vector3d from, Vector3d velocity, double step)
    {
        var engine = new RigidBodyEngine { Gravity = 0, LinearDamping = 0, AngularDamping = 0 };
        var state = new PlainState { Position = new PlainVector(from.X, 100, from.Z), Velocity = new PlainVector(velocity.X, 0, velocity.Z) };
        double speed = velocity.Length;
        for (double time = 0; time * speed < 2 * Away; time += step)
        {
            engine.Step(ref state, step);
            double x = state.Position.X - s_post.X;
            double z = state.Position.Z - s_post.Z;
            double distance = Math.Sqrt((x * x) + (z * z));
            if (distance < Reach && distance > 0)
            {
                // The contact is found at the end of the frame; push the ball out and resolve the impact there.
                (double nx, double nz) = (x / distance, z / distance);
                state.Position = new PlainVector(s_post.X + (Reach * nx), 100, s_post.Z + (Reach * nz));
                double closing = (state.Velocity.X * nx) + (state.Velocity.Z * nz);
                double change = closing < 0 ? (1 + Restitution) * closing : 0;
                state.Velocity = new PlainVector(state.Velocity.X - (change * nx), 0, state.Velocity.Z - (change * nz));
            }
        }

        return new Vector3d(state.Velocity.X, 0, state.Velocity.Z);
    }
}
