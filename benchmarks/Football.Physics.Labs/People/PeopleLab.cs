using System.CommandLine;
using System.Diagnostics;

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

/// <summary>The parts of a claim that a table shows.</summary>
[Flags]
internal enum ClaimParts
{
    Count = 1,
    Worst = 2,

    /// <summary>The claim fails if its count is not 0.</summary>
    Verdict = 4,
}

/// <summary>A claim over many cases: the number of violations, the worst size, and its scene.</summary>
internal sealed class PeopleClaim(string what, ClaimParts parts = ClaimParts.Count | ClaimParts.Verdict)
{
    private string _at = "";

    /// <summary>The number of cases, and the number that violate the claim.</summary>
    public long Of { get; private set; }

    public long Count { get; private set; }

    public double Worst { get; private set; }

    public bool Holds => !parts.HasFlag(ClaimParts.Verdict) || Count == 0;

    /// <summary>Adds a case.</summary>
    public void Case(bool isBroken, FormattableString? at = null)
    {
        Of++;
        Count += isBroken ? 1 : 0;
        _at = isBroken && at is not null ? FormattableString.Invariant(at) : _at;
    }

    /// <summary>Adds a number of cases.</summary>
    public void Add(long count)
    {
        Of++;
        Count += count;
    }

    /// <summary>Keeps a size if it is the worst so far.</summary>
    public void See(double size, FormattableString? at = null)
    {
        if (size > Worst)
        {
            Worst = size;
            _at = at is not null ? FormattableString.Invariant(at) : _at;
        }
    }

    /// <summary>Adds a case with a size, which violates the claim if it is larger than a limit.</summary>
    public void Judge(double size, double limit, FormattableString? at = null)
    {
        See(size, at);
        Case(size > limit);
    }

    /// <summary>Adds its row.</summary>
    public void Report(LabTable table, LabRun run)
    {
        table.Add(
            what, Of, parts.HasFlag(ClaimParts.Count) ? Count : null, parts.HasFlag(ClaimParts.Worst) ? Worst : null,
            parts.HasFlag(ClaimParts.Verdict) ? Verdict.Of(Holds) : null);
        run.Failed |= !Holds;
        if (_at.Length > 0 && (!Holds || !parts.HasFlag(ClaimParts.Verdict)))
        {
            run.Notes.Add(FormattableString.Invariant($"{what}: {_at}"));
        }
    }
}

/// <summary>Cases of one kind, and their claims.</summary>
/// <param name="name">The name of its balls in the table.</param>
internal abstract class PeopleCases(string name)
{
    protected const double Radius = 0.11;

    /// <summary>A ball that is deeper than this, m, is inside.</summary>
    protected const double Entered = 1e-6;

    public string Name => name;

    public StepMeter Meter { get; } = new();

    public int Cases { get; protected set; }

    public abstract PeopleClaim[] Claims { get; }

    /// <summary>Simulates a case.</summary>
    public abstract void Play(long seed, int index);
}

/// <summary>Steps balls and records the largest cost of a step: time, memory, events.</summary>
internal sealed class StepMeter
{
    /// <summary>A step that takes longer, s, is repeated: another program may have delayed it.</summary>
    private const double Suspicious = 0.0005;
    private const int Repeats = 2;

    private readonly StepLog _again = new();

    /// <summary>The time limit of a step, s.</summary>
    public const double Longest = 0.001;

    /// <summary>The limit of events per step.</summary>
    public const int MostAllowed = 24;

    public long Steps { get; private set; }

    /// <summary>The slowest step, best of three from the same state, s.</summary>
    public Peak<double, FormattableString> Slowest { get; } = new($"");

    /// <summary>The number of steps that took longer than a millisecond.</summary>
    public long Slow { get; private set; }

    /// <summary>The number of bytes that all steps allocated.</summary>
    public long Bytes { get; private set; }

    public Peak<int, FormattableString> Events { get; } = new($"");

    /// <summary>The largest number of evaluations of the right-hand side in a step: its work, independent of other programs.</summary>
    public Peak<long, FormattableString> Evaluations { get; } = new($"");

    /// <summary>Runs one step.</summary>
    public void Step(Ball ball, double duration, FormattableString at)
    {
        BallState start = ball.State;
        long bytes = GC.GetAllocatedBytesForCurrentThread();
        long began = Stopwatch.GetTimestamp();
        ball.Step(duration);
        double took = Stopwatch.GetElapsedTime(began).TotalSeconds;
        Bytes += GC.GetAllocatedBytesForCurrentThread() - bytes;
        for (int i = 0; i < Repeats && took > Suspicious; i++)
        {
            BallState state = start;
            _again.Clear();
            began = Stopwatch.GetTimestamp();
            ball.Simulator.Step(ref state, duration, _again);
            took = Math.Min(took, Stopwatch.GetElapsedTime(began).TotalSeconds);
        }

        Steps++;
        Slow += took > Longest ? 1 : 0;
        Slowest.See(took, at);
        BallState counted = start;
        _again.Clear();
        ball.Simulator.Step(ref counted, duration, _again);
        Evaluations.See(_again.Evaluations, at);
        Events.See(ball.Events.Count, at);
    }
}
