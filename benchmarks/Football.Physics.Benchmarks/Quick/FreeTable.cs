namespace FootballPhysics.Benchmarks;

/// <summary>The rows of "What a scene does not need is free": RK2 at 10 ms.</summary>
internal static class FreeTable
{
    private const string Advance = "MidpointRungeKutta:Advance[";

    public static IReadOnlyList<FreeRow> Rows { get; } =
    [
        Flight("all forces", ForceSet.Published),
        Flight("no buoyancy", ForceSet.Published with { Buoyancy = false }),
        Flight("no drag", ForceSet.Published with { Drag = ForceLaw.None }),
        Flight("no Magnus force", ForceSet.Published with { Magnus = ForceLaw.None }),
        Flight("no spin decay", ForceSet.Published with { SpinDecay = ForceLaw.None }),
        Flight("no Magnus force, no spin decay", ForceSet.Published with { Magnus = ForceLaw.None, SpinDecay = ForceLaw.None }),
        Flight("constant coefficients", ForceSet.Constant),
        Flight("vacuum", ForceSet.None),
        new("all forces, regularised law", () => Workloads.Flight(Scene.Published with { Forces = ForceSet.Regularized }, Integrator.Rk2, ShotSets.Fast)),
        new("all forces, ball without spin", () => Workloads.Flight(Scene.Published, Integrator.Rk2, ShotSets.WithoutSpin)),
        new("all forces, orientation read every step", () => Workloads.FlightWithOrientation(Scene.Published, Integrator.Rk2, ShotSets.Fast)),
        new("published, on the ground: sliding", () => Workloads.Chain(Scene.Published, Integrator.Rk2, ShotSets.Sliding), Advance + "FootballPhysics.SlidingSystem"),
        new("published, on the ground: rolling", () => Workloads.Chain(Scene.Published, Integrator.Rk2, ShotSets.Rolling), Advance + "FootballPhysics.RollingSystem"),
        new("rolling, no aerodynamics", () => Workloads.Chain(Scene.Published with { Forces = ForceSet.None }, Integrator.Rk2, ShotSets.Rolling), Advance + "FootballPhysics.RollingSystem"),
        new("stopped", () => Workloads.Stopped(Integrator.Rk2), null),
    ];

    private static FreeRow Flight(string name, ForceSet forces) =>
        new(name, () => Workloads.Flight(Scene.Published with { Forces = forces }, Integrator.Rk2, ShotSets.Fast));
}
