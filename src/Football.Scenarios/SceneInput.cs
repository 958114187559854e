using Football.Scenarios.Input;

namespace Football.Scenarios;

/// <summary>Reads the parts of an input that make up a scene and say how to integrate it; their ranges are the library's.</summary>
public static class SceneInput
{
    /// <summary>The scene: ball, air, gravity, forces, ground.</summary>
    public static Scene Scene(InputObject root)
    {
        // In the order in which a refusal names them.
        InputObject ball = root.Object("ball");
        InputObject air = root.Object("air");
        double gravity = Gravity(root);
        InputObject forces = root.Object("forces");
        InputObject ground = root.Object("ground");
        Profile profile = root.Choice("profile", Profile.Measured);
        Scene scene = profile == Profile.Measured ? Physics.Scene.Measured : Physics.Scene.Published;
        Surface frame = profile == Profile.Measured ? Physics.Surface.GoalFrame : Physics.Surface.PublishedGoalFrame;
        return new Scene
        {
            Ball = Ball(ball, profile),
            Gravity = gravity,
            Forces = Forces(forces, scene.Forces),
            Ground = Ground(ground, Surface(ground, profile)),
            Air = AirInput.Air(air, scene.Air, ground.Number("height", scene.Ground.Height)),
            Obstacles = WorldInput.Obstacles(root, frame),
            Nets = WorldInput.Nets(root),
            Goals = WorldInput.Goals(root, frame),
            Zones = WorldInput.Zones(root),
        };
    }

    /// <summary>A number, or a vector straight down.</summary>
    private static double Gravity(InputObject root)
    {
        if (!root.IsArray("gravity"))
        {
            return root.Number("gravity", Physics.Scene.Default.Gravity);
        }

        Vector3d gravity = root.Vector("gravity", Vector3d.Zero);
        root.Demand("gravity", gravity.X == 0 && gravity.Z == 0 && gravity.Y <= 0, "a number, or [0, −g, 0]: straight down (tilt the ground for a slope)");
        return gravity.Y < 0 ? -gravity.Y : 0;
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

    /// <summary>The ball; in the measured profile one of the known ones.</summary>
    public static BallProperties Ball(InputObject ball, Profile profile)
    {
        BallProperties defaults = profile != Profile.Measured ? BallProperties.Football : ball.Choice("type", BallType.Generic) switch
        {
            BallType.Tango12 => BallProperties.Tango12,
            BallType.Teamgeist => BallProperties.Teamgeist,
            BallType.Jabulani => BallProperties.Jabulani,
            BallType.Brazuca => BallProperties.Brazuca,
            BallType.Telstar18 => BallProperties.Telstar18,
            BallType.Flight2020 => BallProperties.Flight2020,
            BallType.AlRihla => BallProperties.AlRihla,
            BallType.Fussballliebe => BallProperties.Fussballliebe,
            BallType.Trionda => BallProperties.Trionda,
            BallType.Modern => BallProperties.Modern,
            BallType.YouthFootball => BallProperties.YouthFootball,
            BallType.Futsal => BallProperties.Futsal,
            BallType.BeachBall => BallProperties.BeachBall,
            BallType.MedicineBall => BallProperties.MedicineBall,
            _ => BallProperties.Football,
        };
        DragCurve curve = defaults.DragCurve;
        if (profile == Profile.Measured && ball.Has("roughness"))
        {
            // A dial of its own; only of a ball of no make
            ball.Exclude("roughness", "type");
            double roughness = ball.Number("roughness", 0);
            curve = ball.Make(() => DragCurve.OfRoughness(roughness)) ?? curve;
        }

        if (profile == Profile.Measured && ball.Has("dragCurve"))
        {
            ball.Exclude("dragCurve", "roughness");
            curve = Curve(ball.Object("dragCurve"), curve);
        }

        return defaults with
        {
            DragCurve = curve,
            Mass = ball.Number("mass", defaults.Mass),
            Radius = ball.Number("radius", defaults.Radius),
            InertiaFactor = ball.Number("inertiaFactor", defaults.InertiaFactor),
            KnuckleForce = profile == Profile.Measured ? ball.Number("knuckleForce", defaults.KnuckleForce) : defaults.KnuckleForce,
            Ignores = Layers.Of(ball.Layers("ignores")),
        };
    }

    private static DragCurve Curve(InputObject curve, DragCurve defaults) => new()
    {
        Subcritical = curve.Number("subcritical", defaults.Subcritical),
        CriticalReynolds = curve.Number("criticalReynolds", defaults.CriticalReynolds),
        Width = curve.Number("width", defaults.Width),
        Supercritical = curve.Number("supercritical", defaults.Supercritical),
        Risen = curve.Number("risen", defaults.Risen),
        RiseFrom = curve.Number("riseFrom", defaults.RiseFrom),
        RiseTo = curve.Number("riseTo", defaults.RiseTo),
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
        KnuckleSeed = forces.OptionalWhole("knuckleSeed"),
    };

    /// <summary>The preset whose numbers the ground has by default.</summary>
    private static Ground Surface(InputObject ground, Profile profile) =>
        ground.Choice("surface", profile == Profile.Measured ? SurfaceType.DryTurf : SurfaceType.PublishedTurf) switch
        {
            SurfaceType.ArtificialTurf => Physics.Ground.ArtificialTurf,
            SurfaceType.WetTurf => Physics.Ground.WetTurf,
            SurfaceType.MatchTurf => Physics.Ground.MatchTurf,
            SurfaceType.HardGround => Physics.Ground.HardGround,
            SurfaceType.LongGrass => Physics.Ground.LongGrass,
            SurfaceType.Indoor => Physics.Ground.Indoor,
            SurfaceType.Concrete => Physics.Ground.Concrete,
            SurfaceType.Snow => Physics.Ground.Snow,
            SurfaceType.PublishedTurf => Physics.Ground.PublishedTurf,
            SurfaceType.PublishedWetTurf => Physics.Ground.PublishedWetTurf,
            SurfaceType.PublishedCourt => Physics.Ground.PublishedCourt,
            SurfaceType.PublishedSand => Physics.Ground.PublishedSand,
            SurfaceType.None => Physics.Ground.None,
            _ => Physics.Ground.DryTurf,
        };

    private static Ground Ground(InputObject ground, Ground defaults)
    {
        foreach (string name in defaults.IsNone ? ["height", "normal", "heights"] : Array.Empty<string>())
        {
            ground.Demand(name, !ground.Has(name), "a surface other than none");
        }

        double[] tangential = ground.OneOrTwo("tangentialRestitution", "a number, or [x, z]", [defaults.TangentialRestitutionX, defaults.TangentialRestitutionZ]);
        return new Ground
        {
            NormalRestitution = ground.Number("normalRestitution", defaults.NormalRestitution),
            RestitutionSpeed = ground.Limit("restitutionSpeed", defaults.RestitutionSpeed),
            RestitutionRise = ground.Number("restitutionRise", defaults.RestitutionRise),
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
