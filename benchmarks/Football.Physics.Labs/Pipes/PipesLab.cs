using System.CommandLine;

namespace FootballPhysics.Labs.Pipes;

/// <summary>football lab pipes: balls that roll into quarter pipes and bowls, and what their steps cost.</summary>
internal static class PipesLab
{
    /// <summary>The balls that are played first, so that no measured step waits for the compiler.</summary>
    private const int WarmUp = 60;

    /// <summary>A game that is farther from its path than this has taken another course, m.</summary>
    private const double Apart = 0.02;

    public static Lab Create()
    {
        var lab = new Lab(
            "pipes",
            "Balls that roll into quarter pipes and bowls that are flush with the ground: no path is cut short, and no step takes more than a millisecond.",
            ["football lab pipes", "football lab pipes --count 200 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Balls.", 1, 10_000_000, 1000);
        Option<long?> ball = lab.WholeOrNone("--ball", "One ball by its number.", long.MaxValue);
        Option<bool> times = lab.Flag("--times", "Also judge the time of the dearest step, on a quiet machine.");
        return lab.Plays(run =>
        {
            long first = run.Get(ball) ?? 0;
            Run(run, first, run.Get(ball) is null ? run.Get(count) : 1, run.Get(times));
        });
    }

    private static void Run(LabRun run, long first, long count, bool times)
    {
        for (int i = 0; i < WarmUp; i++)
        {
            PipeDraw.Play(run.Seed + 1, i);
        }

        // One thread: the times of steps are measured.
        var outcomes = new PipeOutcome[count];
        run.Parallel(first, count, 1, "ball", index => outcomes[index - first] = PipeDraw.Play(run.Seed, index));
        LabTable table = run.Table(
            "Balls in pipes and bowls", "shape", "balls", "paths cut short", "most pieces of a path", "median flight steps of a step", "most", "dearest step, ms", "apart from the path", "deepest, m", "verdict");
        foreach (IGrouping<PipeKind, PipeOutcome> kind in outcomes.GroupBy(outcome => outcome.Kind).OrderBy(kind => kind.Key))
        {
            table.Judge(
                kind.All(Holds),
                kind.Key, kind.Count(), kind.Count(outcome => !outcome.IsWhole), kind.Max(outcome => outcome.Pieces), kind.Max(outcome => outcome.Median),
                kind.Max(outcome => outcome.Steps.Max()), 1e3 * kind.Max(outcome => outcome.Slowest), kind.Count(outcome => outcome.Off > Apart), kind.Max(outcome => outcome.Sunk));
        }

        bool Holds(PipeOutcome outcome) => outcome.Holds && (!times || outcome.IsFast);
        int failed = Array.FindIndex(outcomes, outcome => !Holds(outcome));
        if (failed >= 0)
        {
            run.Notes.Add(FormattableString.Invariant($"First failure: --ball {first + failed} --seed {run.Seed}: {outcomes[failed].What}."));
        }

        run.Notes.Add(FormattableString.Invariant($"Each ball is played for {PipeDraw.Duration} s at 60 Hz. The time of a step is the best of 5 from the same state. Radii are 0.3 to 5 m, speeds 1 to 20 m/s. Bounces magnify the difference between the steps of the game and those of the path (20 ms)."));
    }
}
