namespace FootballPhysics.Benchmarks;

/// <summary>A row of a table of `quick`.</summary>
/// <param name="Name">The subject and, if its ratio needs one, the yardstick.</param>
internal abstract record Row(string Name)
{
    /// <summary>The method whose flight step is a unit for this row; null if the row has no such unit.</summary>
    public virtual Integrator? FlightUnit => null;

    /// <summary>The timed workloads by name; the name is empty if there is only one. None if they need a process of their own.</summary>
    public abstract IEnumerable<(string Name, Func<Workload> Make)> Subjects { get; }

    /// <summary>Returns a workload as the only one of its row.</summary>
    protected static IEnumerable<(string Name, Func<Workload> Make)> Only(Func<Workload> make) => [("", make)];

    /// <summary>Returns a workload in the default scene, and in the published one.</summary>
    protected static IEnumerable<(string Name, Func<Workload> Make)> InScenes(Func<Scene, Workload> make) =>
        [("default scene", () => make(new Scene())), ("published", () => make(Scene.Published))];
}
