using System.CommandLine;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Matches;

/// <summary>football lab matches: players in time, touches at a player's feet, impacts between objects with a mass, several balls.</summary>
internal static class MatchesLab
{
    public static Command Create(Terminal terminal)
    {
        Option<long> count = Arguments.Whole("--count", "Number of matches, dribbles, first-time shots and traps each.", 1, 1_000_000, 1000);
        Option<long> impacts = Arguments.Whole("--impacts", "Number of impacts to check.", 1, 1_000_000_000, 1_000_000);
        var only = new Option<string?>("--only") { HelpName = "PART", Description = "Run one part: rollbacks, dribbles, shots, traps, impacts, cost, jumps." };
        only.AcceptOnlyFromAmong("rollbacks", "dribbles", "shots", "traps", "impacts", "cost", "jumps");
        return LabOptions.Create(
            "matches",
            "Rollbacks of late kicks at four frame rates; dribbles, first-time shots and traps; energy and momentum of impacts; cost of fifty balls and of a jump in a recording.",
            ["football lab matches --count 20 --impacts 10000", "football lab matches --only dribbles --count 200 --seed 7"],
            terminal,
            (parsed, seed, progress) => Run(seed, (int)parsed.GetValue(count), parsed.GetValue(impacts), parsed.GetValue(only), progress),
            count,
            impacts,
            only);
    }

    private static LabReport Run(long seed, int count, long impacts, string? only, Progress progress)
    {
        var report = new LabReport { Name = "matches", Seed = seed };
        Add("rollbacks", () => RollbackCounts.Table(seed, count, progress));
        Add("dribbles", () => DribbleCounts.Table(seed, count, progress));
        Add("shots", () => FirstTimeCounts.Table(seed, count, progress));
        Add("traps", () => TrapCounts.Table(seed, count, progress));
        Add("impacts", () => ImpactBalances.Table(seed, impacts, progress));
        Add("cost", () => (SeveralCost.Table(seed), true)); // a time is no reason to fail: the machine may be busy
        Add("jumps", () => JumpCost.Table(seed));
        return report;

        void Add(string part, Func<(LabTable Table, bool Holds)> make)
        {
            if (only is null || only == part)
            {
                (LabTable table, bool holds) = make();
                report.Tables.Add(table);
                report.Failed |= !holds;
            }
        }
    }
}
