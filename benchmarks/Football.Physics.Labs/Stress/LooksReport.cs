using FootballPhysics.Labs.Matches;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stress;

/// <summary>Simulates matches with and without look-aheads, and with kicks in time and late: the results must be bit-identical.</summary>
internal static class LooksReport
{
    /// <summary>The least number of late kicks of one match of <see cref="RollbackCounts"/>, including its share of the other kinds.</summary>
    private const long LateOfMatch = 1000;

    public static LabReport Run(long seed, long matches, double seconds, long late, int jobs, Progress progress)
    {
        var report = new LabReport { Name = "stress", Seed = seed };
        var outcomes = new LookMatch[matches];
        long done = 0;
        var gate = new Lock();
        Parallel.For(0L, matches, new ParallelOptions { MaxDegreeOfParallelism = jobs }, i =>
        {
            var match = new LookMatch(seed, i);
            match.Play(seconds);
            outcomes[i] = match;
            lock (gate)
            {
                progress.Report(++done, matches, () => "matches with look-aheads");
            }
        });
        var table = new LabTable(
            FormattableString.Invariant($"Matches of {seconds} s with and without look-aheads between ticks"),
            "matches", "ticks", "paths", "aims", "hits", "interceptions", "saves", "cache updates", "recomputed", "ticks that differ", "exceptions", "verdict");
        LookMatch[] apart = [.. outcomes.Where(match => match.Differ > 0 || match.Throws)];
        table.Add(
            matches, outcomes.Sum(o => o.Ticks), outcomes.Sum(o => o.Paths), outcomes.Sum(o => o.Aims), outcomes.Sum(o => o.Hits), outcomes.Sum(o => o.Interceptions),
            outcomes.Sum(o => o.Saves), outcomes.Sum(o => o.Updates), outcomes.Sum(o => o.Recomputed), apart.Sum(o => o.Differ), outcomes.Count(o => o.Throws), Verdict.Of(apart.Length == 0));
        report.Notes.AddRange(apart.Take(6).Select(match => match.FirstAt));
        int lateMatches = (int)((late + LateOfMatch - 1) / LateOfMatch);
        (LabTable rollbacks, bool holds) = RollbackCounts.Table(seed, lateMatches, progress, inHalls: true);
        report.Tables.AddRange([table, rollbacks]);
        report.Failed = apart.Length > 0 || !holds;
        return report;
    }
}
