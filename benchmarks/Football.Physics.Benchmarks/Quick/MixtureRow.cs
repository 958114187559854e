namespace FootballPhysics.Benchmarks;

/// <summary>A row of "What a scene contains".</summary>
/// <param name="Name">The omitted, constant or replaced part.</param>
/// <param name="Target">The ratio to reach, to the complete scene.</param>
/// <param name="Change">Returns a scene with the part changed.</param>
internal sealed record MixtureRow(string Name, double Target, Func<Scene, Scene> Change) : Row(Name)
{
    /// <summary>The methods, one column each.</summary>
    public static IReadOnlyList<(string Name, Integrator Integrator)> Methods { get; } =
        [("Euler", Integrator.Euler), ("semi-implicit Euler", Integrator.SemiImplicitEuler), ("RK2", Integrator.Rk2), ("RK4", Integrator.Rk4)];

    public override IEnumerable<(string Name, Func<Workload> Make)> Subjects =>
        Methods.SelectMany(method => InScenes(scene => Flight(scene, method.Integrator)).Select(subject => ($"{subject.Name}, {method.Name}", subject.Make)));

    /// <summary>Makes the flight in the changed scene.</summary>
    public Workload Flight(Scene scene, Integrator integrator) => Workloads.Flight(Change(scene), integrator, ShotSets.Fast);
}
