using System.CommandLine;

namespace FootballPhysics.Labs.Rebounds;

/// <summary>football lab rebounds: balls that meet two or three objects in quick succession, against an event integrator of its own.</summary>
internal static class ReboundsLab
{
    public static Lab Create()
    {
        var lab = new Lab(
            "rebounds",
            "Second and third impacts within half a second, with objects of all kinds, against the impact law from event to event.",
            ["football lab rebounds --count 200"]);
        Option<long> count = lab.Whole("--count", "Number of meetings.", 1, 10_000_000, 10_000);
        Option<long> jobs = lab.Jobs("Threads.");
        Option<long?> one = lab.WholeOrNone("--meeting", "One meeting by its number.", 10_000_000);
        return lab.Plays(run => Run(run, run.Get(one) ?? 0, run.Get(one) is null ? run.Get(count) : 1, run.Int(jobs)));
    }

    private static void Run(LabRun run, long first, long count, int jobs)
    {
        ReboundOutcome[] all = run.Parallel(count, jobs, "meetings", i => MeetingPlay.Play(new SeededRandom(SeededRandom.Mix(run.Seed, first + i)), first + i));
        ReboundOutcome[] judged = [.. all.Where(item => item.LeftOut == ReboundLeftOut.None)];
        ReboundOutcome[] wrong = [.. judged.Where(item => item.Error > MeetingPlay.Tolerance).OrderByDescending(item => item.Error)];
        double leftOut = (double)(all.Length - judged.Length) / all.Length;
        LabTable table = run.Table("Second and third impacts", "what", "number", "verdict");
        table.Count("meetings", all.Length);
        table.Count("impacts", judged.Sum(item => item.Impacts));
        table.Count("impacts within 0.1 s after another", judged.Sum(item => item.Soon));
        table.Count("largest error of a velocity, m/s", judged.Length > 0 ? judged.Max(item => item.Error) : 0);
        table.Count("wrong", wrong.Length, wrong.Length == 0);
        foreach (ReboundLeftOut reason in Enum.GetValues<ReboundLeftOut>().Where(item => item != ReboundLeftOut.None))
        {
            table.Count($"left out: {reason switch { ReboundLeftOut.Squeezed => "squeezed", ReboundLeftOut.Endless => "endless, with room", _ => "a change of 1e-11 m changes the result" }}", all.Count(item => item.LeftOut == reason));
        }

        table.Count("left out, share", leftOut, leftOut <= 0.05 || all.Length == 1);
        run.Notes.AddRange(wrong.Take(6).Select(item => item.At));
    }
}
