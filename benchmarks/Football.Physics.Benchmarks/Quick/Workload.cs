namespace FootballPhysics.Benchmarks;

/// <summary>A timed call and its number of operations.</summary>
internal sealed record Workload(Func<double> Run, int Operations);
