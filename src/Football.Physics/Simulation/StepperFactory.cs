namespace Football.Physics;

/// <summary>Chooses the compiled body for a scene: one per combination of laws and integrator, and none that no scene can choose.</summary>
internal static class StepperFactory
{
    public static Stepper Create(Scene scene, SolverSettings settings)
    {
        ForceSet forces = scene.Forces;
        bool fitted = forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical;
        return !fitted ? WithoutFit(scene, settings) : forces.Coefficients switch
        {
            CoefficientForm.Published => Published(scene, settings),
            CoefficientForm.Regularised => Regularised(scene, settings),
            _ => throw Check.Unknown("forces.coefficients", forces.Coefficients),
        };
    }

    /// <summary>Without the fitted drag coefficient.</summary>
    private static Stepper WithoutFit(Scene scene, SolverSettings settings) => (scene.Forces.Drag, scene.Forces.Magnus) switch
    {
        (ForceLaw.None, ForceLaw.None) => Laws<NoDragFit, NoAirLaw, NoAirLaw>(scene, settings),
        (ForceLaw.None, ForceLaw.Constant) => Laws<NoDragFit, NoAirLaw, ConstantMagnus>(scene, settings),
        (ForceLaw.Constant, ForceLaw.None) => Laws<NoDragFit, ConstantDrag, NoAirLaw>(scene, settings),
        (ForceLaw.Constant, ForceLaw.Constant) => Laws<NoDragFit, ConstantDrag, ConstantMagnus>(scene, settings),
        _ => throw UnknownLaw(scene.Forces),
    };

    /// <summary>With the coefficient as published, for drag, for the Magnus force, or for both; fused where no law is of constant coefficients.</summary>
    private static Stepper Published(Scene scene, SolverSettings settings) => (scene.Forces.Drag, scene.Forces.Magnus) switch
    {
        (ForceLaw.None, ForceLaw.Empirical) => Published<NoAirLaw, EmpiricalMagnus>(scene, settings),
        (ForceLaw.Empirical, ForceLaw.None) => Published<EmpiricalDrag, NoAirLaw>(scene, settings),
        (ForceLaw.Empirical, ForceLaw.Empirical) => Published<EmpiricalDrag, EmpiricalMagnus>(scene, settings),
        (ForceLaw.Constant, ForceLaw.Empirical) => Laws<PublishedDragFit, ConstantDrag, EmpiricalMagnus>(scene, settings),
        (ForceLaw.Empirical, ForceLaw.Constant) => Laws<PublishedDragFit, EmpiricalDrag, ConstantMagnus>(scene, settings),
        _ => throw UnknownLaw(scene.Forces),
    };

    private static Stepper Published<TDrag, TMagnus>(Scene scene, SolverSettings settings)
        where TDrag : struct, IAirLaw
        where TMagnus : struct, IAirLaw => scene.Forces.SpinDecay switch
        {
            ForceLaw.None => WithIntegrator<PublishedAir<TDrag, TMagnus, NoAirLaw>>(scene, settings),
            ForceLaw.Constant => WithIntegrator<AirLaws<PublishedDragFit, TDrag, TMagnus, ConstantSpinDecay>>(scene, settings),
            ForceLaw.Empirical => WithIntegrator<PublishedAir<TDrag, TMagnus, EmpiricalSpinDecay>>(scene, settings),
            _ => throw UnknownLaw(scene.Forces),
        };

    /// <summary>With the coefficient without its jumps.</summary>
    private static Stepper Regularised(Scene scene, SolverSettings settings) => (scene.Forces.Drag, scene.Forces.Magnus) switch
    {
        (ForceLaw.None, ForceLaw.Empirical) => Laws<RegularisedDragFit, NoAirLaw, EmpiricalMagnus>(scene, settings),
        (ForceLaw.Empirical, ForceLaw.None) => Laws<RegularisedDragFit, EmpiricalDrag, NoAirLaw>(scene, settings),
        (ForceLaw.Empirical, ForceLaw.Empirical) => Laws<RegularisedDragFit, EmpiricalDrag, EmpiricalMagnus>(scene, settings),
        (ForceLaw.Constant, ForceLaw.Empirical) => Laws<RegularisedDragFit, ConstantDrag, EmpiricalMagnus>(scene, settings),
        (ForceLaw.Empirical, ForceLaw.Constant) => Laws<RegularisedDragFit, EmpiricalDrag, ConstantMagnus>(scene, settings),
        _ => throw UnknownLaw(scene.Forces),
    };

    private static Stepper Laws<TFit, TDrag, TMagnus>(Scene scene, SolverSettings settings)
        where TFit : struct, IDragFit
        where TDrag : struct, IAirLaw
        where TMagnus : struct, IAirLaw => scene.Forces.SpinDecay switch
        {
            ForceLaw.None => WithIntegrator<AirLaws<TFit, TDrag, TMagnus, NoAirLaw>>(scene, settings),
            ForceLaw.Constant => WithIntegrator<AirLaws<TFit, TDrag, TMagnus, ConstantSpinDecay>>(scene, settings),
            ForceLaw.Empirical => WithIntegrator<AirLaws<TFit, TDrag, TMagnus, EmpiricalSpinDecay>>(scene, settings),
            _ => throw UnknownLaw(scene.Forces),
        };

    private static Stepper WithIntegrator<TAir>(Scene scene, SolverSettings settings)
        where TAir : struct, IAir => settings.Integrator switch
        {
            Integrator.Euler => new Stepper<TAir, ExplicitEuler>(scene, settings),
            Integrator.SemiImplicitEuler => new Stepper<TAir, SemiImplicitEuler>(scene, settings),
            Integrator.Rk2 => new Stepper<TAir, MidpointRungeKutta>(scene, settings),
            Integrator.Rk4 => new Stepper<TAir, ClassicalRungeKutta>(scene, settings),
            _ => throw Check.Unknown("solver.integrator", settings.Integrator),
        };

    private static ArgumentOutOfRangeException UnknownLaw(ForceSet forces) =>
        forces.Drag is not (ForceLaw.None or ForceLaw.Constant or ForceLaw.Empirical) ? Check.Unknown("forces.drag", forces.Drag)
        : forces.Magnus is not (ForceLaw.None or ForceLaw.Constant or ForceLaw.Empirical) ? Check.Unknown("forces.magnus", forces.Magnus)
        : Check.Unknown("forces.spinDecay", forces.SpinDecay);
}
