using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Labs;

/// <summary>football lab consistency: the thesis' test 3.4.2, the dependence of the landing point on the step.</summary>
internal static class ConsistencyLab
{
    /// <summary>The start of the axes of all histograms, log₁₀ mm; smaller gaps count there.</summary>
    private const double SmallestGap = -9;

    private const int Shots = 250;
    private const double Millimetre = 1e3;
    private static readonly string[] Gaps = ["10–20 ms", "20–40 ms", "10–40 ms"];

    public static Lab Create() => new Lab(
        "consistency",
        "Distances between the landing points of 250 shots, each with three time steps (Test 3.4.2 of the original thesis).",
        ["football lab consistency --seed 3 --json consistency.json"],
        isDrawn: true).Plays(Run);

    private static void Run(LabRun run)
    {
        LabTable table = run.Table(
            "Consistency (3.4.2), 250 shots: gap between landing points, mm",
            "set", "law", "method", "steps", "mean", "p95", "worst", "thesis mean", "reach", "verdict");
        var charts = new List<Func<XElement>>();
        foreach ((string set, Shot[] shots) in new[] { ("usual", ShotSets.Usual(run.Seed, Shots)), ("slow", ShotSets.Slow(run.Seed, Shots)) })
        {
            foreach ((string law, ForceSet forces, bool locate) in new[]
            {
                ("published, jump located", ForceSet.Published, true), ("published, jump not located", ForceSet.Published, false), ("regularised", ForceSet.Regularized, true),
            })
            {
                foreach (Integrator method in new[] { Integrator.Rk2, Integrator.Rk4 })
                {
                    run.Progress.Report(charts.Count, 12, () => $"{set} set, {law}, {method}");
                    double[][] gaps = Measure(shots, forces, locate, method);
                    for (int i = 0; i < gaps.Length; i++)
                    {
                        var spread = new Spread(gaps[i]);
                        (string reach, bool? reached) = Judge(set, law, method, i, spread);
                        table.Add(
                            set, law, method, Gaps[i], spread.Mean, spread.P95, spread.Worst,
                            set == "usual" && law.StartsWith("published", StringComparison.Ordinal) ? Thesis(method)[i] : null,
                            reach,
                            reached is { } yes ? Verdict.Of(yes) : "-");
                    }

                    charts.Add(() => Histogram($"{set} set, {law}, {method}", gaps));
                }
            }
        }

        run.Picture = () => Figure.Tile("How far apart shots land that differ only in the step", [.. charts.Select(make => make())]);
    }

    private static double[] Thesis(Integrator method) => method == Integrator.Rk2 ? [3.1, 7.1, 7.0] : [1.8, 3.8, 3.2];

    private static (string Reach, bool? Reached) Judge(string set, string law, Integrator method, int gap, Spread spread)
    {
        if (law != "published, jump located")
        {
            return ("-", null);
        }

        double[] rk2 = [0.45, 1.8, 2.2];
        double[] rk4 = [1e-5, 1e-4, 1e-4];
        return (set, method) switch
        {
            ("usual", Integrator.Rk2) => ($"mean {Text(rk2[gap])}", spread.Mean <= rk2[gap]),
            ("usual", _) => ($"mean {Text(rk4[gap])}", spread.Mean <= rk4[gap]),
            (_, Integrator.Rk4) => ($"p95 {Text(rk4[gap])}, mean 0.03", spread.P95 <= rk4[gap] && spread.Mean <= 0.03),
            _ => ("-", null),
        };
    }

    private static string Text(double value) => value.ToString(value < 0.01 ? "0e0" : "0.##", System.Globalization.CultureInfo.InvariantCulture);

    private static double[][] Measure(Shot[] shots, ForceSet forces, bool locate, Integrator method)
    {
        var simulator = new Simulator(Scene.Published with { Forces = forces }, new SolverSettings { Integrator = method, LocateJump = locate });
        Vector3d[][] landings =
            [.. new[] { 0.01, 0.02, 0.04 }.Select(step => shots.Select(shot => simulator.Fly(Shot.Spot, shot.Velocity, shot.Spin, step, 30, StopAt.Impact).Position).ToArray())];
        double[] Between(int a, int b) => [.. landings[a].Zip(landings[b], (p, q) => Millimetre * Vector3d.Distance(p, q))];
        return [Between(0, 1), Between(1, 2), Between(0, 2)];
    }

    private static XElement Histogram(string title, double[][] gaps)
    {
        var chart = new Chart(new Axis("log₁₀ of the gap, mm") { Min = SmallestGap, Max = 3 }, new Axis("shots") { Min = 0 }) { Title = title, PlotHeight = 150 };
        for (int i = 0; i < gaps.Length; i++)
        {
            double[] logs = [.. gaps[i].Select(gap => Math.Log10(Math.Max(gap, Math.Pow(10, SmallestGap))))];
            chart.Items.Add(BarsItem.Histogram(logs, 30, Palette.Series[i], Gaps[i]));
        }

        return chart.Draw();
    }
}
