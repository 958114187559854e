namespace FootballPhysics.Benchmarks;

/// <summary>The rows of the measured profile, each compared with the same flight by the published laws, or in still air.</summary>
internal static class MeasuredRows
{
    private static readonly Scene s_byHeight = Scene.Measured with { Air = new Air { WindField = new WindByHeight(8, 1, 0.5) } };
    private static readonly Scene s_gusts = Scene.Measured with { Air = new Air { WindField = new WindByHeight(8, 1, 0.5, gusts: new Gusts()) } };

    public static IReadOnlyList<TargetRow> All { get; } =
    [
        OfPublished("fast: RK2", Integrator.Rk2, ShotSets.Fast),
        OfPublished("fast: RK4", Integrator.Rk4, ShotSets.Fast),
        OfPublished("mixed: RK2", Integrator.Rk2, ShotSets.Mixed),
        OfPublished("mixed: RK4", Integrator.Rk4, ShotSets.Mixed),
        Lanes("fast: RK2", Integrator.Rk2, ShotSets.Fast),
        Lanes("fast: RK4", Integrator.Rk4, ShotSets.Fast),
        Lanes("mixed: RK4", Integrator.Rk4, ShotSets.Mixed),
        new("many aims, measured laws, of the published laws", () => BatchWorkloads.Aim(Scene.Measured, LaneFlight.BestLanes), () => BatchWorkloads.Aim(Scene.Published, LaneFlight.BestLanes))
        {
            Target = 1.3,
            Error = () => BatchWorkloads.Misses(Scene.Measured).Mean,
        },
        InWind("wind by height", "RK2", s_byHeight, Integrator.Rk2, 1.6),
        InWind("wind by height", "RK4", s_byHeight, Integrator.Rk4, 1.6),
        InWind("gusts", "RK2", s_gusts, Integrator.Rk2, 3),
        InWind("gusts", "RK4", s_gusts, Integrator.Rk4, 3),
        WithSeams(0, "RK2", Integrator.Rk2, 2.6),
        WithSeams(5, "RK2", Integrator.Rk2, 2.6),
        WithSeams(60, "RK2", Integrator.Rk2, 2.6),
        WithSeams(0, "RK4", Integrator.Rk4, 3),
        WithSeams(5, "RK4", Integrator.Rk4, 3),
        WithSeams(60, "RK4", Integrator.Rk4, 3),
    ];

    private static TargetRow OfPublished(string name, Integrator integrator, IReadOnlyList<Shot> shots) => new(
        $"measured laws, of the published laws, {name}",
        () => Workloads.Flight(Scene.Measured, integrator, shots),
        () => Workloads.Flight(Scene.Published, integrator, shots))
    {
        Target = 1.3,
    };

    private static TargetRow Lanes(string name, Integrator integrator, IReadOnlyList<Shot> shots) => new(
        $"many balls, measured laws, of the published laws, {name}",
        () => BatchWorkloads.Flight(Scene.Measured, integrator, shots, LaneFlight.BestLanes),
        () => BatchWorkloads.Flight(Scene.Published, integrator, shots, LaneFlight.BestLanes))
    {
        Target = 1.3,
        Error = () => BatchWorkloads.LandingError(Scene.Measured, integrator, shots),
        Note = () => $"{Text.Length(BatchWorkloads.FromSingleBall(Scene.Measured, integrator, shots))} at most from the single ball",
    };

    /// <summary>The same shots with a knuckle seed and without one, at one spin.</summary>
    private static TargetRow WithSeams(double spin, string name, Integrator integrator, double target)
    {
        Shot[] shots = ShotSets.Make(11, 24, 24, spin, spin);
        return new TargetRow(
            FormattableString.Invariant($"seams, {spin} rad/s, of steps without a seed: {name}"),
            () => Workloads.Flight(Scene.Measured with { Forces = ForceSet.Measured with { KnuckleSeed = 3 } }, integrator, shots),
            () => Workloads.Flight(Scene.Measured, integrator, shots))
        {
            Target = target,
        };
    }

    private static TargetRow InWind(string wind, string name, Scene scene, Integrator integrator, double target) => new(
        $"{wind}, measured laws, of still air: {name}",
        () => Workloads.Flight(scene, integrator, ShotSets.Fast),
        () => Workloads.Flight(Scene.Measured, integrator, ShotSets.Fast))
    {
        Target = target,
    };
}
