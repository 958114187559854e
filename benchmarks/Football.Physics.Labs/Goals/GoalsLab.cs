using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Goals;

/// <summary>football lab goals: checks that every goal is reported, and nothing else.</summary>
internal static class GoalsLab
{
    /// <summary>The rows of the table, and whether they must be 0.</summary>
    private static readonly (string Row, bool IsFault)[] s_rows =
    [
        (GoalCount.Shots, false), (GoalCount.Reported, false), (GoalCount.Rebounds, false), (GoalCount.Carried, false), (GoalCount.LieIn, false), (GoalCount.LieInUnreported, true),
        (GoalCount.Missed, true), (GoalCount.Wrong, true), (GoalCount.Undecided, false), (GoalCount.Cut, true),
    ];

    public static Command Create(Terminal terminal)
    {
        var lab = new Lab(
            "goals",
            "Random shots within 25 m of a goal, with rebounds: the goal event, compared with an independent check of the path.",
            ["football lab goals", "football lab goals --shots 200 --seed 7"]);
        Option<long> shots = lab.Whole("--shots", "Number of shots.", 1, 100_000_000, 300);
        return lab.Command(terminal, run => Run(run, run.Int(shots)));
    }

    private static void Run(LabRun run, int shots)
    {
        var goals = new GoalCount();
        int first = -1;
        run.Each(shots, "shot", (random, i) => first = !goals.Add(random) && first < 0 ? i : first);
        goals.Counts.AddTo(run.Table("Goals", "of the shots", "count", "verdict"), s_rows);
        run.Failed = first >= 0;
        if (first >= 0)
        {
            run.Notes.Add(FormattableString.Invariant($"First wrong result: shot {first}."));
        }
    }
}
