using System.CommandLine;

namespace FootballPhysics.Labs.People;

/// <summary>football lab people: a ball among players, boards, posts and nets, two of them at a time.</summary>
internal sealed class PeopleLab(LabRun run)
{
    private const long Most = 1_000_000;

    /// <summary>The number of cases that are simulated before any measurement, so that their code is compiled.</summary>
    private const int WarmUps = 60;

    /// <summary>The seed of the warm-up cases, which no measured case uses.</summary>
    private const long WarmUpSeed = -1;

    private readonly LabTable _steps = run.Table("Steps", "of the balls", "how many", "steps", "most events", "most evaluations", "slowest step, ms", "steps > 1 ms", "bytes", "verdict");
    private readonly LabTable _claims = run.Table("Claims", "what", "of", "count", "worst", "verdict");

    public static Lab Create()
    {
        var lab = new Lab(
            "people",
            "A ball among players, boards, posts and nets: no penetration of static objects, no gain of speed, bounded cost of a step.",
            [
                "football lab people",
                "football lab people --matches 30 --seconds 600 --presses 3000 --pinches 3000 --meetings 3000 --hits 3000",
            ]);
        Option<long> matches = lab.Whole("--matches", "Matches in a closed stadium.", 0, Most, 1);
        Option<long> seconds = lab.Whole("--seconds", "Length of a match in s.", 1, Most, 60);
        Option<long> presses = lab.Whole("--presses", "Balls pressed against boards, into corners, against posts, into nets.", 0, Most, 60);
        Option<long> pinches = lab.Whole("--pinches", "Balls that two players squeeze.", 0, Most, 60);
        Option<long> meetings = lab.Whole("--meetings", "Balls on open ground that one body runs into.", 0, Most, 60);
        Option<long> hits = lab.Whole("--hits", "Flat kicks into the edge of board and ground.", 0, Most, 60);
        return lab.Plays(run =>
        {
            var play = new PeopleLab(run);
            PressKind[] kinds = Enum.GetValues<PressKind>();
            foreach (PressKind kind in kinds)
            {
                play.Each("press", run.Int(presses), () => new Presses(kind), kinds.Length);
            }

            play.Each("pinch", run.Int(pinches), () => new Pinches());
            play.Each("meeting", run.Int(meetings), () => new Meetings());
            play.Each("hit", run.Int(hits), () => new FlatHits());
            play.Match(run.Int(matches), run.Get(seconds));
        });
    }

    private void Match(int count, double seconds)
    {
        if (count == 0)
        {
            return;
        }

        var matches = new StadiumMatches();
        new StadiumMatches().Play(WarmUpSeed, 0, Math.Min(seconds, WarmUps), _ => { });
        for (int i = 0; i < count; i++)
        {
            int index = i;
            matches.Play(run.Seed, i, seconds, time => run.Progress.Report((index * seconds) + time, count * seconds, () => FormattableString.Invariant($"match {index}, {time:0} s")));
        }

        Report(matches);
    }

    /// <summary>Simulates warm-up cases, and then the measured ones.</summary>
    private void Each(string name, int wanted, Func<PeopleCases> make, int kinds = 1)
    {
        if (wanted == 0)
        {
            return;
        }

        PeopleCases warmUp = make();
        PeopleCases cases = make();
        int count = wanted / kinds;
        for (int i = 0; i < Math.Min(count, WarmUps); i++)
        {
            warmUp.Play(WarmUpSeed, i);
        }

        run.Each(count, name, (_, i) => cases.Play(run.Seed, i));
        Report(cases);
    }

    private void Report(PeopleCases cases)
    {
        StepMeter meter = cases.Meter;
        string name = cases.Name;
        bool holds = meter.Events.Most <= StepMeter.MostAllowed && meter.Bytes == 0;
        _steps.Add(
            name, cases.Cases, meter.Steps, meter.Events.Most, meter.Evaluations.Most, 1000 * meter.Slowest.Most, meter.Slow, meter.Bytes, Verdict.Of(holds && meter.Slow == 0));

        // The run does not fail for a time: the machine may be busy.
        run.Failed |= !holds;
        if (meter.Events.Most > StepMeter.MostAllowed)
        {
            run.Notes.Add(FormattableString.Invariant($"{name}: {meter.Events.Most} events, {meter.Events.At}"));
        }

        if (meter.Slow > 0)
        {
            run.Notes.Add(FormattableString.Invariant($"{name}: {meter.Evaluations.Most} evaluations, {meter.Evaluations.At}"));
            run.Notes.Add(FormattableString.Invariant($"{name}: {1000 * meter.Slowest.Most:0.00} ms, {meter.Slowest.At}"));
        }

        foreach (PeopleClaim claim in cases.Claims)
        {
            claim.Report(_claims, run);
        }
    }
}
