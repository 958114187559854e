using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Queries;

/// <summary>football lab fit: compares how often fits of noisy tracks are within their uncertainty with the stated probability.</summary>
internal static class FitLab
{
    public static Command Create(Terminal terminal)
    {
        var lab = new Lab(
            "fit",
            "Fits of noisy simulated tracks (25 points per second, 2 cm): how often the true value is within the reported uncertainty.",
            ["football lab fit --tracks 1 --seed 7"]);
        Option<long> tracks = lab.Whole("--tracks", "Tracks of each kind.", 1, 1_000_000, 2);
        return lab.Command(terminal, run => Run(run, run.Int(tracks)));
    }

    private static void Run(LabRun run, int tracks)
    {
        LabTable table = run.Table("Fits of noisy tracks", "looked for", "tracks", "within the 95 % region, %", "least of a number within 1.96 σ, %", "not converged", "steps", "verdict");
        foreach (bool also in (bool[])[false, true])
        {
            var check = new FitCheck();
            for (int i = 0; i < tracks; i++)
            {
                run.Progress.Report(i, tracks, () => also ? "launch and scene" : "launch");
                check.Run(run.Random((also ? 1_000_003 : 0) + i), also);
            }

            double within = 100.0 * check.Within / tracks;
            table.Add(
                also ? "launch, drag, lift, restitution, friction" : "launch", tracks, within, 100.0 * check.Each.Values.Min() / tracks, check.Lost,
                (double)check.Iterations / tracks, Verdict.Of(within >= 90));
        }

        run.Notes.Add("Reached: the truth is within the region that is to hold 95 % of them in 90 % of the tracks.");
    }
}
