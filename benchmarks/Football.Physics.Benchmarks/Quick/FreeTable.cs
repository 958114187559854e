using Football.Physics.Yardsticks;

namespace Football.Physics.Benchmarks;

/// <summary>The rows of "What a scene does not need is free": RK2 at 10 ms.</summary>
internal static class FreeTable
{
    private const string Advance = "MidpointRungeKutta:Advance[";

    public static IReadOnlyList<FreeRow> Rows { get; } =
    [
        Flight("all forces", new ForceSet()),
        Flight("no buoyancy", new ForceSet { Buoyancy = false }),
        Flight("no drag", new ForceSet { Drag = ForceLaw.None }),
        Flight("no Magnus force", new ForceSet { Magnus = ForceLaw.None }),
        Flight("no spin decay", new ForceSet { SpinDecay = ForceLaw.None }),
        Flight("no Magnus force, no spin decay", new ForceSet { Magnus = ForceLaw.None, SpinDecay = ForceLaw.None }),
        Flight("constant coefficients", ForceSet.Constant),
        Flight("vacuum", ForceSet.None),
        new("all forces, regularised law", () => Workloads.Flight(new Scene { Forces = ForceSet.Regularised }, Integrator.Rk2, ShotSets.Fast)),
        new("all forces, ball without spin", () => Workloads.Flight(Scene.Default, Integrator.Rk2, ShotSets.WithoutSpin)),
        new("all forces, orientation read every step", () => Workloads.FlightWithOrientation(Scene.Default, Integrator.Rk2, ShotSets.Fast)),
        new("on the ground: sliding", () => Workloads.Chain(Scene.Default, Integrator.Rk2, ShotSets.Sliding), Advance + "Football.Physics.SlidingSystem"),
        new("on the ground: rolling", () => Workloads.Chain(Scene.Default, Integrator.Rk2, ShotSets.Rolling), Advance + "Football.Physics.RollingSystem"),
        new("rolling, no aerodynamics", () => Workloads.Chain(new Scene { Forces = ForceSet.None }, Integrator.Rk2, ShotSets.Rolling), Advance + "Football.Physics.RollingSystem"),
        new("stopped", () => Workloads.Stopped(Integrator.Rk2), null),
    ];

    private static FreeRow Flight(string name, ForceSet forces) =>
        new(name, () => Workloads.Flight(new Scene { Forces = forces }, Integrator.Rk2, ShotSets.Fast));
}
