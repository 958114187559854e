namespace FootballPhysics.Benchmarks;

/// <summary>A row of "A ball in a group".</summary>
/// <param name="Name">The scene, and the motion of the ball.</param>
/// <param name="Target">The ratio to reach; null if there is none.</param>
/// <param name="Yardstick">The comparison for the subject.</param>
/// <param name="Make">Makes the two workloads.</param>
internal sealed record GroupRow(string Name, double? Target, string Yardstick, Func<(Workload Subject, Workload Yardstick)> Make) : Row(Name)
{
    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects => Only(() => Make().Subject);
}
