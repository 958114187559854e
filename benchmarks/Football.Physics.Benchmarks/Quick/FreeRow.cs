namespace FootballPhysics.Benchmarks;

/// <summary>A row of "What a scene does not need is free".</summary>
/// <param name="Name">The omitted feature.</param>
/// <param name="Subject">Makes the workload.</param>
/// <param name="Method">The step method whose code size is read, as the JIT lists it; null if there is no integration.</param>
internal sealed record FreeRow(string Name, Func<Workload> Subject, string? Method = "MidpointRungeKutta:Fly[") : Row(Name)
{
    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects => Only(Subject);
}
