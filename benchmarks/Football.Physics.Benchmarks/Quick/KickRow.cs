namespace FootballPhysics.Benchmarks;

/// <summary>A row of "A kick".</summary>
/// <param name="Name">The subject and its yardstick.</param>
/// <param name="Target">The ratio to reach in the default scene.</param>
/// <param name="Subject">Makes the workload in a scene.</param>
/// <param name="Yardstick">Makes the yardstick, in the same scene.</param>
internal sealed record KickRow(string Name, double Target, Func<Scene, Workload> Subject, Func<Scene, Workload> Yardstick) : Row(Name)
{
    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects => InScenes(Subject);
}
