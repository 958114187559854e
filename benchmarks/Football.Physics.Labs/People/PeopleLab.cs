using System.CommandLine;
using System.Globalization;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.People;

/// <summary>football lab people: a ball among players, boards, posts and nets, two of them at a time.</summary>
internal static class PeopleLab
{
    private const long Most = 1_000_000;

    /// <summary>The number of cases that are simulated before any measurement, so that their code is compiled.</summary>
    private const int WarmUps = 60;

    /// <summary>The seed of the warm-up cases, which no measured case uses.</summary>
    private const long WarmUpSeed = -1;

    private static readonly PressKind[] s_kinds = Enum.GetValues<PressKind>();

    public static Command Create(Terminal terminal)
    {
        Option<long> matches = Arguments.Whole("--matches", "Matches in a closed stadium.", 0, Most, 1);
        Option<long> seconds = Arguments.Whole("--seconds", "Length of a match in s.", 1, Most, 60);
        Option<long> presses = Arguments.Whole("--presses", "Balls pressed against boards, into corners, against posts, into nets.", 0, Most, 60);
        Option<long> pinches = Arguments.Whole("--pinches", "Balls that two players squeeze.", 0, Most, 60);
        Option<long> meetings = Arguments.Whole("--meetings", "Balls on open ground that one body runs into.", 0, Most, 60);
        Option<long> hits = Arguments.Whole("--hits", "Flat kicks into the edge of board and ground.", 0, Most, 60);
        return LabOptions.Create(
            "people",
            "A ball among players, boards, posts and nets: no penetration of static objects, no gain of speed, bounded cost of a step.",
            [
                "football lab people",
                "football lab people --matches 30 --seconds 600 --presses 3000 --pinches 3000 --meetings 3000 --hits 3000",
            ],
            terminal,
            (parsed, seed, progress) =>
            {
                var play = new Plays(seed, progress);
                return play.Run(
                    (int)parsed.GetValue(matches), parsed.GetValue(seconds), (int)parsed.GetValue(presses), (int)parsed.GetValue(pinches), (int)parsed.GetValue(meetings),
                    (int)parsed.GetValue(hits));
            },
            matches,
            seconds,
            presses,
            pinches,
            meetings,
            hits);
    }

    /// <summary>One run of the programs.</summary>
    private sealed class Plays(long seed, Progress progress)
    {
        private readonly LabTable _steps = new("Steps", "of the balls", "how many", "steps", "most events", "most evaluations", "slowest step, ms", "steps > 1 ms", "bytes", "verdict");
        private readonly LabTable _claims = new("Claims", "what", "of", "count", "worst", "verdict");
        private readonly LabReport _report = new() { Name = "people", Seed = seed };

        public LabReport Run(int matches, double seconds, int presses, int pinches, int meetings, int hits)
        {
            foreach (PressKind kind in presses > 0 ? s_kinds : [])
            {
                Each("press", presses / s_kinds.Length, () => new Presses(kind));
            }

            if (pinches > 0)
            {
                Each("pinch", pinches, () => new Pinches());
            }

            if (meetings > 0)
            {
                Each("meeting", meetings, () => new Meetings());
            }

            if (hits > 0)
            {
                Each("hit", hits, () => new FlatHits());
            }

            if (matches > 0)
            {
                Match(matches, seconds);
            }

            _report.Tables.AddRange([_steps, _claims]);
            return _report;
        }

        private void Match(int count, double seconds)
        {
            var matches = new StadiumMatches();
            new StadiumMatches().Play(WarmUpSeed, 0, Math.Min(seconds, WarmUps), _ => { });
            for (int i = 0; i < count; i++)
            {
                int index = i;
                matches.Play(seed, i, seconds, time => progress.Report(
                    (long)((index * seconds) + time), (long)(count * seconds), () => string.Create(CultureInfo.InvariantCulture, $"match {index}, {time:0} s")));
            }

            Report(matches);
        }

        /// <summary>Simulates warm-up cases, and then the measured ones.</summary>
        private void Each(string name, int count, Func<PeopleCases> make)
        {
            PeopleCases warmUp = make();
            PeopleCases cases = make();
            for (int i = 0; i < Math.Min(count, WarmUps); i++)
            {
                warmUp.Play(WarmUpSeed, i);
            }

            for (int i = 0; i < count; i++)
            {
                int index = i;
                progress.Report(i, count, () => FormattableString.Invariant($"{name} {index}"));
                cases.Play(seed, i);
            }

            Report(cases);
        }

        private void Report(PeopleCases cases)
        {
            StepMeter meter = cases.Meter;
            string name = cases.Name;
            bool holds = meter.MostEvents <= StepMeter.MostAllowed && meter.Bytes == 0;
            _steps.Add(name, cases.Cases, meter.Steps, meter.MostEvents, meter.MostEvaluations, 1000 * meter.Slowest, meter.Slow, meter.Bytes, Verdict.Of(holds && meter.Slow == 0));

            // The run does not fail for a time: the machine may be busy.
            _report.Failed |= !holds;
            if (meter.MostEvents > StepMeter.MostAllowed)
            {
                _report.Notes.Add(FormattableString.Invariant($"{name}: {meter.MostEvents} events, {meter.MostEventsAt}"));
            }

            if (meter.Slow > 0)
            {
                _report.Notes.Add(FormattableString.Invariant($"{name}: {meter.MostEvaluations} evaluations, {meter.MostEvaluationsAt}"));
                _report.Notes.Add(FormattableString.Invariant($"{name}: {1000 * meter.Slowest:0.00} ms, {meter.SlowestAt}"));
            }

            foreach (PeopleClaim claim in cases.Claims)
            {
                claim.Report(_claims, _report);
            }
        }
    }
}
