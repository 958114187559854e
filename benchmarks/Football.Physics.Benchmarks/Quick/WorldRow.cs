namespace Football.Physics.Benchmarks;

/// <summary>A row of "The ball among things".</summary>
/// <param name="Name">What there is.</param>
/// <param name="Target">The ratio to reach.</param>
/// <param name="Subject">Makes the workload.</param>
/// <param name="Empty">Makes the same flights over an empty pitch.</param>
internal sealed record WorldRow(string Name, double? Target, Func<Workload> Subject, Func<Workload> Empty);
