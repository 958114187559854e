namespace FootballPhysics.Benchmarks;

/// <summary>A row of "The ball among things".</summary>
/// <param name="Name">The objects in the scene.</param>
/// <param name="Target">The ratio to reach in the default scene.</param>
/// <param name="Subject">Makes the workload.</param>
/// <param name="From">The start of the shots, m.</param>
internal sealed record WorldRow(string Name, double? Target, Func<StadiumScenes, Workload> Subject, Vector3d From) : Row(Name)
{
    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects => InScenes(scene => Subject(new StadiumScenes(scene)));
}
