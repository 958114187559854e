namespace FootballPhysics.Labs.Stress;

/// <summary>Simulates the matches of the lab, and sums their outcomes.</summary>
internal static class MatchesReport
{
    private static readonly string[] s_columns =
        ["matches", "balls", "steps", "kicks", "of balls in nets", "goals", "not judged", "balls that must rest", "latest rest, s", "most events", "counted only"];

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

    public static void Run(LabRun run, long first, long matches, double seconds, int jobs)
    {
        EvaluationCounts[] evaluations = [new(), new()];
        var counts = new LabCounts();
        MatchOutcome[] outcomes = run.Parallel(matches, jobs, "matches", i =>
        {
            MatchOutcome outcome = MatchPlay.Play(run.Seed, first + i, seconds, counts);
            evaluations[outcome.Balls > 1 ? 1 : 0].Add(outcome);
            return outcome;
        });
        run.Table(FormattableString.Invariant($"Matches of {seconds} s"), s_columns).Add([.. counts.Cells(s_columns)]);
        LabTable claims = run.Table("Claims", "what", "count", "in matches", "worst", "at", "verdict");
        foreach ((MatchClaim claim, string name) in s_claims)
        {
            MatchOutcome worst = outcomes.MaxBy(o => o.Worst(claim))!;
            MatchOutcome[] broken = [.. outcomes.Where(o => o.Broken(claim) > 0)];
            claims.Judge(broken.Length == 0, name, broken.Sum(o => o.Broken(claim)), broken.Length, worst.Worst(claim), worst.Worst(claim) > 0 ? worst.At(claim) : null);
            run.Notes.AddRange(broken.OrderByDescending(o => o.Worst(claim)).ThenBy(o => o.Index).Take(Shown).Select(o => $"{name}: {o.At(claim)}"));
        }

        LabTable steps = run.Table("Evaluations of a step", "balls", "steps", "median", "99 %", "99.99 %", "most", "at", "verdict");
        evaluations[0].AddTo(steps, "one");
        if (evaluations[1].Steps > 0)
        {
            evaluations[1].AddTo(steps, "several");
        }
    }
}
