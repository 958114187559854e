using System.CommandLine;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Queries;

/// <summary>football lab fit: compares how often fits of noisy tracks are within their uncertainty with the stated probability.</summary>
internal static class FitLab
{
    public static Command Create(Terminal terminal)
    {
        Option<long> tracks = Arguments.Whole("--tracks", "Tracks of each kind.", 1, 1_000_000, 2);
        return LabOptions.Create(
            "fit",
            "Fits of noisy simulated tracks (25 points per second, 2 cm): how often the true value is within the reported uncertainty.",
            ["football lab fit --tracks 1 --seed 7"],
            terminal,
            (parsed, seed, progress) => Run(seed, (int)parsed.GetValue(tracks), progress),
            tracks);
    }

    private static LabReport Run(long seed, int tracks, Progress progress)
    {
        var table = new LabTable("Fits of noisy tracks", "looked for", "tracks", "within the 95 % region, %", "least of a number within 1.96 σ, %", "not converged", "steps", "verdict");
        var report = new LabReport { Name = "fit", Seed = seed, Tables = { table } };
        foreach (bool also in (bool[])[false, true])
        {
            var check = new FitCheck();
            for (int i = 0; i < tracks; i++)
            {
                progress.Report(i, tracks, () => also ? "launch and scene" : "launch");
                check.Run(new SeededRandom(SeededRandom.Mix(seed, (also ? 1_000_003 : 0) + i)), also);
            }

            double within = 100.0 * check.Within / tracks;
            table.Add(
                also ? "launch, drag, lift, restitution, friction" : "launch", tracks, within, 100.0 * check.Each.Values.Min() / tracks, check.Lost,
                (double)check.Iterations / tracks, Verdict.Of(within >= 90));
        }

        report.Notes.Add("Reached: the truth is within the region that is to hold 95 % of them in 90 % of the tracks.");
        return report;
    }
}
