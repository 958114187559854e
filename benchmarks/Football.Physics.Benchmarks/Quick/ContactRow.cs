namespace FootballPhysics.Benchmarks;

/// <summary>A row of "A ball that several surfaces touch".</summary>
/// <param name="Name">The contacts, the motion, and the method.</param>
/// <param name="Integrator">The method.</param>
/// <param name="Subject">Makes the case.</param>
internal sealed record ContactRow(string Name, Integrator Integrator, Func<ContactCase> Subject) : Row(Name)
{
    public override Integrator? FlightUnit => Integrator;

    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects => Only(() => Subject().Workload);
}
