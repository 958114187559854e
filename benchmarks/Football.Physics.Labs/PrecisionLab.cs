using System.Diagnostics;
using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Labs;

/// <summary>football lab precision: work against precision, every method with every step.</summary>
internal static class PrecisionLab
{
    private const double ReferenceStep = 0.0002;

    /// <summary>The time for which a row is measured, s.</summary>
    private const double MeasuredFor = 0.15;

    private static readonly double[] Steps = [0.001, 0.002, 0.005, 0.01, 0.02, 0.04, 0.08, 0.16, 0.32];

    private static readonly SolverSettings ThesisWay = new()
    {
        CollisionTiming = CollisionTiming.Bisection,
        RollingTransition = RollingTransition.Heuristic,
        LocateJump = false,
    };

    public static Lab Create() => new Lab(
        "precision",
        "Error of each integrator against its cost, with steps of 1 to 320 ms, from kick to impact and from kick to rest.",
        ["football lab precision --quick --plot precision.svg"],
        isDrawn: true).PlaysQuick(Run);

    private static void Run(LabRun run, bool quick)
    {
        double seconds = quick ? 0 : MeasuredFor;
        var charts = new List<Func<XElement>>();
        foreach ((string name, Shot[] shots, StopAt stop) in new[]
        {
            ("kick to impact", ShotSets.Make(run.Seed, 14, 35, 0, 60, count: quick ? 10 : 100), StopAt.Impact),
            ("kick to rest", ShotSets.Make(run.Seed, 13, 30, 0, 60, count: quick ? 5 : 50), StopAt.Rest),
        })
        {
            run.Progress.Report(() => $"{name}: reference");
            PrecisionPoint[] reference = Reference(run, shots, stop, name);
            foreach (Integrator method in quick ? [] : Enum.GetValues<Integrator>())
            {
                run.Progress.Report(() => $"{name}: warming up, {method}");
                WarmUp(new SolverSettings { Integrator = method }, shots, stop);
                WarmUp(ThesisWay with { Integrator = method }, shots, stop);
            }

            var points = new List<PrecisionRow>();
            foreach (Integrator method in Enum.GetValues<Integrator>())
            {
                foreach (double step in Steps)
                {
                    run.Progress.Report(points.Count, 48, () => $"{name}: {method}, {1e3 * step} ms");
                    points.Add(Measure(new SolverSettings { Integrator = method }, step, shots, stop, reference, thesis: false, seconds));
                }

                foreach (double step in new[] { 0.01, 0.02, 0.04 })
                {
                    points.Add(Measure(ThesisWay with { Integrator = method }, step, shots, stop, reference, thesis: true, seconds));
                }
            }

            AddRows(run, name, shots.Length, points);
            AddNeeded(run, name, points);
            if (stop == StopAt.Impact)
            {
                AddWanted(run, name, shots, reference, seconds);
            }

            charts.Add(() => Draw($"{name}: error against evaluations", "evaluations a second of motion", points, row => row.Evaluations));
            charts.Add(() => Draw($"{name}: error against time", "ns a second of motion", points, row => row.Nanoseconds));
        }

        run.Picture = () => Figure.Tile("Work and precision", [.. charts.Select(make => make())]);
    }

    /// <summary>Computes the reference, RK4 with 0.1 ms, and its distance from 0.2 ms.</summary>
    private static PrecisionPoint[] Reference(LabRun run, Shot[] shots, StopAt stop, string name)
    {
        var simulator = new Simulator(Scene.Published);
        PrecisionPoint[] coarse = Play(simulator, shots, stop, ReferenceStep, out _);
        PrecisionPoint[] fine = Play(simulator, shots, stop, 0.5 * ReferenceStep, out _);
        var gaps = new Spread(coarse.Zip(fine, (a, b) => Vector3d.Distance(a.Place, b.Place)));
        run.Notes.Add(FormattableString.Invariant(
            $"Reference, {name}: RK4, 0.1 ms; 0.2 ms is within {gaps.Percentile(0.95):0.0e0} m of it (p95), at worst {gaps.Worst:0.0e0} m; good to 1e-10 m in {coarse.Zip(fine, (a, b) => Vector3d.Distance(a.Place, b.Place)).Count(gap => gap <= 1e-10)} of {shots.Length}."));
        return fine;
    }

    /// <summary>Runs until the runtime has compiled the final code: it counts calls, and waits for a tenth of a second without new ones.</summary>
    private static void WarmUp(SolverSettings settings, Shot[] shots, StopAt stop)
    {
        var simulator = new Simulator(Scene.Published, settings);
        for (int pass = 0; pass < 4; pass++)
        {
            for (int i = 0; i < 10; i++)
            {
                Play(simulator, shots, stop, 0.04, out _);
            }

            Thread.Sleep(130);
        }
    }

    private static PrecisionRow Measure(SolverSettings settings, double step, Shot[] shots, StopAt stop, PrecisionPoint[] reference, bool thesis, double atLeast)
    {
        var simulator = new Simulator(Scene.Published, settings);
        double fastest = double.PositiveInfinity;
        PrecisionPoint[] played = [];
        long evaluations = 0;
        long begin = Stopwatch.GetTimestamp();
        for (int i = 0; i < 40 && (i < 2 || Stopwatch.GetElapsedTime(begin).TotalSeconds < atLeast); i++)
        {
            long start = Stopwatch.GetTimestamp();
            played = Play(simulator, shots, stop, step, out evaluations);
            fastest = Math.Min(fastest, Stopwatch.GetElapsedTime(start).TotalNanoseconds);
        }

        double seconds = played.Sum(point => point.Time);
        var errors = new Spread(played.Zip(reference, (a, b) => Vector3d.Distance(a.Place, b.Place)));
        return new PrecisionRow(settings.Integrator, step, thesis, errors.Mean, errors.Percentile(0.95), errors.Worst, evaluations / seconds, fastest / seconds);
    }

    private static PrecisionPoint[] Play(Simulator simulator, Shot[] shots, StopAt stop, double step, out long evaluations)
    {
        var log = new StepLog();
        var points = new PrecisionPoint[shots.Length];
        for (int i = 0; i < shots.Length; i++)
        {
            log.Events.Clear();
            BallState state = simulator.Fly(Shot.Spot, shots[i].Velocity, shots[i].Spin, step, 120, stop, log);
            points[i] = new PrecisionPoint(state.Position, state.Time);
        }

        evaluations = log.Evaluations;
        return points;
    }

    private static void AddRows(LabRun run, string name, int shots, List<PrecisionRow> points)
    {
        LabTable table = run.Table(
            $"{name}, {shots} shots: error in m, work a second of motion",
            "method", "step, ms", "way", "mean", "p95", "worst", "evaluations", "ns");
        foreach (PrecisionRow row in points)
        {
            table.Add(row.Method, 1e3 * row.Step, row.Thesis ? "thesis" : "exact", row.Mean, row.P95, row.Worst, row.Evaluations, row.Nanoseconds);
        }
    }

    /// <summary>Adds evaluations and time for a mean error, interpolated between the step sizes on the log–log line.</summary>
    private static void AddNeeded(LabRun run, string name, List<PrecisionRow> points)
    {
        LabTable table = run.Table(
            $"{name}: needed a second of motion for a mean error",
            "method", "1 mm: evaluations", "1 mm: ns", "0.1 mm: evaluations", "0.1 mm: ns", "1 µm: evaluations", "1 µm: ns");
        foreach (Integrator method in Enum.GetValues<Integrator>())
        {
            PrecisionRow[] rows = [.. points.Where(row => row.Method == method && !row.Thesis).OrderByDescending(row => row.Step)];
            object?[] Cells(double error) => [Between(rows, error, row => row.Evaluations), Between(rows, error, row => row.Nanoseconds)];
            table.Add([method, .. Cells(1e-3), .. Cells(1e-4), .. Cells(1e-6)]);
        }
    }

    /// <summary>Adds the settings chosen for a requested accuracy, their cost and their accuracy.</summary>
    private static void AddWanted(LabRun run, string name, Shot[] shots, PrecisionPoint[] reference, double seconds)
    {
        LabTable table = run.Table(
            $"{name}: picked for the accuracy wanted",
            "wanted", "method", "step, ms", "mean", "p95", "worst", "evaluations", "ns");
        foreach (Accuracy wanted in Enum.GetValues<Accuracy>())
        {
            SolverSettings settings = SolverSettings.For(wanted, out double step);
            PrecisionRow row = Measure(settings, step, shots, StopAt.Impact, reference, thesis: false, seconds);
            table.Add(wanted, row.Method, 1e3 * row.Step, row.Mean, row.P95, row.Worst, row.Evaluations, row.Nanoseconds);
        }
    }

    private static double? Between(PrecisionRow[] rows, double error, Func<PrecisionRow, double> work)
    {
        // From the coarsest step on: find the first pair that brackets the error and stays below it.
        int first = Array.FindIndex(rows, row => row.Mean <= error);
        if (first < 0)
        {
            return null;
        }

        if (first == 0)
        {
            return work(rows[0]);
        }

        (PrecisionRow a, PrecisionRow b) = (rows[first - 1], rows[first]);
        double share = Math.Log(a.Mean / error) / Math.Log(a.Mean / b.Mean);
        return Math.Exp(Math.Log(work(a)) + (share * Math.Log(work(b) / work(a))));
    }

    private static XElement Draw(string title, string axis, List<PrecisionRow> points, Func<PrecisionRow, double> work)
    {
        var chart = new Chart(new Axis(axis) { Scale = AxisScale.Logarithmic }, new Axis("mean error, m") { Scale = AxisScale.Logarithmic }) { Title = title, PlotHeight = 280 };
        foreach (Integrator method in Enum.GetValues<Integrator>())
        {
            string colour = Palette.Series[(int)method];
            PlotPoint[] Points(bool thesis) => [.. points.Where(row => row.Method == method && row.Thesis == thesis).Select(row => new PlotPoint(work(row), row.Mean))];
            chart.Items.Add(new PolylineItem(Points(false)) { Colour = colour, Label = method.ToString() });
            chart.Items.Add(new ScatterItem(Points(false)) { Colour = colour, Size = 2.5 });
            chart.Items.Add(new ScatterItem(Points(true)) { Colour = colour, Mark = Mark.Cross, Size = 5, Label = $"{method} the thesis' way, 10, 20, 40 ms" });
        }

        return chart.Draw();
    }
}

/// <summary>A method with a step: its errors, m, and its work per second of motion.</summary>
internal sealed record PrecisionRow(
    Integrator Method, double Step, bool Thesis, double Mean, double P95, double Worst, double Evaluations, double Nanoseconds);

/// <summary>The position and time of the end of a shot.</summary>
internal readonly record struct PrecisionPoint(Vector3d Place, double Time);
