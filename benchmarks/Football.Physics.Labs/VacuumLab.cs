using FootballPhysics.Drawing;

namespace FootballPhysics.Labs;

/// <summary>football lab vacuum: the thesis' table 3.1, landing points in vacuum compared with the closed form.</summary>
internal static class VacuumLab
{
    private const int Shots = 50;
    private const double Gravity = 9.81;
    private static readonly double[] Steps = [0.04, 0.02, 0.01];

    private static readonly Dictionary<Integrator, double[]> Thesis = new()
    {
        [Integrator.Euler] = [588.870, 294.817, 147.541],
        [Integrator.SemiImplicitEuler] = [586.855, 293.985, 147.142],
        [Integrator.Rk2] = [0.016, 0.027, 0.055],
        [Integrator.Rk4] = [0.014, 0.025, 0.044],
    };

    public static Lab Create() => new Lab(
        "vacuum",
        "Landing points of 50 shots in vacuum, compared with the closed form (Table 3.1 of the original thesis).",
        ["football lab vacuum", "football lab vacuum --seed 7 --csv vacuum.csv --plot vacuum.svg"],
        isDrawn: true).Plays(Run);

    private static void Run(LabRun run)
    {
        SeededRandom random = run.Random(31);
        (double X, double Y)[] kicks = [.. Enumerable.Range(0, Shots).Select(_ => (random.Uniform(5, 20), random.Uniform(5, 20)))];
        LabTable table = run.Table(
            "Vacuum landing (3.4.1), 50 shots: mean error, mm",
            "method", "impact", "40 ms", "20 ms", "10 ms", "thesis 40", "thesis 20", "thesis 10", "worst", "of", "reach", "verdict");
        var lines = new List<(string Name, double[] Means)>();
        foreach (Integrator method in Enum.GetValues<Integrator>())
        {
            foreach (CollisionTiming timing in Enum.GetValues<CollisionTiming>())
            {
                run.Progress.Report(lines.Count, 8, () => $"{method}, {timing}");
                bool euler = method is Integrator.Euler or Integrator.SemiImplicitEuler;
                var means = new double[Steps.Length];
                double worst = 0;
                for (int i = 0; i < Steps.Length; i++)
                {
                    double step = Steps[i];
                    double[] errors = [.. kicks.Select(kick => Error(method, timing, step, kick.X, kick.Y))];
                    means[i] = 1e3 * errors.Average();

                    // Euler's error is exactly v_x Δt, so judge the relative deviation of each shot from it.
                    double off = euler ? errors.Zip(kicks, (error, kick) => Math.Abs((error / (kick.X * step)) - 1)).Max() * 100 : 1e3 * errors.Max();
                    worst = Math.Max(worst, off);
                }

                lines.Add(($"{method}, {timing}", means));
                double reach = euler ? 1.1 : 1e-7;
                bool judged = timing == CollisionTiming.Exact;
                string verdict = judged ? Verdict.Of(euler ? worst <= reach : means.Max() <= reach) : "-";
                table.Add(
                    [method, timing, .. means.Select(mean => (object?)mean), .. Thesis[method].Select(mean => (object?)mean), worst,
                        euler ? "% off v_x Δt" : "mm", euler ? "1.1 %" : "1e-7 mm", verdict]);
            }
        }

        run.Notes.Add("Bisection is the thesis' search, to 1 µs; it is judged by nothing but stands for comparison.");
        run.Picture = () =>
        {
            var chart = new Chart(new Axis("step, ms") { Scale = AxisScale.Logarithmic }, new Axis("mean error, mm") { Scale = AxisScale.Logarithmic })
            {
                Title = "Landing error in vacuum",
            };
            for (int i = 0; i < lines.Count; i++)
            {
                PlotPoint[] points = [.. Steps.Select((step, k) => new PlotPoint(1e3 * step, Math.Max(1e-13, lines[i].Means[k])))];
                chart.Items.Add(new PolylineItem(points) { Colour = Palette.Series[i % Palette.Series.Count], Label = lines[i].Name, Dash = i % 2 == 0 ? "none" : "4 3" });
            }

            return Figure.Stack("", [chart.Draw()]);
        };
    }

    private static double Error(Integrator method, CollisionTiming timing, double step, double x, double y)
    {
        var simulator = new Simulator(Scene.Vacuum, new SolverSettings { Integrator = method, CollisionTiming = timing });
        return Math.Abs(simulator.Fly(Shot.Spot, new Vector3d(x, y, 0), Vector3d.Zero, step, 20, StopAt.Impact).Position.X - (2 * x * y / Gravity));
    }
}
