namespace Football.Physics.Headless.Schema;

/// <summary>The fields that say how to integrate.</summary>
internal static class SolverFields
{
    public static readonly NumberField TimeStep = new("solver.timeStep", 0.01, NumberRange.Positive, "s");

    private static readonly SolverSettings Default = SolverSettings.Default;

    private static readonly ChoiceField<Integrator> Method = new(
        "solver.integrator",
        Default.Integrator,
        ("euler", Integrator.Euler),
        ("semiImplicitEuler", Integrator.SemiImplicitEuler),
        ("rk2", Integrator.Rk2),
        ("rk4", Integrator.Rk4));

    private static readonly ChoiceField<CollisionTiming> Timing = new(
        "solver.collisionTiming", Default.CollisionTiming, ("exact", CollisionTiming.Exact), ("bisection", CollisionTiming.Bisection));

    private static readonly NumberField Tolerance = new("solver.collisionTolerance", Default.CollisionTolerance, NumberRange.Positive, "s");

    private static readonly ChoiceField<RollingTransition> Transition = new(
        "solver.rollingTransition", Default.RollingTransition, ("exact", RollingTransition.Exact), ("heuristic", RollingTransition.Heuristic));

    /// <summary>All of them.</summary>
    public static IReadOnlyList<Field> All { get; } = [Method, TimeStep, Timing, Tolerance, Transition];

    /// <summary>The settings that the values describe.</summary>
    public static SolverSettings Build(FieldValues values) => new()
    {
        Integrator = values.Get(Method),
        CollisionTiming = values.Get(Timing),
        CollisionTolerance = values.Get(Tolerance),
        RollingTransition = values.Get(Transition),
    };
}
