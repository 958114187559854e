namespace FootballPhysics.Benchmarks;

/// <summary>A row of "What a step cannot avoid".</summary>
/// <param name="Name">The part of a step.</param>
/// <param name="PartOf">The rows that contain the part.</param>
/// <param name="Subject">Makes the workload.</param>
internal sealed record FloorRow(string Name, string PartOf, Func<Workload> Subject) : Row(Name)
{
    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects => Only(Subject);
}
