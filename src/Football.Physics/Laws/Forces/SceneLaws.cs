using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>Creates the laws of a scene one by one, for values that are computed once per scene.</summary>
internal static class SceneLaws
{
    /// <summary>Returns the law of the drag force.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The scene contains an undefined law.</exception>
    public static IAirLaw Drag(Scene scene) =>
        Prepared(scene, "forces.drag", scene.Forces.Drag, default(ConstantDrag), IsMeasured(scene) ? default(MeasuredDrag) : default(EmpiricalDrag));

    /// <summary>Returns the law of the Magnus force.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The scene contains an undefined law.</exception>
    public static IAirLaw Magnus(Scene scene) =>
        Prepared(scene, "forces.magnus", scene.Forces.Magnus, default(ConstantMagnus), IsMeasured(scene) ? default(MeasuredMagnus) : default(EmpiricalMagnus));

    /// <summary>Returns the law of the spin decay.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The scene contains an undefined law.</exception>
    public static IAirLaw SpinDecay(Scene scene) => Prepared(
        scene,
        "forces.spinDecay",
        scene.Forces.SpinDecay,
        default(ConstantSpinDecay),
        IsMeasured(scene) ? default(ProportionalSpinDecay) : default(EmpiricalSpinDecay));

    /// <summary>Returns a bound on the drag up to a speed. Without such a limit, the coefficient of the measured law has none.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="fastest">The speed, in m/s.</param>
    public static RateBound DragBound(Scene scene, double fastest)
    {
        if (!IsMeasured(scene) || scene.Forces.Drag != ForceLaw.Empirical)
        {
            return Drag(scene).Bound;
        }

        MeasuredLaw law = default;
        law.Prepare(scene);
        return law.DragBound(fastest);
    }

    private static bool IsMeasured(Scene scene) => scene.Forces.Coefficients == AerodynamicModel.Measured;

    private static IAirLaw Prepared(Scene scene, string field, ForceLaw kind, IAirLaw constant, IAirLaw empirical)
    {
        IAirLaw law = kind switch
        {
            ForceLaw.None => default(NoAirLaw),
            ForceLaw.Constant => constant,
            ForceLaw.Empirical => empirical,
            _ => throw Check.Refusal(field, kind.ToString(), "None | Constant | Empirical"),
        };
        law.Prepare(scene);
        return law;
    }
}
