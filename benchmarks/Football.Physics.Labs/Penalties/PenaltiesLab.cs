using System.CommandLine;

namespace FootballPhysics.Labs.Penalties;

/// <summary>football lab penalties: the share of goals for each aim and keeper.</summary>
internal static class PenaltiesLab
{
    /// <summary>The share of goals of people: 2 379 penalties (Brinkschulte, Furley and Memmert, doi:10.21203/rs.3.rs-400697/v1, 2021).</summary>
    private const double People = 0.778;

    /// <summary>The greatest difference from it: published shares are between 0.74 and 0.80.</summary>
    private const double Allowed = 0.04;

    /// <summary>The number of deviations by which a sample may miss the range.</summary>
    private const double Deviations = 3;

    public static Lab Create()
    {
        var lab = new Lab(
            "penalties",
            "Penalties against keepers who react and keepers who guess: shooters who aim as people do score about three of four against the keeper who guesses.",
            ["football lab penalties --count 10", "football lab penalties --seed 7 --csv penalties.csv --count 20"]);
        Option<long> count = lab.Whole("--count", "Penalties for each aim and keeper.", 1, 1_000_000, 300);
        Option<long> jobs = lab.Jobs("Threads.");
        return lab.Plays(run => Run(run, run.Int(count), run.Int(jobs)));
    }

    private static void Run(LabRun run, int count, int jobs)
    {
        int keepers = PenaltyKeeper.All.Count;
        long all = (long)PenaltyAim.All.Count * keepers * count;
        PenaltyEnd[] ends = run.Parallel(all, jobs, "penalty", i =>
        {
            // The kicks and the guesses of a row are the same for all keepers.
            int kick = (int)(i % count);
            int aim = (int)(i / count / keepers);
            return PenaltyKick.Play(run.Random(((long)aim * count) + kick), PenaltyAim.All[aim], PenaltyKeeper.All[(int)(i / count % keepers)], (aim * count) + kick, run.Seed);
        });
        LabTable table = run.Table(FormattableString.Invariant($"{count} penalties each"), "aim", "keeper", "scored, %", "± %", "saved, %", "post, %", "missed, %", "verdict");
        for (int row = 0; row < PenaltyAim.All.Count * keepers; row++)
        {
            PenaltyEnd[] its = ends[(row * count)..((row + 1) * count)];
            double scored = Share(its, PenaltyEnd.Scored);
            double deviation = Math.Sqrt(Math.Max(scored * (1 - scored), 1.0 / count) / count);
            bool isJudged = row == (PenaltyAim.All.Count * keepers) - 1;
            object?[] cells =
            [
                PenaltyAim.All[row / keepers].Name, PenaltyKeeper.All[row % keepers].Name, 100 * scored, 100 * deviation, 100 * Share(its, PenaltyEnd.Saved), 100 * Share(its, PenaltyEnd.Post),
                100 * Share(its, PenaltyEnd.Missed),
            ];
            if (isJudged)
            {
                table.Judge(Math.Abs(scored - People) <= Allowed + (Deviations * deviation), cells);
            }
            else
            {
                table.Add([.. cells, null]);
            }
        }

        run.Notes.Add("± is the standard deviation of the share of goals. The last row has a verdict: 77.8 % of 2 379 penalties at World Cups, European Championships and in European cups were scored");
        run.Notes.Add("(Brinkschulte, Furley and Memmert 2021). The sides of kicks and guesses have the shares of 286 penalties (Bar-Eli et al. 2007).");
    }

    private static double Share(PenaltyEnd[] ends, PenaltyEnd end) => ends.Count(item => item == end) / (double)ends.Length;
}
