using Football.Physics.Headless.Input;

namespace Football.Physics.Headless.Simulate;

/// <summary>Reads the parts of an input that make up a scene and say how to integrate it; their ranges are the library's.</summary>
internal static class SceneInput
{
    /// <summary>The scene: ball, air, gravity, forces, ground.</summary>
    public static Scene Scene(InputObject root)
    {
        Scene scene = Physics.Scene.Default;
        return new Scene
        {
            Ball = Ball(root.Object("ball"), scene.Ball),
            Air = Air(root.Object("air"), scene.Air),
            Gravity = root.Number("gravity", scene.Gravity),
            Forces = Forces(root.Object("forces"), scene.Forces),
            Ground = Ground(root.Object("ground"), scene.Ground),
            Obstacles = WorldInput.Obstacles(root),
            Nets = WorldInput.Nets(root),
            Goals = WorldInput.Goals(root),
        };
    }

    /// <summary>The solver of a single ball, and its step in seconds.</summary>
    public static SolverSettings Solver(InputObject root, out double timeStep)
    {
        InputObject solver = root.Object("solver");
        SolverSettings settings = SolverSettings.Default;
        timeStep = solver.Positive("timeStep", Scenario.DefaultTimeStep);
        return new SolverSettings
        {
            Integrator = solver.Choice("integrator", settings.Integrator),
            CollisionTiming = solver.Choice("collisionTiming", settings.CollisionTiming),
            CollisionTolerance = solver.Number("collisionTolerance", settings.CollisionTolerance),
            RollingTransition = solver.Choice("rollingTransition", settings.RollingTransition),
        };
    }

    /// <summary>When a run ends, and whether it keeps its path.</summary>
    public static (StopAt At, double Time, bool Samples) Stop(InputObject root)
    {
        InputObject stop = root.Object("stop");
        return (stop.Choice("at", StopAt.Impact), stop.Positive("time", Scenario.DefaultDuration), root.Flag("samples", false));
    }

    private static BallProperties Ball(InputObject ball, BallProperties defaults) => new()
    {
        Mass = ball.Number("mass", defaults.Mass),
        Radius = ball.Number("radius", defaults.Radius),
        InertiaFactor = ball.Number("inertiaFactor", defaults.InertiaFactor),
    };

    private static Air Air(InputObject air, Air defaults) => new()
    {
        Density = air.Number("density", defaults.Density),
        KinematicViscosity = air.Number("kinematicViscosity", defaults.KinematicViscosity),
        Wind = air.Vector("wind", defaults.Wind),
    };

    private static ForceSet Forces(InputObject forces, ForceSet defaults) => new()
    {
        Buoyancy = forces.Flag("buoyancy", defaults.Buoyancy),
        Drag = forces.Choice("drag", defaults.Drag),
        Magnus = forces.Choice("magnus", defaults.Magnus),
        SpinDecay = forces.Choice("spinDecay", defaults.SpinDecay),
        Coefficients = forces.Choice("coefficients", defaults.Coefficients),
        DragCoefficient = forces.Number("dragCoefficient", defaults.DragCoefficient),
        MagnusCoefficient = forces.Number("magnusCoefficient", defaults.MagnusCoefficient),
        SpinDecayCoefficient = forces.Number("spinDecayCoefficient", defaults.SpinDecayCoefficient),
    };

    private static Ground Ground(InputObject ground, Ground defaults)
    {
        double[] tangential = ground.Numbers("tangentialRestitution", "[x, z]", [defaults.TangentialRestitutionX, defaults.TangentialRestitutionZ]);
        return new Ground
        {
            NormalRestitution = ground.Number("normalRestitution", defaults.NormalRestitution),
            RestitutionSpeed = ground.Limit("restitutionSpeed", defaults.RestitutionSpeed),
            ImpactFriction = ground.Limit("impactFriction", defaults.ImpactFriction),
            RollingFrictionBySpeed = ground.Number("rollingFrictionBySpeed", defaults.RollingFrictionBySpeed),
            DrillingLength = ground.Number("drillingLength", defaults.DrillingLength),
            Normal = ground.Vector("normal", defaults.Normal),
            Heights = WorldInput.Heights(ground),
            TangentialRestitutionX = tangential[0],
            TangentialRestitutionZ = tangential[1],
            SpinRestitution = ground.Number("spinRestitution", defaults.SpinRestitution),
            SlidingFriction = ground.Number("slidingFriction", defaults.SlidingFriction),
            RollingFriction = ground.Number("rollingFriction", defaults.RollingFriction),
            SpinDamping = ground.Number("spinDamping", defaults.SpinDamping),
            MinimumBounceSpeed = ground.Number("minimumBounceSpeed", defaults.MinimumBounceSpeed),
            RestEnergy = ground.Number("restEnergy", defaults.RestEnergy),
            Height = ground.Number("height", defaults.Height),
            Aerodynamics = ground.Choice("aerodynamics", defaults.Aerodynamics),
        };
    }
}
