using System.Diagnostics;
using System.Globalization;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Mono;

/// <summary>Times flight steps and look-aheads next to the plain yardstick, in the calling process.</summary>
public static class MonoSteps
{
    private const double LookAheadStep = 0.08;

    /// <summary>Prints a table in Markdown.</summary>
    /// <param name="seconds">The time for each row, s.</param>
    public static void Print(double seconds)
    {
        Console.WriteLine("| | ns | yardstick, ns | ratio |\n|---|--:|--:|--:|");
        foreach (Integrator integrator in new[] { Integrator.Euler, Integrator.SemiImplicitEuler, Integrator.Rk2, Integrator.Rk4 })
        {
            foreach ((string set, IReadOnlyList<Shot> shots) in new[] { ("fast", ShotSets.Fast), ("mixed", ShotSets.Mixed) })
            {
                Row($"flight step, {set}: {integrator}", Flight(integrator, shots), Plain(integrator, shots), seconds);
            }
        }

        Row("3 s look-ahead, RK4, 80 ms steps, in plain RK2 steps", LookAhead(), Plain(Integrator.Rk2, ShotSets.Fast), seconds);
    }

    private static void Row(string name, Func<int> subject, Func<int> yardstick, double seconds)
    {
        // Compile both before the measurement; then they alternate, and the median round counts.
        subject();
        yardstick();
        var a = new List<double>();
        var b = new List<double>();
        for (var clock = Stopwatch.StartNew(); clock.Elapsed.TotalSeconds < seconds || a.Count < 5;)
        {
            a.Add(Time(subject));
            b.Add(Time(yardstick));
        }

        double ours = Median(a);
        double plain = Median(b);
        Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "| {0} | {1:G3} | {2:G3} | {3:G3} |", name, ours, plain, ours / plain));
    }

    /// <summary>Returns the time per operation, ns.</summary>
    private static double Time(Func<int> run)
    {
        long start = Stopwatch.GetTimestamp();
        int operations = run();
        return (Stopwatch.GetTimestamp() - start) * 1e9 / Stopwatch.Frequency / operations;
    }

    private static double Median(List<double> times)
    {
        times.Sort();
        return times[times.Count / 2];
    }

    private static Func<int> Flight(Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var simulator = new Simulator(Scene.Published, new SolverSettings { Integrator = integrator });
        BallState[] states = [.. shots.Select(shot => shot.From(ShotSets.HighUp)).Select(shot => simulator.Launch(shot.Position, shot.Velocity, shot.Spin))];
        var log = new StepLog();
        return () =>
        {
            foreach (BallState state in states)
            {
                BallState s = state;
                for (int i = 0; i < ShotSets.Steps; i++)
                {
                    simulator.Step(ref s, ShotSets.TimeStep, log);
                }
            }

            log.Clear();
            return states.Length * ShotSets.Steps;
        };
    }

    private static Func<int> LookAhead()
    {
        var simulator = new Simulator(Scene.Published, new SolverSettings { Integrator = Integrator.Rk4 });
        BallState[] states = [.. ShotSets.Mixed.Select(shot => simulator.Launch(shot.Position, shot.Velocity, shot.Spin))];
        var log = new StepLog();
        return () =>
        {
            foreach (BallState state in states)
            {
                BallState s = state;
                log.Clear();
                simulator.Run(ref s, LookAheadStep, ShotSets.LookAhead, StopAt.Time, log);
            }

            return states.Length;
        };
    }

    private static Func<int> Plain(Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var flight = PlainFlight.Create(PlainLawKind.Published, integrator);
        PlainState[] states = [.. shots.Select(shot => PlainState.Of(shot.From(ShotSets.HighUp)))];
        return () =>
        {
            foreach (PlainState state in states)
            {
                PlainState s = state;
                for (int i = 0; i < ShotSets.Steps; i++)
                {
                    flight.Step(ref s, ShotSets.TimeStep);
                }
            }

            return states.Length * ShotSets.Steps;
        };
    }
}
