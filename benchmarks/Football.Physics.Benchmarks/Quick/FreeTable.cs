using System.Globalization;

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

    /// <summary>Times the rows, and reads the sizes of their code.</summary>
    public static void Print(Action<string> print, IReadOnlyList<FreeRow> rows, double share)
    {
        Workload all = Rows[0].Subject();
        (FreeRow Row, Workload Subject)[] work = [.. rows.Select(row => (row, row.Subject()))];
        Stopwatching.WarmUp([all, .. work.Select(w => w.Subject)]);
        print("");
        print("## What a scene does not need is free");
        print("");
        print("RK2 at 10 ms. Code: the size of the integrator's method in bytes, as the JIT lists it (`DOTNET_JitDisasmSummary`), and that of the method around it, which finds events. Buoyancy is part of gravity, so the code is the same without it.");
        print("");
        print("| | ns a step | all forces then, ns | ratio | code | around it |");
        print("|---|--:|--:|--:|--:|--:|");
        foreach ((FreeRow row, Workload subject) in work)
        {
            Timing time = Stopwatching.Measure(subject, all, share);
            (int? method, int? around) = CodeSizes.Of(Rows.TakeWhile(r => r != row).Count(), row);
            print($"| {row.Name} | {Text.Number(time.Nanoseconds)} | {Text.Number(time.YardstickNanoseconds)} | {Text.Number(time.Ratio)} | {method?.ToString(CultureInfo.InvariantCulture) ?? "–"} | {around?.ToString(CultureInfo.InvariantCulture) ?? "–"} |");
        }
    }

    private static FreeRow Flight(string name, ForceSet forces) =>
        new(name, () => Workloads.Flight(Scene.Published with { Forces = forces }, Integrator.Rk2, ShotSets.Fast));
}
