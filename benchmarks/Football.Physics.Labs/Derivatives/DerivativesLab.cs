using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Derivatives;

/// <summary>football lab derivatives: compares derivatives of random flights by the launch with central differences of the simulation.</summary>
internal static class DerivativesLab
{
    public static Command Create(Terminal terminal)
    {
        var lab = new Lab(
            "derivatives",
            "Derivatives of the end position and time by the launch, compared with central differences: random flights with bounces, posts, nets and slopes.",
            ["football lab derivatives", "football lab derivatives --flights 2 --seed 7"]);
        Option<long> flights = lab.Whole("--flights", "Flights of each kind.", 1, 1_000_000, 3);
        Option<long> step = lab.Whole("--step", "Time step in ms.", 1, 20, 10);
        return lab.Command(terminal, run => Run(run, run.Int(flights), 0.001 * run.Get(step)));
    }

    private static void Run(LabRun run, int flights, double timeStep)
    {
        LabTable table = run.Table(
            FormattableString.Invariant($"Derivatives by the launch: error of the largest entry of a block, at RK4 {1000 * timeStep:0} ms"),
            "kind", "flights", "on edge", "uncertain", "impacts", "slides", "nets", "median", "90 %", "worst", "within 1e-6, %", "within 1e-5, %", "verdict");
        foreach (DerivativesKind kind in Enum.GetValues<DerivativesKind>())
        {
            var check = new DerivativesCheck(kind, timeStep);
            for (int i = 0; i < flights; i++)
            {
                run.Progress.Report(((int)kind * flights) + i, 5 * flights, () => kind.ToString());
                check.Run(run.Random(((int)kind * 1_000_003) + i));
            }

            double[] errors = [.. check.Errors.Order()];
            double At(double share) => errors.Length == 0 ? double.NaN : errors[Math.Min(errors.Length - 1, (int)(share * errors.Length))];
            double within = 100.0 * errors.Count(error => error <= DerivativesCheck.Reach) / Math.Max(1, errors.Length);
            double close = 100.0 * check.Errors.Count(error => error <= 10 * DerivativesCheck.Reach) / Math.Max(1, errors.Length);
            table.Add(
                [kind, errors.Length, .. check.Counts.Cells("on edge", "uncertain", "Impact", "Slide", "Net"), At(0.5), At(0.9), At(1), within, close, Verdict.Of(within >= 99)]);
        }

        run.Notes.Add("Not judged are flights on edge (a launch that differs by 2 µm/s, or 20 µrad/s, goes through other events) and uncertain ones (at no width do differences agree with the next wider and narrower to 3e-7). Reached: 99 % are within 1e-6.");
    }
}
