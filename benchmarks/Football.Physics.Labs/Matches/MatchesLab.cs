using System.CommandLine;

namespace FootballPhysics.Labs.Matches;

/// <summary>football lab matches: players in time, touches at a player's feet, impacts between objects with a mass, several balls.</summary>
internal static class MatchesLab
{
    public static Lab Create()
    {
        var lab = new Lab(
            "matches",
            "Rollbacks of late kicks at four frame rates; dribbles, first-time shots and traps; energy and momentum of impacts; cost of fifty balls and of a jump in a recording.",
            ["football lab matches --count 20 --impacts 10000", "football lab matches --only dribbles --count 200 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Number of matches, dribbles, first-time shots and traps each.", 1, 1_000_000, 1000);
        Option<long> impacts = lab.Whole("--impacts", "Number of impacts to check.", 1, 1_000_000_000, 1_000_000);
        Option<string?> only = lab.Only("PART", "Run one part", ["rollbacks", "dribbles", "shots", "traps", "impacts", "cost", "jumps"]);
        return lab.Plays(run => Run(run, run.Int(count), run.Get(impacts), run.Get(only)));
    }

    private static void Run(LabRun run, int count, long impacts, string? only)
    {
        foreach ((string part, Action play) in new (string, Action)[]
        {
            ("rollbacks", () => RollbackCounts.Play(run, count)),
            ("dribbles", () => new TouchCounts(run, count).Dribbles()),
            ("shots", () => new TouchCounts(run, count).FirstTimeShots()),
            ("traps", () => new TouchCounts(run, count).Traps()),
            ("impacts", () => ImpactBalances.Play(run, impacts)),
            ("cost", () => SeveralCost.Play(run)),
            ("jumps", () => JumpCost.Play(run)),
        })
        {
            if (only is null || only == part)
            {
                play();
            }
        }
    }
}
