namespace FootballPhysics.Labs.Stress;

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
