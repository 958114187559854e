namespace Football.Physics;

/// <summary>Makes the compiled body for a scene: one per air and integrator.</summary>
internal static class StepperFactory
{
    /// <summary>For a scene whose laws are known: with the game's own forces and with wind by place and time, where it has them.</summary>
    /// <typeparam name="TAir">The laws.</typeparam>
    public static Stepper Create<TAir>(Scene scene, SolverSettings settings)
        where TAir : struct, ILawsAir
    {
        TAir laws = default;
        laws.Prepare(scene);
        return HasLawsAlone(scene) ? Of(scene, settings, in laws) : Around(scene, settings, PointAir.Of(in laws));
    }

    /// <summary>Whether nothing but laws acts in a scene.</summary>
    public static bool HasLawsAlone(Scene scene) => scene.Forces.Custom.Count == 0 && !FieldAir.IsOf(scene);

    /// <summary>For laws alone.</summary>
    public static Stepper Of<TAir>(Scene scene, SolverSettings settings, in TAir air)
        where TAir : struct, IAir => settings.Integrator switch
        {
            Integrator.Euler => new Stepper<TAir, ExplicitEuler>(scene, settings, in air),
            Integrator.SemiImplicitEuler => new Stepper<TAir, SemiImplicitEuler>(scene, settings, in air),
            Integrator.Rk2 => new Stepper<TAir, MidpointRungeKutta>(scene, settings, in air),
            Integrator.Rk4 => new Stepper<TAir, ClassicalRungeKutta>(scene, settings, in air),
            _ => throw Check.Unknown("solver.integrator", settings.Integrator),
        };

    /// <summary>For laws with all that a scene has around them.</summary>
    public static Stepper Around(Scene scene, SolverSettings settings, PointAir laws)
    {
        bool inField = FieldAir.IsOf(scene);
        if (scene.Forces.Custom.Count > 0)
        {
            PointAir air = inField ? PointAir.Of(new FieldAir(scene, laws)) : laws;
            return Of(scene, settings, new OwnForcesAir(scene, air));
        }

        var field = new FieldAir(scene, laws);
        return settings.Integrator switch
        {
            Integrator.Euler => new FieldStepper<ExplicitEuler>(scene, settings, in field),
            Integrator.SemiImplicitEuler => new FieldStepper<SemiImplicitEuler>(scene, settings, in field),
            Integrator.Rk2 => new FieldStepper<MidpointRungeKutta>(scene, settings, in field),
            Integrator.Rk4 => new FieldStepper<ClassicalRungeKutta>(scene, settings, in field),
            _ => throw Check.Unknown("solver.integrator", settings.Integrator),
        };
    }
}
