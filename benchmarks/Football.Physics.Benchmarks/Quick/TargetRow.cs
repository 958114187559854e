namespace FootballPhysics.Benchmarks;

/// <summary>A row of the table of times: subject, yardstick and target.</summary>
internal sealed record TargetRow(string Name, Func<Workload> Subject, Func<Workload> Yardstick) : Row(Name)
{
    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects => Without512Bit ? [] : Only(Subject);

    /// <summary>The ratio to reach; null if the row has no target.</summary>
    public double? Target { get; init; }

    /// <summary>The thesis' result.</summary>
    public string Thesis { get; init; } = "–";

    /// <summary>Computes the mean error, m; null if there is no reference.</summary>
    public Func<double>? Error { get; init; }

    /// <summary>Returns a note on the error; null if the mean is sufficient.</summary>
    public Func<string>? Note { get; init; }

    /// <summary>True if it is timed in a process of its own, with 512-bit registers switched off.</summary>
    public bool Without512Bit { get; init; }
}
