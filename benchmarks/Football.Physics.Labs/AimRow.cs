namespace FootballPhysics.Labs;

/// <summary>A row of a table: the results of a method for a set of requests.</summary>
internal sealed class AimRow
{
    public AimRow(string name, IReadOnlyList<AimShot> shots)
    {
        Name = name;
        Shots = shots;
        Hits = shots.Count(shot => shot.Miss <= shot.Request.Tolerance);
        OutOfReach = shots.Count(shot => shot.Result.Status == AimStatus.OutOfReach);
        IReadOnlyList<AimShot> counted = Hits > 0 ? [.. shots.Where(shot => shot.Result.Status != AimStatus.OutOfReach)] : shots;
        Miss = new Spread(counted.Select(shot => shot.Miss));
        ThroughMiss = shots.Any(shot => shot.Result.WaypointMiss is not null && shot.Request.Waypoint is not null)
            ? new Spread(counted.Select(shot => shot.Result.WaypointMiss ?? 0))
            : null;
        Iterations = new Spread(shots.Select(shot => (double)shot.Result.Iterations));
        Simulations = new Spread(shots.Select(shot => (double)shot.Result.Simulations));
        Microseconds = new Spread(shots.Select(shot => shot.Microseconds));
    }

    public string Name { get; }

    public IReadOnlyList<AimShot> Shots { get; }

    public int Hits { get; }

    public int OutOfReach { get; }

    /// <summary>Misses of the kicks that were not out of reach, m.</summary>
    public Spread Miss { get; }

    /// <summary>Misses at the waypoint; null without a waypoint.</summary>
    public Spread? ThroughMiss { get; }

    public Spread Iterations { get; }

    public Spread Simulations { get; }

    public Spread Microseconds { get; }

    /// <summary>The thesis' result.</summary>
    public string Thesis { get; init; } = "";

    /// <summary>The target, and whether it was reached; null without a target.</summary>
    public (string Text, bool Reached)? Reach { get; init; }

    public static string[] Columns { get; } =
    [
        "method", "kicks", "hit", "out of reach", "miss mm: mean", "miss: p95", "miss: worst", "point mm: mean", "point: worst",
        "iterations", "most", "simulations", "median µs", "mean µs", "thesis", "to reach",
    ];

    public object?[] Cells =>
    [
        Name, Shots.Count, Hits, OutOfReach, 1e3 * Miss.Mean, 1e3 * Miss.P95, 1e3 * Miss.Worst, 1e3 * ThroughMiss?.Mean, 1e3 * ThroughMiss?.Worst,
        Iterations.Mean, (int)Iterations.Worst, Simulations.Mean, Microseconds.Median, Microseconds.Mean,
        Thesis, Reach is { } reach ? reach.Text + (reach.Reached ? ": yes" : ": NO") : "",
    ];
}
