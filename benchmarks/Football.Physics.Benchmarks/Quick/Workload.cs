namespace FootballPhysics.Benchmarks;

/// <summary>Something to time: a call and how many operations it does.</summary>
internal sealed record Workload(Func<double> Run, int Operations);
