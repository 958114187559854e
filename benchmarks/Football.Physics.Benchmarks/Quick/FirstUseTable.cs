using System.Diagnostics;
using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>The first uses of features in a process, cold and after a warm-up: each in a process of its own.</summary>
internal static class FirstUseTable
{
    public const string Name = "First use";
    private const int Rounds = 5;
    private const int Balls = 64;
    private const int Loading = 250;
    private const int WarmUps = 2;

    /// <summary>The timed uses, and the target without a warm-up call, ms.</summary>
    private static readonly (string Name, double? Target)[] s_rows =
    [
        ("`new Ball()`, ms", 10), ("warming up, ms", null), ("first step, ms", 2), ("first impact, ms", 2), ("first slide, ms", 2), ("first roll, ms", 2), ("first look-ahead, ms", 2),
        ("first `Find`, ms", null), ("many balls, first call, µs a ball", null), ("many balls, second call, µs a ball", null), ("many balls, sixth call, µs a ball", null),
    ];

    /// <summary>Prints the times without packages, whose code is compiled just in time.</summary>
    public static void JustInTime(Action<string> print)
    {
        print("");
        print($"## {Name}, compiled just in time");
        print("");
        Print(print);
    }

    /// <summary>Measures in other processes.</summary>
    public static void Print(Action<string> print)
    {
        double[][] cold = Runs(warm: false);
        double[][] warm = Runs(warm: true);
        print($"The first call of each in a process, one after the other: the median of {Rounds} processes. Warm: after `Simulator.WarmUp()`, `Aimer.WarmUp()` and `BallBatch.WarmUp()`, called {WarmUps} times with {Loading} ms of other loading after each; the row is the first call. The scene is the default. Slide and roll: the slowest of the first steps into, during and out of that motion. Reach: cold.");
        print("");
        print("| | cold | reach | | warm |");
        print("|---|--:|--:|---|--:|");
        for (int i = 0; i < s_rows.Length; i++)
        {
            (string name, double? target) = s_rows[i];
            string verdict = target is null ? "" : Median(cold, i) <= target ? "reached" : "**missed**";
            string reach = target is { } t ? $"≤ {Text.Number(t)}" : "";
            print(string.Create(CultureInfo.InvariantCulture, $"| {name} | {Median(cold, i):0.00} | {reach} | {verdict} | {Median(warm, i):0.00} |"));
        }
    }

    /// <summary>Runs the measurement in a fresh process.</summary>
    public static string Measure(bool warm)
    {
        var values = new List<double>();
        long start = Stopwatch.GetTimestamp();
        void Lap()
        {
            values.Add(Stopwatch.GetElapsedTime(start).TotalMilliseconds);
            start = Stopwatch.GetTimestamp();
        }

        var ball = new Ball();
        Lap();
        Simulator simulator = ball.Simulator;
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
            // Wait like the rest of a level's loading, while the runtime recompiles frequent code on another thread.
            Thread.Sleep(Loading);
            if (i < WarmUps)
            {
                WarmUp();
            }
        }

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
        // Along the ground the ball slides at once, and then rolls.
        ball.Place(Vector3d.Zero);
        ball.Kick(new Vector3d(1, 0, -12), Vector3d.Zero);
        double slide = 0;
        double roll = 0;
        var seen = new HashSet<(MotionState, MotionState)>();
        while (ball.Motion != MotionState.Rest)
        {
            MotionState before = ball.Motion;
            start = Stopwatch.GetTimestamp();
            ball.Step(0.01);
            double time = Stopwatch.GetElapsedTime(start).TotalMilliseconds;
            if (seen.Add((before, ball.Motion)))
            {
                slide = before == MotionState.Sliding || ball.Motion == MotionState.Sliding ? Math.Max(slide, time) : slide;
                roll = before == MotionState.Rolling || ball.Motion == MotionState.Rolling ? Math.Max(roll, time) : roll;
            }
        }

        values.Add(slide);
        values.Add(roll);
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
