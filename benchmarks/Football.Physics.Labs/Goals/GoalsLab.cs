using System.CommandLine;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Goals;

/// <summary>football lab goals: checks that every goal is reported, and nothing else.</summary>
internal static class GoalsLab
{
    public static Command Create(Terminal terminal)
    {
        Option<long> shots = Arguments.Whole("--shots", "Number of shots.", 1, 100_000_000, 300);
        return LabOptions.Create(
            "goals",
            "Random shots within 25 m of a goal, with rebounds: the goal event, compared with an independent check of the path.",
            ["football lab goals", "football lab goals --shots 200 --seed 7"],
            terminal,
            (parsed, seed, progress) => Run(seed, (int)parsed.GetValue(shots), progress),
            shots);
    }

    private static LabReport Run(long seed, int shots, Progress progress)
    {
        var count = new GoalCount();
        long first = -1;
        for (int i = 0; i < shots; i++)
        {
            int at = i;
            progress.Report(i, shots, () => FormattableString.Invariant($"shot {at}"));
            bool holds = count.Add(new SeededRandom(SeededRandom.Mix(seed, i)));
            first = !holds && first < 0 ? i : first;
        }

        var table = new LabTable("Goals", "of the shots", "count", "verdict");
        table.Add("shots", count.Shots, null);
        table.Add("reported goals", count.Reported, null);
        table.Add("after a post, a bar or a keeper", count.Rebounds, null);
        table.Add("along the ground over the line", count.Carried, null);
        table.Add("came to rest in a net", count.LieIn, null);
        table.Add("came to rest in a net, not reported", count.LieInUnreported, Verdict.Of(count.LieInUnreported == 0));
        table.Add("over the line by the sampled path, not reported", count.Missed, Verdict.Of(count.Missed == 0));
        table.Add("reported, and not by the sampled path, at another time, or twice", count.Wrong, Verdict.Of(count.Wrong == 0));
        table.Add("within a micrometre of post or bar, not judged", count.Undecided, null);
        table.Add("cut short", count.Cut, Verdict.Of(count.Cut == 0));
        var report = new LabReport { Name = "goals", Seed = seed, Tables = { table }, Failed = first >= 0 };
        if (first >= 0)
        {
            report.Notes.Add(FormattableString.Invariant($"First wrong result: shot {first}."));
        }

        return report;
    }
}
