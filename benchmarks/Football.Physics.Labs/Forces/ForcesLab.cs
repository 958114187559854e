using System.CommandLine;

namespace FootballPhysics.Labs.Forces;

/// <summary>football lab forces: stiff custom forces against closed forms, and look-aheads near moving feet.</summary>
internal static class ForcesLab
{
    /// <summary>The bins of the stiffness, 1/s.</summary>
    private static readonly double[] s_bins = [1, 10, 30, 100, 300, 1_000, 3_000, 10_000, 100_000];

    public static Lab Create()
    {
        var lab = new Lab(
            "forces",
            "Springs and dampings against closed forms, at 30, 60 and 100 Hz; and look-aheads with a sideways gravity or a small force near moving feet.",
            ["football lab forces", "football lab forces --count 5 --looks 50 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Forces in each bin of stiffness.", 1, 1_000_000, 700);
        Option<long> looks = lab.Whole("--looks", "Look-aheads.", 1, 1_000_000, 1000);
        Option<long> jobs = lab.Jobs("Threads.");
        return lab.Plays(run =>
        {
            Closed(run, run.Get(count), run.Int(jobs));
            Looks(run, run.Get(looks));
        });
    }

    private static void Closed(LabRun run, long count, int jobs)
    {
        LabTable table = run.Table(
            "Custom forces after 1 s", "force", "stiffness up to, 1/s", "balls", "largest error, m", "of look-aheads, m", "balls with stiff steps", "most segments", "most evaluations a step",
            "verdict");
        var all = new List<ForceOutcome>();
        for (int bin = 1; bin < s_bins.Length; bin++)
        {
            int at = bin;
            all.AddRange(run.Parallel(count, jobs, $"stiffness {s_bins[bin]}", i => ForceDraw.Play(run.Seed, (at * count) + i, s_bins[at - 1], s_bins[at])));
        }

        foreach (IGrouping<(ForceKind Kind, double Bin), ForceOutcome> group in all.GroupBy(ball => (ball.Kind, Bin: s_bins.First(bin => ball.Stiffness <= bin))).OrderBy(group => group.Key))
        {
            table.Judge(
                group.All(ball => ball.Holds), group.Key.Kind, group.Key.Bin, group.Count(), group.Max(ball => ball.Error), group.Max(ball => ball.LookError),
                group.Count(ball => ball.Stiff + ball.LookStiff > 0), group.Max(ball => ball.Pieces), group.Max(ball => ball.Evaluations));
        }

        run.Notes.Add(FormattableString.Invariant(
            $"Up to {ForceOutcome.Followed}/s, a ball is within {ForceOutcome.Largest} m of its closed form and no step is stiff. Above, it is, or StepLog.StiffSteps counts a step."));
    }

    private static void Looks(LabRun run, long count)
    {
        LabTable table = run.Table(
            "Look-aheads near moving feet", "force", "look-aheads", "thrown", "evaluations", "against none", "dearest", "against none's", "ms", "dearest, ms", "verdict");
        FootLook[] looks = [.. Enumerable.Range(0, (int)count).Select(i => new FootLook(run.Random(i)))];
        FootLooks none = FootLooks.Of(looks, FootForce.None);
        foreach (FootForce force in Enum.GetValues<FootForce>())
        {
            FootLooks its = force == FootForce.None ? none : FootLooks.Of(looks, force);
            double ratio = (double)its.Evaluations / none.Evaluations;
            double dearest = (double)its.Dearest / none.Dearest;
            table.Judge(
                its.Thrown == 0 && ratio <= FootLooks.MostCost && dearest <= FootLooks.MostCost, force, count, its.Thrown, its.Evaluations, ratio, its.Dearest, dearest, its.Total, its.Slowest);
        }

        run.Notes.Add("The look-aheads start with a foot that swings at the ball, with the default step. \"None\" is gravity straight down.");
    }
}
