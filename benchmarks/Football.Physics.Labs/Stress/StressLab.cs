using System.CommandLine;
using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Labs.Matches;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Labs.Stress;

/// <summary>football lab stress: matches in closed halls, look-aheads between ticks and late kicks, and bytes that no valid state has.</summary>
internal static class StressLab
{
    private const long Most = 1_000_000_000;

    /// <summary>The least number of late kicks of one match of <see cref="RollbackCounts"/>, including its share of the other kinds.</summary>
    private const long LateOfMatch = 1000;

    /// <summary>The formats of bytes that are changed: they are rejected, or the steps that follow are finite and short.</summary>
    private static IReadOnlyList<FuzzTarget> Formats { get; } =
        [new StateBytes(isMemory: false), new StateBytes(isMemory: true), new WireBytes(), new KickBytesPlayed(), new SegmentFuzz(HallScenes.All)];

    public static Lab Create()
    {
        var lab = new Lab(
            "stress",
            "Matches of one to five balls with wind, crowds, movable obstacles and engine colliders, in frames of 4 to 250 ms, checked by independent geometry.",
            ["football lab stress --matches 10 --seconds 4", "football lab stress --looks --matches 6 --seconds 3 --late 200", "football lab stress --bytes --count 500"]);
        Option<long> matches = lab.Whole("--matches", "Number of matches; half as many with --looks.", 1, Most, 2000);
        Option<long> seconds = lab.Whole("--seconds", "Length of a match in s.", 1, 3600, 12);
        Option<long> jobs = lab.Jobs("Threads.");
        Option<long?> match = lab.WholeOrNone("--match", "One match by its number.", Most);
        Option<bool> looks = lab.Flag("--looks", "Matches with and without look-aheads between ticks, and late kicks compared with punctual ones.");
        Option<long> late = lab.Whole("--late", "Number of late kicks, with --looks.", 1, Most, 10_000);
        Option<bool> bytes = lab.Flag("--bytes", "Corrupted states, kick logs and recordings: they are rejected, or steps stay finite and short.");
        Option<long> count = lab.Whole("--count", "Inputs of each format, with --bytes.", 1, Most, 1_000_000);
        return lab.Plays(run =>
        {
            if (run.Get(looks) && run.Get(bytes))
            {
                throw new RefusedException("--looks and --bytes are two runs. Give one of them.");
            }

            double length = run.Get(seconds);
            if (run.Get(match) is { } one)
            {
                MatchesReport.Run(run, one, 1, length, 1);
            }
            else if (run.Get(looks))
            {
                Looks(run, (run.Get(matches) + 1) / 2, length, run.Get(late), run.Int(jobs));
            }
            else if (run.Get(bytes))
            {
                FuzzLab.Run(run, run.Get(count), run.Int(jobs), Formats);
            }
            else
            {
                MatchesReport.Run(run, 0, run.Get(matches), length, run.Int(jobs));
            }
        });
    }

    /// <summary>Simulates matches with and without look-aheads, and with kicks in time and late: the results must be bit-identical.</summary>
    private static void Looks(LabRun run, long matches, double seconds, long late, int jobs)
    {
        var counts = new LabCounts();
        string[] wrong = [.. run.Parallel(matches, jobs, "matches with look-aheads", i => new LookMatch(run.Seed, i, counts).Play(seconds)).Where(at => at.Length > 0)];
        run.Table(FormattableString.Invariant($"Matches of {seconds} s with and without look-aheads between ticks"), ["matches", .. LookMatch.Columns, "verdict"])
            .Judge(wrong.Length == 0, [matches, .. counts.Cells(LookMatch.Columns)]);
        run.Notes.AddRange(wrong.Take(6));
        RollbackCounts.Play(run, (int)((late + LateOfMatch - 1) / LateOfMatch), inHalls: true);
    }
}
