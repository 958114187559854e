namespace FootballPhysics.Benchmarks;

/// <summary>A row of the table of times: what, against what, and what is to be reached.</summary>
internal sealed record TargetRow(string Name, Func<Workload> Subject, Func<Workload> Yardstick)
{
    /// <summary>The ratio to reach; none for rows that only inform.</summary>
    public double? Target { get; init; }

    /// <summary>What the thesis measured.</summary>
    public string Thesis { get; init; } = "–";

    /// <summary>Mean error, m; none where there is nothing to compare with.</summary>
    public Func<double>? Error { get; init; }

    /// <summary>What else there is to say of the error; none where the mean says it.</summary>
    public Func<string>? Note { get; init; }

    /// <summary>Whether it is timed in a process of its own, with 512-bit registers switched off.</summary>
    public bool Without512Bit { get; init; }
}
