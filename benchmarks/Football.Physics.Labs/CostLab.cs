using System.Diagnostics;
using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Labs;

/// <summary>football lab cost: the thesis' test 3.4.3, the time of a step by method and motion.</summary>
internal static class CostLab
{
    private const int Frames = 20_000;
    private const double Step = 0.01;

    /// <summary>Each frame is repeated this many times: a single frame is shorter than the clock's tick.</summary>
    private const int Repeats = 32;

    private const int WarmUp = 60;

    public static Lab Create() => new Lab(
        "cost",
        "Run time of a 10 ms step by integrator and motion, over 20 000 frames each (Test 3.4.3 of the original thesis).",
        ["football lab cost --quick"],
        isDrawn: true).PlaysQuick((run, quick) => Run(run, quick ? Frames / 100 : Frames, quick ? 1 : WarmUp));

    private static void Run(LabRun run, int frames, int warmUp)
    {
        LabTable table = run.Table(
            $"Time of a step (3.4.3), {frames} frames a row without an event, ns",
            "method", "motion", "p5", "median", "p95", "p99", "mean to p99", "thesis, all motions", "times faster");
        var shown = new List<(Integrator Method, double[] Times)>();
        foreach (Integrator method in Enum.GetValues<Integrator>())
        {
            var simulator = new Simulator(Scene.Published, new SolverSettings { Integrator = method });
            Dictionary<MotionState, BallState[]> before = Collect(simulator, run.Random(343), frames);
            var log = new StepLog();
            foreach ((MotionState motion, BallState[] states) in before)
            {
                run.Progress.Report(table.Rows.Count, 16, () => $"{method}, {motion}");
                for (int i = 0; i < warmUp; i++)
                {
                    Time(simulator, states, log, states.Length / warmUp, []);
                    Thread.Sleep(i % 20 == 0 ? 130 : 0);
                }

                var times = new double[states.Length];
                Time(simulator, states, log, states.Length, times);
                var spread = new Spread(times);
                double top = spread.Percentile(0.99);
                double mean = times.Where(time => time <= top).Average();
                double thesis = Thesis(method);
                table.Add(method, motion, spread.Percentile(0.05), spread.Median, spread.P95, top, mean, thesis, motion == MotionState.Rest ? null : thesis / mean);
                if (motion == MotionState.Airborne)
                {
                    shown.Add((method, [.. times.Where(time => time <= top)]));
                }
            }
        }

        run.Notes.Add("Each frame is stepped 32 times in a row from a copy of its state, the copy included. Values above the 99th percentile are left out of the mean, as in the thesis.");
        run.Notes.Add("Ratios to plain code in one process, which is how the targets for time are judged: the benchmarks.");
        run.Picture = () =>
        {
            double longest = shown.Max(row => row.Times.Max());
            return Figure.Tile("Time of a step in flight", [.. shown.Select(row => Histogram(row.Method, row.Times, longest))]);
        };
    }

    private static double Thesis(Integrator method) => method switch
    {
        Integrator.Euler => 11_200,
        Integrator.SemiImplicitEuler => 12_000,
        Integrator.Rk2 => 14_700,
        _ => 20_900,
    };

    /// <summary>Returns the states before a number of event-free steps of each motion. Balls are kicked, come to rest and are kicked again.</summary>
    private static Dictionary<MotionState, BallState[]> Collect(Simulator simulator, SeededRandom random, int frames)
    {
        var found = Enum.GetValues<MotionState>().Where(motion => motion != MotionState.Pinned).ToDictionary(motion => motion, _ => new List<BallState>(frames));
        var log = new StepLog();
        while (found.Values.Any(list => list.Count < frames))
        {
            // Once only slides are missing, kick along the ground, until the ball rolls.
            bool onlySlides = found.All(list => list.Key == MotionState.Sliding || list.Value.Count >= frames);
            double steepest = onlySlides ? 0 : 35;
            BallState state = simulator.Launch(
                Shot.Spot, random.Velocity(15, 35, Math.Min(5, steepest), steepest), random.Uniform(2, 60) * random.Direction());
            for (int stopped = 0; stopped < 100;)
            {
                BallState before = state;
                log.Clear();
                simulator.Step(ref state, Step, log);
                List<BallState> list = found[before.Motion];
                if (log.Events.Count == 0 && list.Count < frames)
                {
                    list.Add(before);
                }

                stopped += before.Motion == MotionState.Rest ? 1 : 0;
                if (onlySlides && before.Motion == MotionState.Rolling)
                {
                    break;
                }
            }
        }

        return found.ToDictionary(pair => pair.Key, pair => pair.Value.ToArray());
    }

    private static void Time(Simulator simulator, BallState[] states, StepLog log, int count, double[] times)
    {
        for (int i = 0; i < count; i++)
        {
            long start = Stopwatch.GetTimestamp();
            for (int k = 0; k < Repeats; k++)
            {
                BallState state = states[i];
                simulator.Step(ref state, Step, log);
            }

            long end = Stopwatch.GetTimestamp();
            if (i < times.Length)
            {
                times[i] = (end - start) * (1e9 / Stopwatch.Frequency) / Repeats;
            }
        }
    }

    private static XElement Histogram(Integrator method, double[] times, double longest)
    {
        var chart = new Chart(new Axis("time of a step, ns") { Min = 0, Max = longest }, new Axis("frames") { Min = 0 }) { Title = method.ToString(), PlotHeight = 120 };
        chart.Items.Add(BarsItem.Histogram(times, 60, Palette.Blue));
        return chart.Draw();
    }
}
