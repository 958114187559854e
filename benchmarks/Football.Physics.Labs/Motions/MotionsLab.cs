using System.CommandLine;

namespace FootballPhysics.Labs.Motions;

/// <summary>football lab motions: each change of a ball's motion has an event.</summary>
internal static class MotionsLab
{
    public static Lab Create()
    {
        var lab = new Lab(
            "motions",
            "Balls that roll, slide and fall among obstacles, bodies and colliders: each change of a motion between two steps has its event.",
            ["football lab motions", "football lab motions --count 300 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Scenes.", 1, 10_000_000, 2000);
        Option<long?> scene = lab.WholeOrNone("--scene", "One scene by its number.", long.MaxValue);
        Option<long> jobs = lab.Jobs("Threads.");
        return lab.Plays(run =>
        {
            long first = run.Get(scene) ?? 0;
            Run(run, first, run.Get(scene) is null ? run.Get(count) : 1, run.Int(jobs));
        });
    }

    private static void Run(LabRun run, long first, long count, int jobs)
    {
        var outcomes = new MotionOutcome[count];
        run.Parallel(first, count, jobs, "scene", index => outcomes[index - first] = MotionDraw.Play(run.Seed, index));
        LabTable table = run.Table("Changes of motions between two steps", "scene", "scenes", "changes", "in steps that count events", "without an event", "verdict");
        foreach (IGrouping<string, MotionOutcome> kind in outcomes.GroupBy(outcome => outcome.Kind).OrderBy(kind => kind.Key, StringComparer.Ordinal))
        {
            table.Judge(
                kind.All(outcome => outcome.Missing == 0),
                kind.Key, kind.Count(), kind.Sum(outcome => outcome.Changes), kind.Sum(outcome => outcome.Uncounted), kind.Sum(outcome => outcome.Missing));
        }

        int failed = Array.FindIndex(outcomes, outcome => outcome.Missing > 0);
        if (failed >= 0)
        {
            run.Notes.Add(FormattableString.Invariant($"First failure: --scene {first + failed} --seed {run.Seed}: {outcomes[failed].First}."));
        }
    }
}
