namespace FootballPhysics.Labs.Stress;

/// <summary>The steps that take more than 1 ms of processor time, in the best of several repeats from the same state.</summary>
internal sealed class StepTimes
{
    /// <summary>The time, ms, above which a step is counted.</summary>
    public const double Slow = 1;

    /// <summary>The number of repeats of a slow step.</summary>
    public const int Repeats = 5;

    /// <summary>The largest share of slow steps with one ball, and with several.</summary>
    private static readonly double[] s_allowed = [1e-5, 1e-4];

    private readonly long[] _steps = new long[2];
    private readonly List<SlowStep>[] _slow = [[], []];
    private readonly Lock _lock = new();

    /// <summary>Adds the steps of a match.</summary>
    public void Add(MatchOutcome match)
    {
        lock (_lock)
        {
            int kind = match.Balls > 1 ? 1 : 0;
            _steps[kind] += match.Evaluations.Count;
            _slow[kind].AddRange(match.Slow);
        }
    }

    /// <summary>Adds a table with a row for one ball and a row for several.</summary>
    public void AddTo(LabRun run)
    {
        LabTable table = run.Table(
            "Steps above 1 ms of processor time, best of 5 repeats", "balls", "steps", "slow", "share", "worst, ms", "its evaluations", "of gaps", "its pieces", "at", "verdict");
        for (int kind = 0; kind < _steps.Length; kind++)
        {
            SlowStep worst = _slow[kind].OrderByDescending(step => step.Milliseconds).FirstOrDefault();
            double share = (double)_slow[kind].Count / Math.Max(1, _steps[kind]);
            table.Judge(share <= s_allowed[kind], kind == 0 ? "one" : "several", _steps[kind], _slow[kind].Count, share, worst.Milliseconds, worst.Evaluations, worst.Gaps, worst.Pieces, worst.At);
        }

        run.Notes.AddRange(_slow.SelectMany(steps => steps.OrderByDescending(step => step.Milliseconds).Take(4)).Select(step => FormattableString.Invariant($"{step.Milliseconds:F2} ms, {step.Evaluations} evaluations, {step.Gaps} of gaps, {step.Pieces} pieces: {step.At}")));
    }
}

/// <summary>A step that takes long.</summary>
/// <param name="Milliseconds">Its processor time.</param>
/// <param name="Evaluations">Its evaluations of the forces.</param>
/// <param name="Gaps">The evaluations of gaps by its searches.</param>
/// <param name="Pieces">Its pieces.</param>
/// <param name="At">The match and its time.</param>
internal readonly record struct SlowStep(double Milliseconds, long Evaluations, long Gaps, long Pieces, string At);
