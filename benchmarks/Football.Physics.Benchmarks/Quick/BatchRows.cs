using System.Runtime.Intrinsics;

namespace FootballPhysics.Benchmarks;

/// <summary>The rows of many balls and many aims: on one core, per ball-step or per aim.</summary>
internal static class BatchRows
{
    public static IReadOnlyList<TargetRow> All { get; } =
    [
        .. Widths().SelectMany(lanes => new[]
        {
            Flight(lanes, "RK2", Integrator.Rk2, PlainLawKind.Published, "fast", ShotSets.Fast, lanes == 16 ? 0.04 : 0.07),
            Flight(lanes, "RK4", Integrator.Rk4, PlainLawKind.Published, "fast", ShotSets.Fast, lanes == 16 ? 0.035 : 0.07),
            Flight(lanes, "RK2", Integrator.Rk2, PlainLawKind.Published, "mixed", ShotSets.Mixed, null),
            Flight(lanes, "RK4", Integrator.Rk4, PlainLawKind.Published, "mixed", ShotSets.Mixed, null),
            Flight(lanes, "RK4", Integrator.Rk4, PlainLawKind.Regularised, "mixed", ShotSets.Mixed, null),
            Flight(lanes, "RK4", Integrator.Rk4, PlainLawKind.Constant, "mixed", ShotSets.Mixed, null),
            Aim(lanes, "", Scene.Published, 8),
            Aim(lanes, ", wind", Scene.Published with { Air = new Air { Wind = new Vector3d(4, 0, -3) } }, null),
        }),
        .. Environment.ProcessorCount > 1 ? new[] { TwoCores(Widths()[^1]) } : [],
    ];

    private static int[] Widths() => Vector512.IsHardwareAccelerated ? [8, 16] : [8];

    private static TargetRow Flight(
        int lanes, string name, Integrator integrator, PlainLawKind law, string set, IReadOnlyList<Shot> shots, double? target)
    {
        Scene scene = PlainFlight.SceneOf(law);
        string of = law == PlainLawKind.Published ? "" : $", {law.ToString().ToLowerInvariant()} law";
        return new TargetRow(
            $"many balls, {lanes * 32}-bit, {set}: {name}{of}",
            () => BatchWorkloads.Flight(scene, integrator, shots, lanes),
            () => Workloads.Plain(law, integrator, shots))
        {
            Target = target,
            Error = () => BatchWorkloads.LandingError(scene, integrator, shots),
            Note = () => $"{Text.Length(BatchWorkloads.FromSingleBall(scene, integrator, shots))} at most from the single ball",
        };
    }

    private static TargetRow Aim(int lanes, string with, Scene scene, double? target) => new(
        $"many aims, {lanes * 32}-bit, to 1 mm{with}, in plain RK2 steps",
        () => BatchWorkloads.Aim(scene, lanes),
        () => Workloads.Plain(PlainLawKind.Published, Integrator.Rk2, ShotSets.Fast))
    {
        Target = target,
        Error = () => BatchWorkloads.Misses(scene).Mean,
        Note = () => $"at most {Text.Length(BatchWorkloads.Misses(scene).Worst)}",
    };

    /// <summary>Returns the row of both threads, per aim and core: a million aims take this many times half a million plain RK2 steps.</summary>
    private static TargetRow TwoCores(int lanes) => new(
        $"many aims, {lanes * 32}-bit, two cores, to 1 mm, by aim and core, in plain RK2 steps",
        () => BatchWorkloads.AimOnTwoCores(Scene.Published, lanes),
        () => Workloads.Plain(PlainLawKind.Published, Integrator.Rk2, ShotSets.Fast))
    {
        Target = 8,
        Error = () => BatchWorkloads.Misses(Scene.Published).Mean,
        Note = () => $"at most {Text.Length(BatchWorkloads.Misses(Scene.Published).Worst)}",
    };
}
