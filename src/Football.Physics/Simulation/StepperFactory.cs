namespace FootballPhysics;

/// <summary>
/// Makes the stepper of a scene. Flight is compiled for a handful of airs (published, measured, regularised, constant, none), one that asks any mixture
/// of laws point by point, in wind by place and time too; each with every method.
/// </summary>
internal static class StepperFactory
{
    /// <summary>The stepper of a scene.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The scene names a law, or the settings a method, that there is not.</exception>
    public static Stepper Create(Scene scene, SolverSettings settings) => settings.Integrator switch
    {
        Integrator.Euler => Create<ExplicitEuler>(scene, settings),
        Integrator.SemiImplicitEuler => Create<SemiImplicitEuler>(scene, settings),
        Integrator.Rk2 => Create<MidpointRungeKutta>(scene, settings),
        Integrator.Rk4 => Create<ClassicalRungeKutta>(scene, settings),
        _ => throw Check.Unknown("solver.integrator", settings.Integrator),
    };

    private static Stepper Create<TIntegrator>(Scene scene, SolverSettings settings)
        where TIntegrator : struct, IIntegrator
    {
        var air = SceneAir.Of(scene);

        // Own forces may turn the axis of the spin: no step along a constant axis is compiled.
        if (air.TurnsAxis)
        {
            return new SceneStepper<TIntegrator>(scene, settings, in air);
        }

        ForceSet forces = scene.Forces;
        bool mixes = scene.HasOwnForces || forces.Drag != forces.Magnus || forces.Magnus != forces.SpinDecay;

        // The measured law in a field, any mixture point by point, and the airs of one law each.
        return (mixes, air.Varies, forces.Drag, forces.Coefficients) switch
        {
            (false, true, ForceLaw.Empirical, AerodynamicModel.Measured) => InField<MeasuredLaw, TIntegrator>(scene, settings, in air),
            (true, _, _, _) or (_, true, _, _) => Of<SceneAir, TIntegrator>(scene, settings, in air, in air),
            (_, _, ForceLaw.None, _) => Of<NoAir, TIntegrator>(scene, settings, in air, default),
            (_, _, ForceLaw.Constant, _) => Of<ConstantAir, TIntegrator>(scene, settings, in air, new ConstantAir(scene)),
            (_, _, _, AerodynamicModel.Published) => OfTables<PublishedLaw, TIntegrator>(scene, settings, in air),
            (_, _, _, AerodynamicModel.Regularized) => OfTables<RegularisedLaw, TIntegrator>(scene, settings, in air),
            _ => OfTables<MeasuredLaw, TIntegrator>(scene, settings, in air),
        };
    }

    // Each by itself: what a scene does not need is not loaded.
    private static Stepper OfTables<TLaw, TIntegrator>(Scene scene, SolverSettings settings, in SceneAir air)
        where TLaw : struct, ITableLaw
        where TIntegrator : struct, IIntegrator => Of<TableAir<TLaw>, TIntegrator>(scene, settings, in air, new TableAir<TLaw>(scene));

    private static Stepper InField<TLaw, TIntegrator>(Scene scene, SolverSettings settings, in SceneAir air)
        where TLaw : struct, ITableLaw
        where TIntegrator : struct, IIntegrator => Of<FieldAir<TLaw>, TIntegrator>(scene, settings, in air, new FieldAir<TLaw>(scene, in air));

    private static Stepper Of<TAir, TIntegrator>(Scene scene, SolverSettings settings, in SceneAir air, in TAir laws)
        where TAir : struct, IFlightAir
        where TIntegrator : struct, IIntegrator => new FlightStepper<TAir, TIntegrator>(scene, settings, in air, in laws);
}
