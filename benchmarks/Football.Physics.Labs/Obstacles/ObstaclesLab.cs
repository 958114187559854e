using System.Diagnostics;

namespace FootballPhysics.Labs.Obstacles;

/// <summary>football lab obstacles: the cost and accuracy of hits, compared with the method of a rigid-body engine.</summary>
internal static class ObstaclesLab
{
    private const int Shots = 2000;

    private static readonly double[] s_speeds = [10, 20, 40, 60, 100];
    private static readonly double[] s_steps = [1.0 / 120, 1.0 / 60, 1.0 / 30];

    public static Lab Create() => new Lab(
        "obstacles",
        "Obstacles compared with a rigid-body engine: cost by their number, shots that tunnel through a post, and the error of a rebound.",
        ["football lab obstacles --quick"]).PlaysQuick(Run);

    private static void Run(LabRun run, bool quick)
    {
        int shots = quick ? Shots / 20 : Shots;
        run.Progress.Report(0, 3, () => "cost");
        ObstacleCost.Measure(run, quick);
        run.Progress.Report(1, 3, () => "a post");
        LabTable passing = run.Table(
            $"{shots} shots at a post of 6 cm radius: passed through, and how far off the direction of the rebound is, mean and worst, degrees",
            "speed, m/s", "step, ms", "engine: passed", "engine: mean", "engine: worst", "here: passed", "here: mean", "here: worst", "verdict");
        foreach (double speed in s_speeds)
        {
            foreach (double step in s_steps)
            {
                PostShots engine = PostShots.ByEngine(run.Random(13), shots, speed, step);
                PostShots here = PostShots.Here(run.Random(13), shots, speed, step);
                bool holds = here.Passed == 0 && here.Worst < 1e-5;
                run.Failed |= !holds;
                passing.Add(speed, 1e3 * step, $"{100.0 * engine.Passed / shots:0.0} %", engine.Mean, engine.Worst, $"{100.0 * here.Passed / shots:0.0} %", here.Mean, here.Worst, holds ? "holds" : "FAILED");
            }
        }

        run.Progress.Report(2, 3, () => "drops");
        LabTable drops = run.Table("Drops from 0.5 to 1.5 m on a board of restitution 0.6: the restitution that comes out, √(height after/height before)", "step, ms", "engine: least", "engine: greatest", "here: least", "here: greatest", "verdict");
        foreach (RigidBodyRebound engine in RigidBodyEngineReport.Measure().Rebounds)
        {
            (double least, double greatest) = BoardDrops.Measure(engine.TimeStep, quick ? 20 : 200);
            bool holds = least > 0.6 - 1e-9 && greatest < 0.6 + 1e-9;
            run.Failed |= !holds;
            drops.Add(1e3 * engine.TimeStep, engine.Least, engine.Greatest, least, greatest, holds ? "holds" : "FAILED");
        }

        run.Notes.Add("The engine's method: symplectic Euler; it finds contacts at the ball's position at the end of a frame, and pushes out and resolves them there. The test is in vacuum, without friction, so that only the time and position of the contact matter.");
    }
}

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

/// <summary>Measures the time of a flight step by the number of obstacles, compared with an empty pitch.</summary>
internal static class ObstacleCost
{
    private const double Step = 0.01;
    private const int Steps = 60;
    private const int Balls = 64;

    /// <summary>Adds the table: objects of up to 2 m on a pitch, and balls that fly over them, and among them.</summary>
    public static void Measure(LabRun run, bool quick)
    {
        LabTable table = run.Table("Time of a flight step (RK2, 10 ms) among posts on a pitch, ns, and as a multiple of that over an empty pitch", "posts", "over them", "over them, times", "among them", "among them, times", "hits a flight");
        double empty = 0;
        foreach (int count in (int[])[0, 1, 10, 100, 1000])
        {
            Simulator simulator = WithPosts(run.Random(7), count);
            (double high, _) = Time(simulator, run.Random(11), 8, quick ? 3 : 40);
            (double low, double hits) = Time(simulator, run.Random(11), 1, quick ? 3 : 40);
            empty = count == 0 ? high : empty;
            table.Add(count, high, high / empty, low, low / empty, hits);
        }
    }

    private static Simulator WithPosts(SeededRandom random, int count)
    {
        Obstacle[] posts = [.. Enumerable.Range(0, count).Select(_ =>
        {
            var foot = new Vector3d(random.Uniform(-34, 34), 0, random.Uniform(-52, 52));
            return new Obstacle { Shape = new CapsuleShape(foot, foot + new Vector3d(0, 2, 0), 0.06) };
        })];
        return new Simulator(Scene.Published with { Obstacles = posts }, new SolverSettings { Integrator = Integrator.Rk2 });
    }

    /// <summary>Returns the least time of a step over several rounds, ns, and the hits per flight.</summary>
    private static (double Nanoseconds, double Hits) Time(Simulator simulator, SeededRandom random, double height, int rounds)
    {
        BallState[] launched = [.. Enumerable.Range(0, Balls).Select(_ =>
        {
            Vector3d velocity = random.Velocity(15, 28, 5, 15);
            return simulator.Launch(new Vector3d(random.Uniform(-20, 20), height, random.Uniform(-40, 40)), velocity, 30 * random.Direction());
        })];
        var log = new StepLog();
        double best = double.PositiveInfinity;
        int hits = 0;
        for (int round = 0; round < rounds; round++)
        {
            BallState[] states = [.. launched];
            hits = 0;
            long start = Stopwatch.GetTimestamp();
            for (int i = 0; i < states.Length; i++)
            {
                log.Clear();
                for (int k = 0; k < Steps; k++)
                {
                    simulator.Step(ref states[i], Step, log);
                }

                hits += log.Events.Count;
            }

            best = Math.Min(best, Stopwatch.GetElapsedTime(start).TotalNanoseconds);
        }

        return (best / (Balls * Steps), (double)hits / Balls);
    }
}

/// <summary>Drops on a board in vacuum.</summary>
internal static class BoardDrops
{
    private const double Radius = 0.11;

    /// <summary>Returns the least and the greatest measured restitution.</summary>
    /// <param name="step">The time step, s.</param>
    /// <param name="drops">The number of heights.</param>
    public static (double Least, double Greatest) Measure(double step, int drops)
    {
        var board = new Obstacle { Shape = new BoxShape(new Vector3d(0, 1, 0), new Vector3d(1, 0.1, 1)), Surface = SurfaceMaterial.PublishedGoalFrame with { NormalRestitution = 0.6 } };
        var simulator = new Simulator(Scene.Vacuum with { Obstacles = [board], Ground = Ground.None });
        var request = new LookAheadRequest { Duration = 1, TimeStep = step, StopAt = StopAt.Impact };
        double[] all = [.. Enumerable.Range(0, drops + 1).Select(i =>
        {
            double height = 0.5 + ((double)i / drops);
            BallState state = simulator.Launch(new Vector3d(0, 1.1 + Radius + height, 0), Vector3d.Zero, Vector3d.Zero);
            var path = new Trajectory();
            simulator.LookAhead(in state, request, path);
            simulator.LookAhead(path.Final, request, path);
            return Math.Sqrt((path.Apex - 1.1 - Radius) / height);
        })];
        return (all.Min(), all.Max());
    }
}
