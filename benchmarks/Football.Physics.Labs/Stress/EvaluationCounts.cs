namespace FootballPhysics.Labs.Stress;

/// <summary>The distribution of the evaluations per step and ball.</summary>
internal sealed class EvaluationCounts
{
    /// <summary>The limit of evaluations per step, docs/troubleshooting.md; a larger count is in the last bin.</summary>
    public const int Most = 32_768;

    private readonly long[] _steps = new long[Most + 2];
    private readonly Lock _lock = new();

    public long Steps { get; private set; }

    /// <summary>The largest count of a step.</summary>
    public long Largest { get; private set; }

    /// <summary>The scene of that step.</summary>
    public string LargestAt { get; private set; } = "";

    /// <summary>Adds the steps of a match.</summary>
    public void Add(List<int> evaluations, long largest, string at)
    {
        lock (_lock)
        {
            foreach (int count in evaluations)
            {
                _steps[Math.Min(count, Most + 1)]++;
            }

            Steps += evaluations.Count;

            // Of equal counts keep the first text, because matches end in any order.
            if (largest > Largest || (largest == Largest && string.CompareOrdinal(at, LargestAt) < 0))
            {
                (Largest, LargestAt) = (largest, at);
            }
        }
    }

    /// <summary>Returns the count that a share of the steps does not exceed.</summary>
    public long At(double share)
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

    public LabTable Table(string balls)
    {
        var table = new LabTable("Evaluations of a step", "balls", "steps", "median", "99 %", "99.99 %", "most", "at", "verdict");
        table.Add(balls, Steps, At(0.5), At(0.99), At(0.9999), Largest, LargestAt, Verdict.Of(Largest <= Most));
        return table;
    }
}
