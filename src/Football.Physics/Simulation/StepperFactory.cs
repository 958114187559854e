namespace Football.Physics;

/// <summary>Chooses the compiled body for a scene: one per air and integrator.</summary>
internal static class StepperFactory
{
    public static Stepper Create(Scene scene, SolverSettings settings)
    {
        var maker = new Maker { Settings = settings };
        return scene.Forces.Custom.Count > 0 ? maker.Visit<OwnForcesAir>(scene)
            : FieldAir.IsOf(scene) ? InField(scene, settings)
            : AirChoice.Choose<Maker, Stepper>(scene, ref maker);
    }

    private static Stepper InField(Scene scene, SolverSettings settings) => settings.Integrator switch
    {
        Integrator.Euler => new FieldStepper<ExplicitEuler>(scene, settings),
        Integrator.SemiImplicitEuler => new FieldStepper<SemiImplicitEuler>(scene, settings),
        Integrator.Rk2 => new FieldStepper<MidpointRungeKutta>(scene, settings),
        Integrator.Rk4 => new FieldStepper<ClassicalRungeKutta>(scene, settings),
        _ => throw Check.Unknown("solver.integrator", settings.Integrator),
    };

    private struct Maker : IAirVisitor<Stepper>
    {
        public SolverSettings Settings;

        public readonly Stepper Visit<TAir>(Scene scene)
            where TAir : struct, IAir => Settings.Integrator switch
            {
                Integrator.Euler => new Stepper<TAir, ExplicitEuler>(scene, Settings),
                Integrator.SemiImplicitEuler => new Stepper<TAir, SemiImplicitEuler>(scene, Settings),
                Integrator.Rk2 => new Stepper<TAir, MidpointRungeKutta>(scene, Settings),
                Integrator.Rk4 => new Stepper<TAir, ClassicalRungeKutta>(scene, Settings),
                _ => throw Check.Unknown("solver.integrator", Settings.Integrator),
            };
    }
}
