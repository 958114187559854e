using System.Diagnostics;
using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "In the net of a goal": shots that a goal's nets catch, until they rest.</summary>
internal static class NetTable
{
    private const int Shots = 60;

    /// <summary>The durations of a look-ahead and of a play, s.</summary>
    private const double Ahead = 3;
    private const double Longest = 6;

    /// <summary>The number of times that a step is timed; the shortest time counts.</summary>
    private const int Repeats = 5;

    public static IReadOnlyList<NetRow> Rows { get; } = [new("RK2", Integrator.Rk2), new("RK4", Integrator.Rk4)];

    /// <summary>Simulates and times the rows.</summary>
    public static void Print(Action<string> print, IReadOnlyList<NetRow> rows, double share)
    {
        print("");
        print("## In the net of a goal");
        print("");
        print($"{Shots} shots of 12 to 32 m/s, steps of 10 ms. A step is timed {Repeats} times, and the shortest counts. Lying: a ball at rest on the roof net. Error: the mean distance from steps of 0.05 ms with RK4, 0.3 s after the net is met. Targets: 2 µs, 6 µs at worst, and 150 µs for a look-ahead.");
        print("");
        print("| | µs a step | worst, µs | evaluations a step | most | lying, ns | look-ahead of 3 s, µs | error, m |");
        print("|---|--:|--:|--:|--:|--:|--:|--:|");
        foreach (NetRow row in rows)
        {
            Simulator simulator = row.Simulator();
            BallState[] shots = Caught(simulator);
            Workload flight = Workloads.Flight(new Scene(), row.Integrator, ShotSets.Fast);
            Workload lying = Lying(simulator);
            Workload ahead = LookAhead(simulator);
            Stopwatching.WarmUp([Play(simulator), flight, lying, ahead]);
            var net = new Net();
            Measure(simulator, shots, net);
            double rest = Stopwatching.Measure(lying, flight, 0.5 * share).Nanoseconds;
            double look = Stopwatching.Measure(ahead, flight, 0.5 * share).Nanoseconds;
            print(string.Create(CultureInfo.InvariantCulture, $"| {row.Name} | {Text.Number(1e6 * net.Seconds / net.Steps)} | {Text.Number(1e6 * net.Worst)} | {Text.Number((double)net.Evaluations / net.Steps)} | {net.Most} | {Text.Number(rest)} | {Text.Number(1e-3 * look)} | {Text.Number(Error(simulator, shots))} |"));
        }
    }

    private static void Measure(Simulator simulator, BallState[] shots, Net net)
    {
        var log = new StepLog();
        foreach (BallState shot in shots)
        {
            BallState state = shot;
            while (state.Time < Longest && state.Motion != MotionState.Rest)
            {
                bool counts = state.Nets != 0;
                double seconds = counts ? Time(simulator, in state) : 0;
                log.Clear();
                simulator.Step(ref state, ShotSets.TimeStep, log);
                if (counts)
                {
                    net.Steps++;
                    net.Seconds += seconds;
                    net.Worst = Math.Max(net.Worst, seconds);
                    net.Evaluations += log.Evaluations;
                    net.Most = Math.Max(net.Most, log.Evaluations);
                }
            }
        }
    }

    /// <summary>Simulates all shots to rest; the time is per step.</summary>
    public static Workload Play(Simulator simulator)
    {
        BallState[] shots = Caught(simulator);
        var log = new StepLog();
        int steps = 0;
        double Run()
        {
            double sum = 0;
            foreach (BallState shot in shots)
            {
                BallState state = shot;
                while (state.Time < Longest && state.Motion != MotionState.Rest)
                {
                    log.Clear();
                    simulator.Step(ref state, ShotSets.TimeStep, log);
                    steps++;
                }

                sum += state.Position.X;
            }

            return sum;
        }

        Run();
        return new Workload(Run, steps);
    }

    private static double Time(Simulator simulator, in BallState from)
    {
        var log = new StepLog();
        double least = double.PositiveInfinity;
        for (int i = 0; i < Repeats; i++)
        {
            long began = Stopwatch.GetTimestamp();
            for (int j = 0; j < Repeats; j++)
            {
                BallState state = from;
                simulator.Step(ref state, ShotSets.TimeStep, log);
            }

            least = Math.Min(least, Stopwatch.GetElapsedTime(began).TotalSeconds / Repeats);
            log.Clear();
        }

        return least;
    }

    /// <summary>Steps a ball that lies on the roof net.</summary>
    /// <exception cref="InvalidOperationException">The ball does not come to rest there.</exception>
    public static Workload Lying(Simulator simulator)
    {
        const int Steps = 1000;
        var log = new StepLog();
        BallState lying = simulator.Launch(new Vector3d(0, 2.8, -12.5), Vector3d.Zero, Vector3d.Zero);
        simulator.Run(ref lying, ShotSets.TimeStep, 10 * Longest, StopAt.Rest, log);
        return lying.Motion == MotionState.Rest && lying.Nets != 0
            ? new Workload(() => Batches.Chain(simulator, [lying], Steps, ShotSets.TimeStep, log), Steps)
            : throw new InvalidOperationException("The ball does not come to rest on the roof net.");
    }

    /// <summary>Computes look-aheads of the shots.</summary>
    public static Workload LookAhead(Simulator simulator)
    {
        BallState[] shots = Caught(simulator);
        var request = new LookAheadRequest { Duration = Ahead };
        var path = new Trajectory();
        return new Workload(
            () =>
            {
                foreach (BallState shot in shots)
                {
                    simulator.LookAhead(in shot, request, path);
                }

                return path.EndTime;
            },
            shots.Length);
    }

    /// <summary>Returns the mean error of the motion in the net: both methods of stepping start from the same state at the first contact.</summary>
    private static double Error(Simulator simulator, BallState[] shots)
    {
        const double For = 0.3;
        const double Fine = 5e-5;
        var exact = new Simulator(simulator.Scene, new SolverSettings { Integrator = Integrator.Rk4 });
        var log = new StepLog();
        double all = 0;
        foreach (BallState shot in shots)
        {
            BallState state = shot;
            while (state.Nets == 0)
            {
                simulator.Step(ref state, ShotSets.TimeStep, log);
                log.Clear();
            }

            BallState fine = state;
            simulator.Run(ref state, ShotSets.TimeStep, For, StopAt.Time, log);
            exact.Run(ref fine, Fine, For, StopAt.Time, log);
            log.Clear();
            all += (state.Position - fine.Position).Length;
        }

        return all / shots.Length;
    }

    /// <summary>Returns shots that a net of the goal catches.</summary>
    private static BallState[] Caught(Simulator simulator)
    {
        var random = new SeededRandom(64L);
        var log = new StepLog();
        var caught = new List<BallState>();
        while (caught.Count < Shots)
        {
            var from = new Vector3d(random.Uniform(-2, 2), 0.11, random.Uniform(-6, 0));
            Vector3d way = new Vector3d(random.Uniform(-3.3, 3.3), random.Uniform(0.2, 2.2), -12) - from;
            Vector3d velocity = (random.Uniform(12, 32) / way.Length * way) + new Vector3d(0, 1.5, 0);
            BallState shot = simulator.Launch(from, velocity, new Vector3d(random.Uniform(-30, 30), random.Uniform(-30, 30), random.Uniform(-30, 30)));
            BallState state = shot;
            while (state.Time < 1 && state.Nets == 0)
            {
                simulator.Step(ref state, ShotSets.TimeStep, log);
                log.Clear();
            }

            if (state.Nets != 0)
            {
                caught.Add(shot);
            }
        }

        return [.. caught];
    }

    private sealed class Net
    {
        public int Steps { get; set; }

        public double Seconds { get; set; }

        public double Worst { get; set; }

        public long Evaluations { get; set; }

        public long Most { get; set; }
    }
}
