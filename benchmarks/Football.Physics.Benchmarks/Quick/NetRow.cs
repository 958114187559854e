namespace FootballPhysics.Benchmarks;

/// <summary>A row of "In the net of a goal".</summary>
/// <param name="Name">The method.</param>
/// <param name="Integrator">The method.</param>
internal sealed record NetRow(string Name, Integrator Integrator) : Row(Name)
{
    public override Integrator? FlightUnit => Integrator;

    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects =>
    [
        ("a step of a caught shot", () => NetTable.Play(Simulator())),
        ("a step of a ball at rest on the roof net", () => NetTable.Lying(Simulator())),
        ("a look-ahead of 3 s", () => NetTable.LookAhead(Simulator())),
    ];

    /// <summary>Compiles the scene of a goal with a net.</summary>
    public Simulator Simulator() =>
        new(new Scene { Goals = [new Goal { Center = new Vector3d(0, 0, -12), Facing = new Vector3d(0, 0, 1) }] }, new SolverSettings { Integrator = Integrator });
}
