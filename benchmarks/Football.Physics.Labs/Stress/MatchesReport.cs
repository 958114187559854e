using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stress;

/// <summary>Simulates the matches of the lab, and sums their outcomes.</summary>
internal static class MatchesReport
{
    /// <summary>The number of scenes listed per violated claim.</summary>
    private const int Shown = 6;

    private static readonly (MatchClaim Claim, string Name)[] s_claims =
    [
        (MatchClaim.Inside, "inside an object that never moves, m"),
        (MatchClaim.Goals, "goals not reported, reported wrongly or at another time"),
        (MatchClaim.Rests, "balls that do not come to rest"),
        (MatchClaim.Events, "more than 24 events of a ball in a step"),
        (MatchClaim.Stalled, "stalled steps"),
        (MatchClaim.Finite, "balls that are not finite"),
        (MatchClaim.Stays, "balls outside the hall"),
        (MatchClaim.Path, "the look-ahead of a step ends elsewhere, m"),
        (MatchClaim.Throws, "exceptions"),
    ];

    public static LabReport Run(long seed, long first, long matches, double seconds, int jobs, Progress progress)
    {
        var evaluations = new[] { new EvaluationCounts(), new EvaluationCounts() };
        var outcomes = new MatchOutcome[matches];
        long done = 0;
        var gate = new Lock();
        Parallel.For(0L, matches, new ParallelOptions { MaxDegreeOfParallelism = jobs }, i =>
        {
            MatchOutcome outcome = MatchPlay.Play(seed, first + i, seconds);
            evaluations[outcome.Balls > 1 ? 1 : 0].Add(outcome.Evaluations, outcome.MostEvaluations, outcome.MostEvaluationsAt);
            outcome.Evaluations.Clear();
            outcome.Evaluations.TrimExcess();
            outcomes[i] = outcome;
            lock (gate)
            {
                progress.Report(++done, matches, () => "matches");
            }
        });
        return Report(seed, seconds, outcomes, evaluations);
    }

    private static LabReport Report(long seed, double seconds, MatchOutcome[] outcomes, EvaluationCounts[] evaluations)
    {
        var report = new LabReport { Name = "stress", Seed = seed };
        var played = new LabTable(
            FormattableString.Invariant($"Matches of {seconds} s"), "matches", "balls", "steps", "kicks", "of balls in nets", "goals", "not judged", "balls that must rest", "latest rest, s", "most events", "counted only");
        played.Add(
            outcomes.Length, outcomes.Sum(o => o.Balls), outcomes.Sum(o => o.Steps), outcomes.Sum(o => o.Kicks), outcomes.Sum(o => o.KicksInNets), outcomes.Sum(o => o.Goals),
            outcomes.Sum(o => o.Undecided), outcomes.Sum(o => o.Resting), outcomes.Max(o => o.LatestRest), outcomes.Max(o => o.MostEvents), outcomes.Sum(o => o.UnreportedImpacts));
        var claims = new LabTable("Claims", "what", "count", "in matches", "worst", "at", "verdict");
        foreach ((MatchClaim claim, string name) in s_claims)
        {
            MatchOutcome worst = outcomes.MaxBy(o => o.Worst(claim))!;
            MatchOutcome[] broken = [.. outcomes.Where(o => o.Broken(claim) > 0)];
            claims.Add(name, broken.Sum(o => o.Broken(claim)), broken.Length, worst.Worst(claim), worst.Worst(claim) > 0 ? worst.At(claim) : null, Verdict.Of(broken.Length == 0));
            report.Failed |= broken.Length > 0;
            report.Notes.AddRange(broken.OrderByDescending(o => o.Worst(claim)).ThenBy(o => o.Index).Take(Shown).Select(o => $"{name}: {o.At(claim)}"));
        }

        LabTable steps = evaluations[0].Table("one");
        if (evaluations[1].Steps > 0)
        {
            steps.Rows.AddRange(evaluations[1].Table("several").Rows);
        }

        report.Failed |= evaluations.Any(counts => counts.Largest > EvaluationCounts.Most);
        report.Tables.AddRange([played, claims, steps]);
        return report;
    }
}
