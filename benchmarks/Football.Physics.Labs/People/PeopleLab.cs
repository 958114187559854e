using System.CommandLine;
using System.Globalization;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.People;

/// <summary>football lab people: a ball among players, boards, posts and nets, two of them at a time.</summary>
internal static class PeopleLab
{
    private const long Most = 1_000_000;

    /// <summary>Cases that are played before any is measured: their code is compiled then.</summary>
    private const int WarmUps = 60;

    /// <summary>Seeds of those: no case that counts is among them.</summary>
    private const long WarmUpSeed = -1;

    /// <summary>Deeper, m, is inside.</summary>
    private const double Entered = 1e-6;

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
            if (presses > 0)
            {
                Press(presses);
            }

            if (pinches > 0)
            {
                Pinch(pinches);
            }

            if (meetings > 0)
            {
                Meet(meetings);
            }

            if (hits > 0)
            {
                Hit(hits);
            }

            if (matches > 0)
            {
                Match(matches, seconds);
            }

            _report.Tables.AddRange([_steps, _claims]);
            return _report;
        }

        private void Press(int count)
        {
            foreach (PressKind kind in s_kinds)
            {
                var presses = new Presses(kind);
                Each("press", count / s_kinds.Length, new Presses(kind).Play, presses.Play);
                string name = FormattableString.Invariant($"pressed: {kind}");
                Step(name, presses.Cases, presses.Meter);
                Claim(FormattableString.Invariant($"{name}: a frame ends inside what stands still, m"), presses.Cases, presses.Inside, presses.Deepest, presses.Inside == 0, presses.DeepestAt);
                Claim(FormattableString.Invariant($"{name}: ends behind a board"), presses.Cases, presses.Behind, null, presses.Behind == 0);
            }
        }

        private void Pinch(int count)
        {
            var pinches = new Pinches();
            Each("pinch", count, new Pinches().Play, pinches.Play);
            Step("between two players", pinches.Cases, pinches.Meter);
            Claim("pinched: faster than it may be, share", pinches.Cases, pinches.TooFast, pinches.MostShare, pinches.TooFast == 0, pinches.MostShareAt);
            Claim("pinched: faster than 20 m/s, m/s", pinches.Cases, pinches.Beyond20, pinches.Fastest, null);
            Claim("pinched: squeezed", pinches.Cases, pinches.Squeezed, null, null);
            Claim("pinched: squeezed when the players have passed", pinches.Cases, pinches.Unending, null, pinches.Unending == 0, pinches.UnendingAt);
            Claim("pinched: in the ground, m", pinches.Cases, pinches.Deepest > Entered ? 1 : 0, pinches.Deepest, pinches.Deepest <= Entered);
        }

        private void Meet(int count)
        {
            var meetings = new Meetings();
            Each("meeting", count, new Meetings().Play, meetings.Play);
            Step("one thing and a ball", meetings.Cases, meetings.Meter);
            Claim("met by one: faster than a rigid hit explains", meetings.Meter.Steps, meetings.TooFast, null, meetings.TooFast == 0);
            Claim("met by one: in the ground, m", meetings.Cases, meetings.Deepest > Entered ? 1 : 0, meetings.Deepest, meetings.Deepest <= Entered);
            Claim("met by one: in what moves, m", meetings.Cases, null, meetings.Overlap, null, meetings.OverlapAt);
        }

        private void Hit(int count)
        {
            var hits = new FlatHits();
            Each("hit", count, new FlatHits().Play, hits.Play);
            Step("flat into an edge", hits.Cases, hits.Meter);
            Claim("flat into an edge: slides in it for more than 2 s", hits.Cases, hits.SlidLong, null, hits.SlidLong == 0, hits.SlidLongAt);
            Claim("flat into an edge: not at rest after 90 s; the longest, s", hits.Cases, hits.Restless, hits.Longer, hits.Restless == 0);
            Claim("flat into an edge: at rest later than with its energy on open ground, s", hits.Cases, hits.Later, hits.Latest, hits.Later == 0, hits.LatestAt);
            Claim("flat into an edge: at rest later than from its last hit on open ground, s", hits.Cases, hits.SpinLater, hits.MostSpinLater, null);
            Claim("flat into an edge: at rest later than from the kick on open ground, s", hits.Cases, hits.Turned, hits.MostTurned, null, hits.MostTurnedAt);
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

            Step("matches", matches.Cases, matches.Meter);
            Claim("matches: kicks", matches.Cases, matches.Kicks, null, null);
            Claim("matches: goals", matches.Cases, matches.Goals, null, null);
            Claim("matches: squeezes", matches.Cases, matches.Squeezes, null, null);
            Claim("matches: inside what stands still, m", matches.Places, matches.Inside, matches.Deepest, matches.Inside == 0, matches.DeepestAt);
            Claim("matches: the ball left the stadium", matches.Cases, matches.Left, null, matches.Left == 0);
            Claim("matches: energy from nothing, share", matches.Alone, matches.Made, matches.MostMade, matches.Made == 0, matches.MostMadeAt);
            Claim("matches: look-ahead of a step goes elsewhere", matches.Meter.Steps, matches.Elsewhere, null, matches.Elsewhere == 0, matches.ElsewhereAt);
            Claim("matches: played again goes elsewhere", matches.Rewound, matches.RewoundElsewhere, null, matches.RewoundElsewhere == 0, matches.RewoundElsewhereAt);
            Claim("matches: dead ball hangs still in a net", matches.Dead, matches.Hung, null, null);
            Claim("matches: dead ball not at rest in 19 s", matches.Dead, matches.Restless, null, matches.Restless == 0, matches.RestlessAt);
        }

        /// <summary>Cases that warm up, and those that count.</summary>
        private void Each(string name, int count, Action<long, int> warmUp, Action<long, int> play)
        {
            for (int i = 0; i < Math.Min(count, WarmUps); i++)
            {
                warmUp(WarmUpSeed, i);
            }

            for (int i = 0; i < count; i++)
            {
                int index = i;
                progress.Report(i, count, () => FormattableString.Invariant($"{name} {index}"));
                play(seed, i);
            }
        }

        private void Step(string name, int cases, StepMeter meter)
        {
            bool holds = meter.MostEvents <= StepMeter.MostAllowed && meter.Bytes == 0;
            _steps.Add(name, cases, meter.Steps, meter.MostEvents, meter.MostEvaluations, 1000 * meter.Slowest, meter.Slow, meter.Bytes, Verdict.Of(holds && meter.Slow == 0));

            // A time is no reason to fail: the machine may be busy.
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
        }

        private void Claim(string what, long of, long? count, double? worst, bool? holds, string at = "")
        {
            _claims.Add(what, of, count, worst, holds is { } reached ? Verdict.Of(reached) : null);
            _report.Failed |= holds == false;
            if (holds != true && at.Length > 0)
            {
                _report.Notes.Add(FormattableString.Invariant($"{what}: {at}"));
            }
        }
    }
}
