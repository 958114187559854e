using System.CommandLine;

namespace FootballPhysics.Labs.Nets;

/// <summary>football lab nets: balls that are walked, kicked and pressed into nets, up to their ends.</summary>
internal static class NetsLab
{
    public static Lab Create()
    {
        var lab = new Lab(
            "nets",
            "Balls that are walked, kicked and pressed into and through nets: none is deeper than the net gives, none gains energy, and all come to rest.",
            ["football lab nets", "football lab nets --count 50 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Balls.", 1, 10_000_000, 1000);
        Option<long?> ball = lab.WholeOrNone("--ball", "One ball by its number.", long.MaxValue);
        Option<long> jobs = lab.Jobs("Threads.");
        return lab.Plays(run =>
        {
            long first = run.Get(ball) ?? 0;
            Run(run, first, run.Get(ball) is null ? run.Get(count) : 1, run.Int(jobs));
        });
    }

    private static void Run(LabRun run, long first, long count, int jobs)
    {
        var outcomes = new NetOutcome[count];
        run.Parallel(first, count, jobs, "ball", index => outcomes[index - first] = NetDraw.Play(run.Seed, index));
        LabTable table = run.Table(
            "Balls in nets", "play", "balls", "frames in a net", "at its end", "pinned", "deepest beyond the end, m", "worst gain of energy", "without rest", "stalled", "verdict");
        foreach (IGrouping<NetPlay, NetOutcome> play in outcomes.GroupBy(outcome => outcome.Play).OrderBy(play => play.Key))
        {
            table.Judge(
                play.All(outcome => outcome.Holds),
                play.Key, play.Count(), play.Sum(outcome => outcome.Frames), play.Sum(outcome => outcome.AtEnd), play.Sum(outcome => outcome.Pinned),
                play.Max(outcome => outcome.Beyond), play.Max(outcome => outcome.Gain), play.Count(outcome => !outcome.Rests), play.Sum(outcome => outcome.Stalled));
        }

        int failed = Array.FindIndex(outcomes, outcome => !outcome.Holds);
        if (failed >= 0)
        {
            run.Notes.Add(FormattableString.Invariant($"First failure: --ball {first + failed} --seed {run.Seed}: {outcomes[failed].First}."));
        }

        run.Notes.Add("The energy is that of the ball and of the stretched nets. It is compared over each frame in which no body is near the ball, relative to 1 J plus the energy before.");
    }
}
