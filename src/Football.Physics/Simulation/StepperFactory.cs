namespace Football.Physics;

/// <summary>Chooses the compiled body for a scene: one per combination of laws and integrator.</summary>
internal static class StepperFactory
{
    public static Stepper Create(Scene scene, SolverSettings settings)
    {
        ForceSet forces = scene.Forces;
        bool fitted = forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical;
        return Fusible(forces) ? FusedDrag(scene, settings)
            : !fitted ? WithDrag<NoDragFit>(scene, settings)
            : forces.Coefficients == CoefficientForm.Regularised ? WithDrag<RegularisedDragFit>(scene, settings)
            : WithDrag<PublishedDragFit>(scene, settings);
    }

    /// <summary>Whether every law is the fitted one or left out, and the drag coefficient is used: what the fused kernels do.</summary>
    private static bool Fusible(ForceSet forces) => forces.Drag != ForceLaw.Constant
        && forces.Magnus != ForceLaw.Constant
        && forces.SpinDecay != ForceLaw.Constant
        && (forces.Drag == ForceLaw.Empirical || forces.Magnus == ForceLaw.Empirical);

    private static Stepper FusedDrag(Scene scene, SolverSettings settings) => scene.Forces.Drag == ForceLaw.Empirical
        ? FusedMagnus<Present, EmpiricalDrag>(scene, settings)
        : FusedMagnus<Absent, NoAirLaw>(scene, settings);

    private static Stepper FusedMagnus<TDrag, TDragLaw>(Scene scene, SolverSettings settings)
        where TDrag : struct, IPresence
        where TDragLaw : struct, IAirLaw => scene.Forces.Magnus == ForceLaw.Empirical
            ? FusedSpinDecay<TDrag, TDragLaw, Present, EmpiricalMagnus>(scene, settings)
            : FusedSpinDecay<TDrag, TDragLaw, Absent, NoAirLaw>(scene, settings);

    private static Stepper FusedSpinDecay<TDrag, TDragLaw, TMagnus, TMagnusLaw>(Scene scene, SolverSettings settings)
        where TDrag : struct, IPresence
        where TDragLaw : struct, IAirLaw
        where TMagnus : struct, IPresence
        where TMagnusLaw : struct, IAirLaw => scene.Forces.SpinDecay == ForceLaw.Empirical
            ? FusedCoefficients<TDrag, TDragLaw, TMagnus, TMagnusLaw, Present, EmpiricalSpinDecay>(scene, settings)
            : FusedCoefficients<TDrag, TDragLaw, TMagnus, TMagnusLaw, Absent, NoAirLaw>(scene, settings);

    private static Stepper FusedCoefficients<TDrag, TDragLaw, TMagnus, TMagnusLaw, TDecay, TDecayLaw>(Scene scene, SolverSettings settings)
        where TDrag : struct, IPresence
        where TDragLaw : struct, IAirLaw
        where TMagnus : struct, IPresence
        where TMagnusLaw : struct, IAirLaw
        where TDecay : struct, IPresence
        where TDecayLaw : struct, IAirLaw => scene.Forces.Coefficients == CoefficientForm.Regularised
            ? Smooth<RegularisedLaw, TDrag, TMagnus, TDecay>(scene, settings)
            : WithFused<PublishedAir<TDrag, TMagnus, TDecay>, SpunAir<TDrag, TMagnus, TDecay>, Aerodynamics<PublishedDragFit, TDragLaw, TMagnusLaw, TDecayLaw>>(scene, settings);

    private static Stepper Smooth<TLaw, TDrag, TMagnus, TDecay>(Scene scene, SolverSettings settings)
        where TLaw : struct, ISmoothLaw
        where TDrag : struct, IPresence
        where TMagnus : struct, IPresence
        where TDecay : struct, IPresence =>
        WithFused<SmoothAir<TLaw, TDrag, TMagnus, TDecay>, SmoothAir<TLaw, TDrag, TMagnus, TDecay>, SmoothLaws<TLaw, TDrag, TMagnus, TDecay>>(scene, settings);

    private static Stepper WithDrag<TFit>(Scene scene, SolverSettings settings)
        where TFit : struct, IDragFit => scene.Forces.Drag switch
        {
            ForceLaw.None => WithMagnus<TFit, NoAirLaw>(scene, settings),
            ForceLaw.Constant => WithMagnus<TFit, ConstantDrag>(scene, settings),
            _ => WithMagnus<TFit, EmpiricalDrag>(scene, settings),
        };

    private static Stepper WithMagnus<TFit, TDrag>(Scene scene, SolverSettings settings)
        where TFit : struct, IDragFit
        where TDrag : struct, IAirLaw => scene.Forces.Magnus switch
        {
            ForceLaw.None => WithSpinDecay<TFit, TDrag, NoAirLaw>(scene, settings),
            ForceLaw.Constant => WithSpinDecay<TFit, TDrag, ConstantMagnus>(scene, settings),
            _ => WithSpinDecay<TFit, TDrag, EmpiricalMagnus>(scene, settings),
        };

    private static Stepper WithSpinDecay<TFit, TDrag, TMagnus>(Scene scene, SolverSettings settings)
        where TFit : struct, IDragFit
        where TDrag : struct, IAirLaw
        where TMagnus : struct, IAirLaw => scene.Forces.SpinDecay switch
        {
            ForceLaw.None => WithIntegrator<Aerodynamics<TFit, TDrag, TMagnus, NoAirLaw>>(scene, settings),
            ForceLaw.Constant => WithIntegrator<Aerodynamics<TFit, TDrag, TMagnus, ConstantSpinDecay>>(scene, settings),
            _ => WithIntegrator<Aerodynamics<TFit, TDrag, TMagnus, EmpiricalSpinDecay>>(scene, settings),
        };

    private static Stepper WithFused<TFast, TSpun, TLaws>(Scene scene, SolverSettings settings)
        where TFast : struct, IFusedAir
        where TSpun : struct, IAerodynamics
        where TLaws : struct, IAerodynamics => WithIntegrator<TFast, TSpun, EitherAir<TFast, TLaws>>(scene, settings);

    private static Stepper WithIntegrator<TAir>(Scene scene, SolverSettings settings)
        where TAir : struct, IAerodynamics => WithIntegrator<TAir, TAir, TAir>(scene, settings);

    private static Stepper WithIntegrator<TFast, TSpun, TAir>(Scene scene, SolverSettings settings)
        where TFast : struct, IAerodynamics
        where TSpun : struct, IAerodynamics
        where TAir : struct, IAerodynamics => settings.Integrator switch
        {
            Integrator.Euler => new Stepper<TFast, TSpun, TAir, ExplicitEuler>(scene, settings),
            Integrator.SemiImplicitEuler => new Stepper<TFast, TSpun, TAir, SemiImplicitEuler>(scene, settings),
            Integrator.Rk2 => new Stepper<TFast, TSpun, TAir, MidpointRungeKutta>(scene, settings),
            _ => new Stepper<TFast, TSpun, TAir, ClassicalRungeKutta>(scene, settings),
        };
}
