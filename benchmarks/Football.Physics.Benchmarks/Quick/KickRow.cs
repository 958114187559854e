namespace FootballPhysics.Benchmarks;

/// <summary>A row of "A kick".</summary>
/// <param name="Name">What is timed, and what it is compared with.</param>
/// <param name="Target">The ratio to reach in the default scene.</param>
/// <param name="Subject">Makes the workload in a scene.</param>
/// <param name="Yardstick">Makes what it is compared with, in the same scene.</param>
internal sealed record KickRow(string Name, double Target, Func<Scene, Workload> Subject, Func<Scene, Workload> Yardstick);
