namespace Football.Physics;

/// <summary>Chooses the type of a scene's air: one per combination of laws, and none that no scene can choose.</summary>
internal static class AirChoice
{
    /// <summary>Shows the type of a scene's air to a visitor.</summary>
    public static TResult Choose<TVisitor, TResult>(Scene scene, ref TVisitor visitor)
        where TVisitor : struct, IAirVisitor<TResult>
    {
        ForceSet forces = scene.Forces;
        bool fitted = forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical
            || (forces.SpinDecay == ForceLaw.Empirical && forces.Coefficients == CoefficientForm.Measured);
        return !fitted ? WithoutFit<TVisitor, TResult>(scene, ref visitor) : forces.Coefficients switch
        {
            CoefficientForm.Published => Published<TVisitor, TResult>(scene, ref visitor),
            CoefficientForm.Regularised => Regularised<TVisitor, TResult>(scene, ref visitor),
            CoefficientForm.Measured => Measured<TVisitor, TResult>(scene, ref visitor),
            _ => throw Check.Unknown("forces.coefficients", forces.Coefficients),
        };
    }

    /// <summary>Without the fitted drag coefficient.</summary>
    private static TResult WithoutFit<TVisitor, TResult>(Scene scene, ref TVisitor visitor)
        where TVisitor : struct, IAirVisitor<TResult> => (scene.Forces.Drag, scene.Forces.Magnus) switch
        {
            (ForceLaw.None, ForceLaw.None) => Laws<TVisitor, TResult, NoDragFit, NoAirLaw, NoAirLaw>(scene, ref visitor),
            (ForceLaw.None, ForceLaw.Constant) => Laws<TVisitor, TResult, NoDragFit, NoAirLaw, ConstantMagnus>(scene, ref visitor),
            (ForceLaw.Constant, ForceLaw.None) => Laws<TVisitor, TResult, NoDragFit, ConstantDrag, NoAirLaw>(scene, ref visitor),
            (ForceLaw.Constant, ForceLaw.Constant) => Laws<TVisitor, TResult, NoDragFit, ConstantDrag, ConstantMagnus>(scene, ref visitor),
            _ => throw UnknownLaw(scene.Forces),
        };

    /// <summary>With the coefficient as published, for drag, for the Magnus force, or for both; fused where no law is of constant coefficients.</summary>
    private static TResult Published<TVisitor, TResult>(Scene scene, ref TVisitor visitor)
        where TVisitor : struct, IAirVisitor<TResult> => (scene.Forces.Drag, scene.Forces.Magnus) switch
        {
            (ForceLaw.None, ForceLaw.Empirical) => Published<TVisitor, TResult, NoAirLaw, EmpiricalMagnus>(scene, ref visitor),
            (ForceLaw.Empirical, ForceLaw.None) => Published<TVisitor, TResult, EmpiricalDrag, NoAirLaw>(scene, ref visitor),
            (ForceLaw.Empirical, ForceLaw.Empirical) => Published<TVisitor, TResult, EmpiricalDrag, EmpiricalMagnus>(scene, ref visitor),
            (ForceLaw.Constant, ForceLaw.Empirical) => Laws<TVisitor, TResult, PublishedDragFit, ConstantDrag, EmpiricalMagnus>(scene, ref visitor),
            (ForceLaw.Empirical, ForceLaw.Constant) => Laws<TVisitor, TResult, PublishedDragFit, EmpiricalDrag, ConstantMagnus>(scene, ref visitor),
            _ => throw UnknownLaw(scene.Forces),
        };

    private static TResult Published<TVisitor, TResult, TDrag, TMagnus>(Scene scene, ref TVisitor visitor)
        where TDrag : struct, IAirLaw
        where TMagnus : struct, IAirLaw
        where TVisitor : struct, IAirVisitor<TResult> => scene.Forces.SpinDecay switch
        {
            ForceLaw.None => visitor.Visit<PublishedAir<TDrag, TMagnus, NoAirLaw>>(scene),
            ForceLaw.Constant => visitor.Visit<AirLaws<PublishedDragFit, TDrag, TMagnus, ConstantSpinDecay>>(scene),
            ForceLaw.Empirical => visitor.Visit<PublishedAir<TDrag, TMagnus, EmpiricalSpinDecay>>(scene),
            _ => throw UnknownLaw(scene.Forces),
        };

    /// <summary>With the coefficient without its jumps; by tables where no law is of constant coefficients.</summary>
    private static TResult Regularised<TVisitor, TResult>(Scene scene, ref TVisitor visitor)
        where TVisitor : struct, IAirVisitor<TResult> => (scene.Forces.Drag, scene.Forces.Magnus) switch
        {
            (ForceLaw.None, ForceLaw.Empirical) => Regularised<TVisitor, TResult, NoAirLaw, EmpiricalMagnus>(scene, ref visitor),
            (ForceLaw.Empirical, ForceLaw.None) => Regularised<TVisitor, TResult, EmpiricalDrag, NoAirLaw>(scene, ref visitor),
            (ForceLaw.Empirical, ForceLaw.Empirical) => Regularised<TVisitor, TResult, EmpiricalDrag, EmpiricalMagnus>(scene, ref visitor),
            (ForceLaw.Constant, ForceLaw.Empirical) => Laws<TVisitor, TResult, RegularisedDragFit, ConstantDrag, EmpiricalMagnus>(scene, ref visitor),
            (ForceLaw.Empirical, ForceLaw.Constant) => Laws<TVisitor, TResult, RegularisedDragFit, EmpiricalDrag, ConstantMagnus>(scene, ref visitor),
            _ => throw UnknownLaw(scene.Forces),
        };

    private static TResult Regularised<TVisitor, TResult, TDrag, TMagnus>(Scene scene, ref TVisitor visitor)
        where TDrag : struct, IAirLaw
        where TMagnus : struct, IAirLaw
        where TVisitor : struct, IAirVisitor<TResult> => scene.Forces.SpinDecay switch
        {
            ForceLaw.None => visitor.Visit<SmoothAir<RegularisedLaw, TDrag, TMagnus, NoAirLaw>>(scene),
            ForceLaw.Constant => visitor.Visit<AirLaws<RegularisedDragFit, TDrag, TMagnus, ConstantSpinDecay>>(scene),
            ForceLaw.Empirical => visitor.Visit<SmoothAir<RegularisedLaw, TDrag, TMagnus, EmpiricalSpinDecay>>(scene),
            _ => throw UnknownLaw(scene.Forces),
        };

    /// <summary>By the measured laws, at least one of them; by tables where no law is of constant coefficients.</summary>
    private static TResult Measured<TVisitor, TResult>(Scene scene, ref TVisitor visitor)
        where TVisitor : struct, IAirVisitor<TResult> => (scene.Forces.Drag, scene.Forces.Magnus) switch
        {
            (ForceLaw.None, ForceLaw.None) => visitor.Visit<AirLaws<NoDragFit, NoAirLaw, NoAirLaw, ProportionalSpinDecay>>(scene),
            (ForceLaw.None, ForceLaw.Constant) => visitor.Visit<AirLaws<NoDragFit, NoAirLaw, ConstantMagnus, ProportionalSpinDecay>>(scene),
            (ForceLaw.Constant, ForceLaw.None) => visitor.Visit<AirLaws<NoDragFit, ConstantDrag, NoAirLaw, ProportionalSpinDecay>>(scene),
            (ForceLaw.Constant, ForceLaw.Constant) => visitor.Visit<AirLaws<NoDragFit, ConstantDrag, ConstantMagnus, ProportionalSpinDecay>>(scene),
            (ForceLaw.None, ForceLaw.Empirical) => Measured<TVisitor, TResult, NoAirLaw, MeasuredMagnus>(scene, ref visitor),
            (ForceLaw.Empirical, ForceLaw.None) => Measured<TVisitor, TResult, MeasuredDrag, NoAirLaw>(scene, ref visitor),
            (ForceLaw.Empirical, ForceLaw.Empirical) => Measured<TVisitor, TResult, MeasuredDrag, MeasuredMagnus>(scene, ref visitor),
            (ForceLaw.Constant, ForceLaw.Empirical) => MeasuredLaws<TVisitor, TResult, ConstantDrag, MeasuredMagnus>(scene, ref visitor),
            (ForceLaw.Empirical, ForceLaw.Constant) => MeasuredLaws<TVisitor, TResult, MeasuredDrag, ConstantMagnus>(scene, ref visitor),
            _ => throw UnknownLaw(scene.Forces),
        };

    private static TResult Measured<TVisitor, TResult, TDrag, TMagnus>(Scene scene, ref TVisitor visitor)
        where TDrag : struct, IAirLaw
        where TMagnus : struct, IAirLaw
        where TVisitor : struct, IAirVisitor<TResult> => scene.Forces.SpinDecay switch
        {
            ForceLaw.None => visitor.Visit<SmoothAir<MeasuredLaw, TDrag, TMagnus, NoAirLaw>>(scene),
            ForceLaw.Constant => visitor.Visit<AirLaws<NoDragFit, TDrag, TMagnus, ConstantSpinDecay>>(scene),
            ForceLaw.Empirical => visitor.Visit<SmoothAir<MeasuredLaw, TDrag, TMagnus, ProportionalSpinDecay>>(scene),
            _ => throw UnknownLaw(scene.Forces),
        };

    private static TResult MeasuredLaws<TVisitor, TResult, TDrag, TMagnus>(Scene scene, ref TVisitor visitor)
        where TDrag : struct, IAirLaw
        where TMagnus : struct, IAirLaw
        where TVisitor : struct, IAirVisitor<TResult> => scene.Forces.SpinDecay switch
        {
            ForceLaw.None => visitor.Visit<AirLaws<NoDragFit, TDrag, TMagnus, NoAirLaw>>(scene),
            ForceLaw.Constant => visitor.Visit<AirLaws<NoDragFit, TDrag, TMagnus, ConstantSpinDecay>>(scene),
            ForceLaw.Empirical => visitor.Visit<AirLaws<NoDragFit, TDrag, TMagnus, ProportionalSpinDecay>>(scene),
            _ => throw UnknownLaw(scene.Forces),
        };

    private static TResult Laws<TVisitor, TResult, TFit, TDrag, TMagnus>(Scene scene, ref TVisitor visitor)
        where TFit : struct, IDragFit
        where TDrag : struct, IAirLaw
        where TMagnus : struct, IAirLaw
        where TVisitor : struct, IAirVisitor<TResult> => scene.Forces.SpinDecay switch
        {
            ForceLaw.None => visitor.Visit<AirLaws<TFit, TDrag, TMagnus, NoAirLaw>>(scene),
            ForceLaw.Constant => visitor.Visit<AirLaws<TFit, TDrag, TMagnus, ConstantSpinDecay>>(scene),
            ForceLaw.Empirical => visitor.Visit<AirLaws<TFit, TDrag, TMagnus, EmpiricalSpinDecay>>(scene),
            _ => throw UnknownLaw(scene.Forces),
        };

    private static ArgumentOutOfRangeException UnknownLaw(ForceSet forces) =>
        forces.Drag is not (ForceLaw.None or ForceLaw.Constant or ForceLaw.Empirical) ? Check.Unknown("forces.drag", forces.Drag)
        : forces.Magnus is not (ForceLaw.None or ForceLaw.Constant or ForceLaw.Empirical) ? Check.Unknown("forces.magnus", forces.Magnus)
        : Check.Unknown("forces.spinDecay", forces.SpinDecay);
}
