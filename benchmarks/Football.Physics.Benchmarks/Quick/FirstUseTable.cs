using System.Diagnostics;
using System.Globalization;

namespace Football.Physics.Benchmarks;

/// <summary>What is used for the first time in a process, cold and after it was warmed up: each in a process of its own.</summary>
internal static class FirstUseTable
{
    public const string Name = "First use";
    private const int Rounds = 5;
    private const int Balls = 64;
    private const int Loading = 250;
    private const int WarmUps = 2;

    private static readonly string[] s_names =
    [
        "a simulator is made, ms", "warming up, ms", "first flight, ms", "first impact, ms", "first slide and roll, ms", "first look-ahead, ms", "first `Find`, ms",
        "many balls, first call, µs a ball", "many balls, second call, µs a ball", "many balls, sixth call, µs a ball",
    ];

    /// <summary>Measures in other processes.</summary>
    public static void Print(Action<string> print)
    {
        double[][] cold = Runs(warm: false);
        double[][] warm = Runs(warm: true);
        print("");
        print($"## {Name}");
        print("");
        print($"The first time of each in a process, one after the other: median of {Rounds} processes. Warm: after `Simulator.WarmUp()`, `Aimer.WarmUp()` and `BallBatch.WarmUp()`, called {WarmUps} times with {Loading} ms of other loading after each; the row is of the first call. Slide and roll: the slowest of the first steps from each motion to each.");
        print("");
        print("| | cold | warm |");
        print("|---|--:|--:|");
        for (int i = 0; i < s_names.Length; i++)
        {
            print(string.Create(CultureInfo.InvariantCulture, $"| {s_names[i]} | {Median(cold, i):0.00} | {Median(warm, i):0.00} |"));
        }
    }

    /// <summary>The measurement itself, in a fresh process.</summary>
    public static string Measure(bool warm)
    {
        var values = new List<double>();
        long start = Stopwatch.GetTimestamp();
        void Lap()
        {
            values.Add(Stopwatch.GetElapsedTime(start).TotalMilliseconds);
            start = Stopwatch.GetTimestamp();
        }

        var simulator = new Simulator();
        Lap();
        var aimer = new Aimer();
        var batch = new BallBatch(Scene.Published);
        var launches = new BatchLaunches(Balls);
        var flights = new BatchFlights(Balls);
        for (int i = 0; i < Balls; i++)
        {
            launches.Velocity[i] = new Vector3d(0, 4 + (0.1 * i), -20);
        }

        void WarmUp()
        {
            simulator.WarmUp();
            aimer.WarmUp();
            batch.WarmUp();
        }

        start = Stopwatch.GetTimestamp();
        if (warm)
        {
            WarmUp();
        }

        Lap();
        for (int i = 1; warm && i <= WarmUps; i++)
        {
            // As the rest of a level's loading would: what runs often is being compiled again meanwhile, on another thread.
            Thread.Sleep(Loading);
            if (i < WarmUps)
            {
                WarmUp();
            }
        }

        var ball = new Ball(simulator);
        var path = new Trajectory();
        start = Stopwatch.GetTimestamp();
        ball.Kick(new Vector3d(1, 6, -20), new Vector3d(0, 20, 0));
        ball.Step(0.01);
        Lap();
        while (ball.Events.Count == 0)
        {
            start = Stopwatch.GetTimestamp();
            ball.Step(0.01);
        }

        Lap();
        double slowest = 0;
        var seen = new HashSet<(MotionState, MotionState)>();
        while (ball.Motion != MotionState.Stopped)
        {
            MotionState before = ball.Motion;
            start = Stopwatch.GetTimestamp();
            ball.Step(0.01);
            double time = Stopwatch.GetElapsedTime(start).TotalMilliseconds;
            slowest = seen.Add((before, ball.Motion)) ? Math.Max(slowest, time) : slowest;
        }

        values.Add(slowest);
        ball.Kick(new Vector3d(1, 6, -20), new Vector3d(0, 20, 0));
        start = Stopwatch.GetTimestamp();
        simulator.LookAhead(ball.State, new LookAheadRequest(), path);
        Lap();
        aimer.Find(new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(2, 1.5, -20) });
        Lap();
        for (int call = 1; call <= 6; call++)
        {
            start = Stopwatch.GetTimestamp();
            batch.Fly(launches, flights, Balls);
            if (call is 1 or 2 or 6)
            {
                values.Add(Stopwatch.GetElapsedTime(start).TotalMicroseconds / Balls);
            }
        }

        return string.Join(' ', values.Select(value => value.ToString(CultureInfo.InvariantCulture)));
    }

    private static double[][] Runs(bool warm) =>
    [
        .. Enumerable.Range(0, Rounds).Select(_ => Child.Run(new Dictionary<string, string>(), "quick", "--child", "first", warm ? "1" : "0")
            .Split(' ').Select(value => double.Parse(value, CultureInfo.InvariantCulture)).ToArray()),
    ];

    private static double Median(double[][] runs, int i) => runs.Select(run => run[i]).Order().ElementAt(Rounds / 2);
}
