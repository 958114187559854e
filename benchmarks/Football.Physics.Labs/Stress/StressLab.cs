using System.CommandLine;
using FootballPhysics.Labs.Fuzz;
using FootballPhysics.Labs.Matches;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Labs.Stress;

/// <summary>football lab stress: matches in closed halls, look-aheads between ticks and late kicks, steps in fresh simulators, and bytes that no valid state has.</summary>
internal static class StressLab
{
    private const long Most = 1_000_000_000;

    /// <summary>The least number of late kicks of one match of <see cref="RollbackCounts"/>, including its share of the other kinds.</summary>
    private const long LateOfMatch = 1000;

    /// <summary>The number of matches with --asked.</summary>
    private const long AskedMatches = 300;

    /// <summary>The least share of the steps in which a body that turns is near a ball.</summary>
    private const double LeastNear = 0.5;

    /// <summary>The formats of bytes that are changed: they are rejected, or the steps that follow are finite and short.</summary>
    private static IReadOnlyList<FuzzTarget> Formats { get; } =
        [new StateBytes(isMemory: false), new StateBytes(isMemory: true), new WireBytes(), new KickBytesPlayed(), new SegmentFuzz(HallScenes.All)];

    public static Lab Create()
    {
        var lab = new Lab(
            "stress",
            "Matches of one to five balls with wind, crowds, movable obstacles and engine colliders, in frames of 4 to 250 ms, checked by independent geometry.",
            ["football lab stress --matches 10 --seconds 4", "football lab stress --looks --matches 6 --seconds 3 --late 200", "football lab stress --asked --matches 5 --seconds 3", "football lab stress --bytes --count 500"]);
        Option<long> matches = lab.Whole("--matches", "Number of matches; half as many with --looks; default 300 with --asked.", 1, Most, 2000);
        Option<long> seconds = lab.Whole("--seconds", "Length of a match in s.", 1, 3600, 12);
        Option<long> jobs = lab.Jobs("Threads.");
        Option<long?> match = lab.WholeOrNone("--match", "One match by its number.", Most);
        Option<bool> looks = lab.Flag("--looks", "Matches with and without look-aheads between ticks, and late kicks compared with punctual ones.");
        Option<long> late = lab.Whole("--late", "Number of late kicks, with --looks.", 1, Most, 10_000);
        Option<bool> asked = lab.Flag("--asked", "Paths, aims, restores and recordings before each step, which is also taken in a fresh simulator.");
        Option<bool> times = lab.Flag("--times", "Repeat steps above 1 ms of processor time, and judge their share.");
        Option<bool> bytes = lab.Flag("--bytes", "Corrupted states, kick logs and recordings: they are rejected, or steps stay finite and short.");
        Option<long> count = lab.Whole("--count", "Inputs of each format, with --bytes.", 1, Most, 1_000_000);
        return lab.Plays(run =>
        {
            if (new[] { looks, asked, bytes, times }.Count(flag => run.Get(flag)) > 1)
            {
                throw new RefusedException("--looks, --asked, --bytes and --times are separate runs. Give one of them.");
            }

            double length = run.Get(seconds);
            if (run.Get(asked))
            {
                Asked(run, run.Get(match) ?? 0, run.Get(match) is null ? run.Has(matches) ? run.Get(matches) : AskedMatches : 1, length, run.Int(jobs));
            }
            else if (run.Get(match) is { } one)
            {
                MatchesReport.Run(run, one, 1, length, 1, run.Get(times));
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
                MatchesReport.Run(run, 0, run.Get(matches), length, run.Int(jobs), run.Get(times));
            }
        });
    }

    /// <summary>Simulates matches with questions before each step, and each step also in a fresh simulator: the results must be bit-identical.</summary>
    private static void Asked(LabRun run, long first, long matches, double seconds, int jobs)
    {
        var counts = new LabCounts();
        string[] wrong = [.. run.Parallel(matches, jobs, "matches that are asked", i => new AskedMatch(run.Seed, first + i, counts).Play(seconds)).Where(at => at.Length > 0)];
        double near = (double)counts["near a body that turns"] / Math.Max(1, counts["steps"]);
        string[] columns = [.. AskedMatch.Columns];
        run.Table(FormattableString.Invariant($"Matches of {seconds} s, asked before each step, and each step in a fresh simulator"), ["matches", .. columns, "share of steps near a body that turns", "verdict"])
            .Judge(wrong.Length == 0 && near >= LeastNear, [matches, .. counts.Cells(columns), near]);
        run.Notes.AddRange(wrong.Take(6));
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

    public static void Run(LabRun run, long first, long matches, double seconds, int jobs, bool times)
    {
        var slow = new StepTimes();
        EvaluationCounts[] evaluations = [new(), new()];
        var counts = new LabCounts();
        MatchOutcome[] outcomes = run.Parallel(matches, jobs, "matches", i =>
        {
            MatchOutcome outcome = MatchPlay.Play(run.Seed, first + i, seconds, counts, times);
            slow.Add(outcome);
            evaluations[outcome.Balls > 1 ? 1 : 0].Add(outcome);
            return outcome;
        });
        run.Table(FormattableString.Invariant($"Matches of {seconds} s"), s_columns).Add([.. counts.Cells(s_columns)]);
        LabTable claims = run.Table("Claims", "what", "count", "in matches", "worst", "at", "verdict");
        foreach ((MatchClaim claim, string name) in s_claims)
        {
            MatchOutcome worst = outcomes.MaxBy(o => o[claim].Worst)!;
            MatchOutcome[] broken = [.. outcomes.Where(o => o[claim].Broken > 0)];
            claims.Judge(broken.Length == 0, name, broken.Sum(o => o[claim].Broken), broken.Length, worst[claim].Worst, worst[claim].Worst > 0 ? worst[claim].At : null);
            run.Notes.AddRange(broken.OrderByDescending(o => o[claim].Worst).ThenBy(o => o.Index).Take(Shown).Select(o => $"{name}: {o[claim].At}"));
        }

        LabTable steps = run.Table("Evaluations of a step", "balls", "steps", "median", "99 %", "99.99 %", "most", "at", "verdict");
        evaluations[0].AddTo(steps, "one");
        if (evaluations[1].Steps > 0)
        {
            evaluations[1].AddTo(steps, "several");
        }

        if (times)
        {
            slow.AddTo(run);
        }
    }
}

/// <summary>One of the claims that a match is checked against.</summary>
internal enum MatchClaim
{
    Inside,
    Goals,
    Rests,
    Events,
    Stalled,
    Finite,
    Stays,
    Path,
    Throws,
}

/// <summary>The claims of one match, and the work of its steps.</summary>
internal sealed class MatchOutcome(long index)
{
    private readonly (long Broken, double Worst, string At)[] _claims = [.. Enum.GetValues<MatchClaim>().Select(_ => (0L, 0.0, ""))];

    public long Index => index;

    public int Balls { get; init; }

    /// <summary>The evaluations of each step, per ball.</summary>
    public List<int> Evaluations { get; } = [];

    /// <summary>The steps that take long in each repeat.</summary>
    public List<SlowStep> Slow { get; } = [];

    public Peak<int, FormattableString> MostEvaluations { get; } = new($"");

    /// <summary>The number of violations of a claim, its worst size, and the scene of that size or of the first violation.</summary>
    public (long Broken, double Worst, string At) this[MatchClaim claim] => _claims[(int)claim];

    /// <summary>Adds a size that a claim bounds.</summary>
    public void See(MatchClaim claim, double size, bool holds, FormattableString at)
    {
        ref (long Broken, double Worst, string At) item = ref _claims[(int)claim];
        item.Broken += holds ? 0 : 1;
        if (size > item.Worst || (!holds && item.At.Length == 0))
        {
            (item.Worst, item.At) = (Math.Max(size, item.Worst), FormattableString.Invariant($"match {index}, {at}"));
        }
    }
}

/// <summary>The distribution of the evaluations per step and ball.</summary>
internal sealed class EvaluationCounts
{
    /// <summary>The limit of evaluations per step, docs/troubleshooting.md; a larger count is in the last bin.</summary>
    public const int Most = 32_768;

    private readonly long[] _steps = new long[Most + 2];
    private readonly Lock _lock = new();

    public long Steps { get; private set; }

    /// <summary>The largest count of a step, and the scene of that step.</summary>
    private int _largest;
    private string _largestAt = "";

    /// <summary>Adds the steps of a match, and frees their list.</summary>
    public void Add(MatchOutcome match)
    {
        lock (_lock)
        {
            foreach (int count in match.Evaluations)
            {
                _steps[Math.Min(count, Most + 1)]++;
            }

            Steps += match.Evaluations.Count;
            match.Evaluations.Clear();
            match.Evaluations.TrimExcess();

            // Of equal counts keep the first text, because matches end in any order.
            string at = FormattableString.Invariant(match.MostEvaluations.At);
            int largest = match.MostEvaluations.Most;
            if (largest > _largest || (largest == _largest && string.CompareOrdinal(at, _largestAt) < 0))
            {
                (_largest, _largestAt) = (largest, at);
            }
        }
    }

    /// <summary>Returns the count that a share of the steps does not exceed.</summary>
    private long At(double share)
    {
        long wanted = (long)Math.Ceiling(share * Steps);
        long seen = 0;
        for (int i = 0; i < _steps.Length; i++)
        {
            seen += _steps[i];
            if (seen >= wanted)
            {
                return i;
            }
        }

        return Most + 1;
    }

    /// <summary>Adds a row.</summary>
    public void AddTo(LabTable table, string balls) => table.Judge(_largest <= Most, balls, Steps, At(0.5), At(0.99), At(0.9999), _largest, _largestAt);
}
