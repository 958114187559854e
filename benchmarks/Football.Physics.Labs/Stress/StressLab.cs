using System.CommandLine;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stress;

/// <summary>football lab stress: matches in closed halls, look-aheads between ticks and late kicks, and bytes that no valid state has.</summary>
internal static class StressLab
{
    private const long Most = 1_000_000_000;

    public static Command Create(Terminal terminal)
    {
        Option<long> matches = Arguments.Whole("--matches", "Number of matches; half as many with --looks.", 1, Most, 2000);
        Option<long> seconds = Arguments.Whole("--seconds", "Length of a match in s.", 1, 3600, 12);
        Option<long> jobs = Arguments.Jobs("Threads.");
        Option<long?> match = Arguments.Whole("--match", "One match by its number.", 0, Most);
        var looks = new Option<bool>("--looks") { Description = "Matches with and without look-aheads between ticks, and late kicks compared with punctual ones." };
        Option<long> late = Arguments.Whole("--late", "Number of late kicks, with --looks.", 1, Most, 10_000);
        var bytes = new Option<bool>("--bytes") { Description = "Corrupted states, kick logs and recordings: they are rejected, or steps stay finite and short." };
        Option<long> count = Arguments.Whole("--count", "Inputs of each format, with --bytes.", 1, Most, 1_000_000);
        return LabOptions.Create(
            "stress",
            "Matches of one to five balls with wind, crowds, movable obstacles and engine colliders, in frames of 4 to 250 ms, checked by independent geometry.",
            ["football lab stress --matches 10 --seconds 4", "football lab stress --looks --matches 6 --seconds 3 --late 200", "football lab stress --bytes --count 500"],
            terminal,
            (parsed, seed, progress) =>
            {
                bool looksAhead = parsed.GetValue(looks);
                bool readsBytes = parsed.GetValue(bytes);
                if (looksAhead && readsBytes)
                {
                    throw new RefusedException("--looks and --bytes are two runs. Give one of them.");
                }

                int threads = (int)parsed.GetValue(jobs);
                long number = parsed.GetValue(matches);
                double length = parsed.GetValue(seconds);
                return parsed.GetValue(match) is { } one ? MatchesReport.Run(seed, one, 1, length, 1, progress)
                    : looksAhead ? LooksReport.Run(seed, (number + 1) / 2, length, parsed.GetValue(late), threads, progress)
                    : readsBytes ? BytesReport.Run(seed, parsed.GetValue(count), threads, progress)
                    : MatchesReport.Run(seed, 0, number, length, threads, progress);
            },
            matches,
            seconds,
            jobs,
            match,
            looks,
            late,
            bytes,
            count);
    }
}
