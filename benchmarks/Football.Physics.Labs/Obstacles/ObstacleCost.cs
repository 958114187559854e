using System.Diagnostics;

namespace FootballPhysics.Labs.Obstacles;

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
