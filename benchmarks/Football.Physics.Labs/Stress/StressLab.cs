using System.CommandLine;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stress;

/// <summary>football lab stress: matches in closed halls, look-aheads between ticks and late kicks, and bytes that no ball makes.</summary>
internal static class StressLab
{
    private const long Most = 1_000_000_000;

    public static Command Create(Terminal terminal)
    {
        Option<long> matches = Arguments.Whole("--matches", "Matches; of --looks half as many.", 1, Most, 2000);
        Option<long> seconds = Arguments.Whole("--seconds", "Length of a match, s.", 1, 3600, 12);
        Option<long> jobs = Arguments.Jobs("Threads.");
        Option<long> match = Arguments.Whole("--match", "One match only, by its number.", -1, Most, -1);
        var looks = new Option<bool>("--looks") { Description = "Matches with and without look-aheads between ticks, and late kicks against kicks in time." };
        Option<long> late = Arguments.Whole("--late", "Late kicks of --looks.", 1, Most, 10_000);
        var bytes = new Option<bool>("--bytes") { Description = "States, kick logs and recordings that were changed: rejected, or steps stay finite and short." };
        Option<long> count = Arguments.Whole("--count", "Inputs of every format of --bytes.", 1, Most, 1_000_000);
        return LabOptions.Create(
            "stress",
            "Matches of one to five balls with wind, crowds, masses and an engine's colliders at frames of 4 to 250 ms, checked by geometry of the lab's own.",
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
                return parsed.GetValue(match) is var one and >= 0 ? MatchesReport.Run(seed, one, 1, length, 1, progress)
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
