using FootballPhysics.Integration;
using FootballPhysics.Numerics;

namespace FootballPhysics.Simulation;

/// <summary>Creates the stepper of a scene.</summary>
/// <remarks>
/// Flight is compiled for each integrator with a few common air models (published, measured, regularised, constant, none), and with one
/// that supports any mixture of laws, a varying wind and a tilted gravity.
/// </remarks>
internal static class StepperFactory
{
    /// <summary>Creates the stepper of a scene.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The scene names an unknown law, or the settings an unknown integrator.</exception>
    public static Stepper Create(Scene scene, SolverSettings settings) => settings.Integrator switch
    {
        Integrator.Euler => Create<ExplicitEuler>(scene, settings),
        Integrator.SemiImplicitEuler => Create<SemiImplicitEuler>(scene, settings),
        Integrator.Rk2 => Create<MidpointRungeKutta>(scene, settings),
        Integrator.Rk4 => Create<ClassicalRungeKutta>(scene, settings),
        _ => throw Check.Unknown("solver.integrator", settings.Integrator),
    };

    /// <summary>Creates the stepper of a scene for a method of <see cref="IIntegrator"/>.</summary>
    public static Stepper Create<TIntegrator>(Scene scene, SolverSettings settings)
        where TIntegrator : struct, IIntegrator
    {
        var air = SceneAir.Of(scene);

        // Custom forces may turn the spin axis, so do not use steps with a constant axis.
        if (air.HasOwnForces)
        {
            return new SceneStepper<TIntegrator>(scene, settings, in air);
        }

        // Tables cover every mixture with a fitted law.
        bool isMeasured = scene.Forces.Coefficients == AerodynamicModel.Measured;
        if (!AirLaws.HasFits(scene.Forces))
        {
            return scene.HasOwnForces || air.Varies || scene.IsTilted ? Of<SceneAir, TIntegrator>(scene, settings, in air, in air)
                : air.Acts ? Of<ConstantAir, TIntegrator>(scene, settings, in air, new ConstantAir(scene))
                : Of<NoAir, TIntegrator>(scene, settings, in air, default);
        }

        bool reverses = isMeasured && scene.Ball.ReverseLift > 0;
        if (scene.HasOwnForces || air.Varies || scene.IsTilted || reverses)
        {
            return !isMeasured || scene.HasOwnForces ? Of<SceneAir, TIntegrator>(scene, settings, in air, in air)
                : air.Knuckle is { } knuckle && scene.Air.WindField is null && !scene.IsTilted && !reverses ? WithSeams<MeasuredLaw, TIntegrator>(scene, settings, in air, knuckle)
                : InField<MeasuredLaw, TIntegrator>(scene, settings, in air);
        }

        return isMeasured ? OfTables<MeasuredLaw, TIntegrator>(scene, settings, in air)
            : scene.Forces.Coefficients == AerodynamicModel.Published ? OfTables<PublishedLaw, TIntegrator>(scene, settings, in air)
            : OfTables<RegularisedLaw, TIntegrator>(scene, settings, in air);
    }

    // Use separate methods, so that the runtime only loads the generic types that a scene needs.
    private static Stepper OfTables<TLaw, TIntegrator>(Scene scene, SolverSettings settings, in SceneAir air)
        where TLaw : struct, ITableLaw
        where TIntegrator : struct, IIntegrator => Of<TableAir<TLaw>, TIntegrator>(scene, settings, in air, new TableAir<TLaw>(scene));

    private static Stepper InField<TLaw, TIntegrator>(Scene scene, SolverSettings settings, in SceneAir air)
        where TLaw : struct, ITableLaw
        where TIntegrator : struct, IIntegrator => Of<FieldAir<TLaw>, TIntegrator>(scene, settings, in air, new FieldAir<TLaw>(scene, in air));

    private static Stepper WithSeams<TLaw, TIntegrator>(Scene scene, SolverSettings settings, in SceneAir air, KnuckleForce knuckle)
        where TLaw : struct, ITableLaw
        where TIntegrator : struct, IIntegrator => Of<SeamAir<TLaw>, TIntegrator>(scene, settings, in air, new SeamAir<TLaw>(scene, knuckle));

    private static Stepper Of<TAir, TIntegrator>(Scene scene, SolverSettings settings, in SceneAir air, in TAir laws)
        where TAir : struct, IFlightAir
        where TIntegrator : struct, IIntegrator => new FlightStepper<TAir, TIntegrator>(scene, settings, in air, in laws);
}
