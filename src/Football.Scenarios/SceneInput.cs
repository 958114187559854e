using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenes;

namespace FootballPhysics.Scenarios;

/// <summary>Reads the members of an input that describe the scene and its integration. The library checks the ranges.</summary>
public static class SceneInput
{
    /// <summary>Reads the scene: ball, air, gravity, forces, ground.</summary>
    public static Scene Scene(InputObject root)
    {
        // The order determines the order of members in error messages.
        InputObject ball = root.Object("ball");
        InputObject air = root.Object("air");
        Vector3d gravity = Gravity(root);
        InputObject forces = root.Object("forces");
        InputObject ground = root.Object("ground");
        InputObject dials = root.Object("dials");
        Profile profile = root.Choice("profile", Profile.Measured);
        Scene scene = profile == Profile.Measured ? FootballPhysics.Scene.Measured : FootballPhysics.Scene.Published;
        SurfaceMaterial frame = profile == Profile.Measured ? SurfaceMaterial.GoalFrame : SurfaceMaterial.PublishedGoalFrame;
        var given = new Scene
        {
            Ball = Ball(ball, profile),
            GravityVector = gravity,
            Forces = Forces(forces, scene.Forces),
            Ground = Ground(ground, FootballPhysics.Ground.Presets[ground.Preset("surface", FootballPhysics.Ground.Presets, profile == Profile.Measured ? "matchTurf" : "publishedTurf")]),
            Air = AirInput.Air(air, scene.Air, ground.Number("height", scene.Ground.Height)),
            Obstacles = WorldInput.Obstacles(root, frame),
            Nets = WorldInput.Nets(root),
            Goals = WorldInput.Goals(root, frame),
            Zones = WorldInput.Zones(root),
        };
        Dials set = dials.Numbers(SceneFields.Dials, new Dials());
        return root.Make(() => set.Apply(given)) ?? given;
    }

    /// <summary>Reads the gravity: a number for the downward acceleration, or a vector.</summary>
    private static Vector3d Gravity(InputObject root)
    {
        if (!root.IsArray("gravity"))
        {
            return new Vector3d(0, -root.Number("gravity", FootballPhysics.Scene.Default.Gravity), 0);
        }

        Vector3d gravity = root.Vector("gravity", Vector3d.Zero);
        root.Demand("gravity", gravity.Y <= 0, "a number, or [x, y, z] with y at most 0");
        return gravity;
    }

    /// <summary>Reads the solver of a single ball, and its step, in s.</summary>
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

    /// <summary>Reads the stop condition, and whether to keep the path.</summary>
    public static (StopAt At, double Time, bool Samples) Stop(InputObject root)
    {
        InputObject stop = root.Object("stop");
        return (stop.Choice("at", StopAt.Impact), stop.Positive("time", Scenario.DefaultDuration), root.Flag("samples", false));
    }

    /// <summary>Reads the ball. In the measured profile, it can be a known ball.</summary>
    public static BallProperties Ball(InputObject ball, Profile profile)
    {
        BallProperties defaults = profile != Profile.Measured ? BallProperties.Modern : BallProperties.Presets[ball.Preset("type", BallProperties.Presets, "modern")];
        DragCurve curve = defaults.DragCurve;
        if (profile == Profile.Measured && ball.Has("roughness"))
        {
            // A custom roughness excludes a known type.
            ball.Exclude("roughness", "type");
            double roughness = ball.Number("roughness", 0);
            curve = ball.Make(() => DragCurve.OfRoughness(roughness)) ?? curve;
        }

        if (profile == Profile.Measured && ball.Has("dragCurve"))
        {
            ball.Exclude("dragCurve", "roughness");
            curve = ball.Object("dragCurve").Numbers(SceneFields.Drag, curve);
        }

        NumberField<BallProperties>[] numbers = profile == Profile.Measured ? SceneFields.Ball : [.. SceneFields.Ball.Where(field => field.Name is not ("knuckleForce" or "reverseLift"))];
        return ball.Numbers(numbers, defaults) with
        {
            DragCurve = curve,
            SeamSeed = profile == Profile.Measured ? ball.Seed("seamSeed", defaults.SeamSeed) : defaults.SeamSeed,
            Ignores = Layers.Of(ball.Layers("ignores")),
        };
    }

    private static ForceSet Forces(InputObject forces, ForceSet defaults) => forces.Numbers(SceneFields.Forces, defaults) with
    {
        Buoyancy = forces.Flag("buoyancy", defaults.Buoyancy),
        Drag = forces.Choice("drag", defaults.Drag),
        Magnus = forces.Choice("magnus", defaults.Magnus),
        SpinDecay = forces.Choice("spinDecay", defaults.SpinDecay),
        Coefficients = forces.Choice("coefficients", defaults.Coefficients),
        KnuckleSeed = forces.OptionalWhole("knuckleSeed"),
    };

    private static Ground Ground(InputObject ground, Ground defaults)
    {
        foreach (string name in defaults.IsNone ? ["height", "normal", "heights"] : Array.Empty<string>())
        {
            ground.Demand(name, !ground.Has(name), "a surface other than none");
        }

        // One tangential restitution, or two: along x and along z.
        double along = defaults.Material.TangentialRestitution;
        double[] tangential = ground.OneOrTwo("tangentialRestitution", "a number, or [x, z]", [along, along]);
        SurfaceMaterial material = ground.Numbers(SceneFields.GroundMaterial, defaults.Material);
        return ground.Numbers(SceneFields.Ground, defaults) with
        {
            Material = tangential[0] == along ? material : material with { TangentialRestitution = tangential[0] },
            TangentialRestitutionZ = tangential[1] == tangential[0] ? null : tangential[1],
            Normal = ground.Vector("normal", defaults.Normal),
            Heights = WorldInput.Heights(ground),
            Height = ground.Number("height", defaults.Height),
            Aerodynamics = ground.Choice("aerodynamics", defaults.Aerodynamics),
        };
    }
}
