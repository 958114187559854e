namespace FootballPhysics.Tests.Api;

/// <summary>A number out of range is refused with its field, its value and what is allowed.</summary>
public sealed class ValidationTests
{
    private static readonly Scene s_scene = Scene.Published;

    [Theory]
    [InlineData("ball.mass", 0)]
    [InlineData("ball.mass", -0.43)]
    [InlineData("ball.mass", 0.00099)]
    [InlineData("ball.mass", 100.1)]
    [InlineData("ball.radius", 0.0049)]
    [InlineData("ball.inertiaFactor", 0.099)]
    [InlineData("air.density", 101)]
    [InlineData("air.kinematicViscosity", 9e-8)]
    [InlineData("gravity", 1001)]
    [InlineData("forces.dragCoefficient", 10.1)]
    [InlineData("forces.magnusCoefficient", -10.1)]
    [InlineData("forces.spinDecayCoefficient", 1.1)]
    [InlineData("ground.slidingFriction", 10.1)]
    [InlineData("ground.rollingFriction", 10.1)]
    [InlineData("ground.spinDamping", 1.1)]
    [InlineData("ground.minimumBounceSpeed", 10.1)]
    [InlineData("ball.radius", 0)]
    [InlineData("ball.radius", 5.1)]
    [InlineData("ball.inertiaFactor", 0)]
    [InlineData("ball.inertiaFactor", 1.01)]
    [InlineData("air.density", -0.1)]
    [InlineData("air.kinematicViscosity", 0)]
    [InlineData("air.wind", 1000.5)]
    [InlineData("gravity", -9.81)]
    [InlineData("forces.dragCoefficient", -0.1)]
    [InlineData("forces.magnusCoefficient", double.NegativeInfinity)]
    [InlineData("forces.spinDecayCoefficient", -1e-9)]
    [InlineData("ground.normalRestitution", 1.001)]
    [InlineData("ground.normalRestitution", -0.001)]
    [InlineData("ground.tangentialRestitution[0]", 1.1)]
    [InlineData("ground.tangentialRestitution[0]", -1.1)]
    [InlineData("ground.tangentialRestitution[1]", -1.1)]
    [InlineData("ground.spinRestitution", 1.5)]
    [InlineData("ground.spinRestitution", -0.5)]
    [InlineData("ground.slidingFriction", -0.1)]
    [InlineData("ground.rollingFriction", -0.1)]
    [InlineData("ground.spinDamping", -0.1)]
    [InlineData("ground.minimumBounceSpeed", 0.0009)]
    [InlineData("ground.restEnergy", 0)]
    [InlineData("ground.restEnergy", 101)]
    [InlineData("ground.height", -1.5e6)]
    [InlineData("solver.collisionTolerance", 0)]
    public void A_field_out_of_range_is_named_with_its_value(string field, double value)
    {
        Refused(field, value);
        Refused(field, double.NaN);
        Refused(field, double.PositiveInfinity);
    }

    [Theory]
    [InlineData("ball.mass", 0.001)]
    [InlineData("ball.mass", 100)]
    [InlineData("ball.radius", 0.005)]
    [InlineData("ball.radius", 0.3)]
    [InlineData("ball.inertiaFactor", 0.1)]
    [InlineData("air.density", 100)]
    [InlineData("air.kinematicViscosity", 0.1)]
    [InlineData("gravity", 1000)]
    [InlineData("forces.dragCoefficient", 10)]
    [InlineData("ground.spinDamping", 1)]
    [InlineData("ground.minimumBounceSpeed", 10)]
    [InlineData("ball.inertiaFactor", 1)]
    [InlineData("air.density", 0)]
    [InlineData("air.wind", 1000)]
    [InlineData("gravity", 0)]
    [InlineData("forces.dragCoefficient", 0)]
    [InlineData("forces.magnusCoefficient", -3)]
    [InlineData("ground.normalRestitution", 0)]
    [InlineData("ground.normalRestitution", 1)]
    [InlineData("ground.tangentialRestitution[0]", -1)]
    [InlineData("ground.tangentialRestitution[0]", 1)]
    [InlineData("ground.slidingFriction", 0)]
    [InlineData("ground.minimumBounceSpeed", 0.001)]
    [InlineData("ground.height", -1e6)]
    public void The_ends_of_a_range_are_allowed(string field, double value) => Assert.NotNull(Build(field, value));

    /// <summary>What a game may have between a shot-put and a balloon, on Mars, in a wind tunnel, at a frame a second.</summary>
    [Fact]
    public void What_a_game_has_is_in_range()
    {
        Scene[] scenes =
        [
            s_scene with { Ball = BallProperties.BeachBall },
            s_scene with { Ball = new BallProperties { Mass = 0.003, Radius = 0.15 } },
            s_scene with { Ball = new BallProperties { Mass = 0.08, Radius = 0.11 } },
            s_scene with { Ball = new BallProperties { Mass = 7.26, Radius = 0.06, InertiaFactor = 0.4 } },
            s_scene with { Gravity = 3.71, Air = new Air { Density = 0.02, KinematicViscosity = 7e-4 } },
            s_scene with { Gravity = 24.8, Air = new Air { Density = 6, KinematicViscosity = 3e-6, Wind = new Vector3d(100, 0, 0) } },
        ];
        foreach (Scene scene in scenes.Concat(scenes.Select(scene => scene with { Forces = ForceSet.Measured, Ground = Ground.Of(SurfaceMaterial.DryTurf) })))
        {
            foreach (Integrator integrator in Enum.GetValues<Integrator>())
            {
                var simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
                BallState state = simulator.Launch(new Vector3d(0, 3, 0), new Vector3d(60, 10, 5), new Vector3d(100, 200, -50));
                var log = new StepLog();
                for (int second = 0; second < 20; second++)
                {
                    simulator.Step(ref state, 1, log);
                }

                Assert.True(log.StalledSteps == 0, $"{integrator}: {log.StalledSteps} of 20 steps stalled, {scene}");
                Assert.True(state.Position.IsFinite && state.Velocity.Length <= 101 + (60 * scene.Gravity) && state.Spin.Length < 2000);
            }
        }
    }

    [Fact]
    public void A_ball_lighter_than_the_air_in_it_is_refused() =>
        Refused("ball.mass", "0.02", () => new Simulator(s_scene with { Ball = new BallProperties { Mass = 0.02, Radius = 0.5 } }));

    [Fact]
    public void A_choice_that_does_not_exist_is_refused()
    {
        Refused("forces.drag", "7", () => new Simulator(s_scene with { Forces = ForceSet.Published with { Drag = (ForceLaw)7 } }));
        Refused("forces.magnus", "7", () => new Simulator(s_scene with { Forces = ForceSet.Published with { Magnus = (ForceLaw)7 } }));
        Refused("forces.spinDecay", "-1", () => new Simulator(s_scene with { Forces = ForceSet.Published with { SpinDecay = (ForceLaw)(-1) } }));
        Refused("forces.coefficients", "9", () => new Simulator(s_scene with { Forces = ForceSet.Published with { Coefficients = (AerodynamicModel)9 } }));
        Refused("ground.aerodynamics", "5", () => new Simulator(s_scene with { Ground = Ground.PublishedTurf with { Aerodynamics = (GroundAerodynamics)5 } }));
        Refused("solver.integrator", "99", () => new Simulator(Scene.Published, new SolverSettings { Integrator = (Integrator)99 }));
        Refused("solver.collisionTiming", "2", () => new Simulator(Scene.Published, new SolverSettings { CollisionTiming = (CollisionTiming)2 }));
        Refused("solver.rollingTransition", "2", () => new Simulator(Scene.Published, new SolverSettings { RollingTransition = (RollingTransition)2 }));
    }

    [Fact]
    public void A_launch_out_of_range_is_refused()
    {
        var simulator = new Simulator(Scene.Published);
        var up = new Vector3d(0, 1, 0);
        Refused("launch.position", "(0, 2000000, 0)", () => simulator.Launch(new Vector3d(0, 2e6, 0), up, up));
        Refused("launch.position", "NaN", () => simulator.Launch(new Vector3d(0, 0, double.NaN), up, up));
        Refused("launch.velocity", "(0, 1000.1, 0)", () => simulator.Launch(up, new Vector3d(0, 1000.1, 0), up));
        Refused("launch.velocity", "Infinity", () => simulator.Launch(up, new Vector3d(0, 0, double.PositiveInfinity), up));
        Refused("launch.spin", "(0, 0, -10001)", () => simulator.Launch(up, up, new Vector3d(0, 0, -10_001)));
        Refused("launch.orientation", "(0, 0, 0, 0)", () => simulator.Launch(up, up, up, default));
        Refused("launch.orientation", "NaN", () => simulator.Launch(up, up, up, new Quaterniond(0, double.NaN, 0, 1)));
    }

    [Fact]
    public void A_run_out_of_range_is_refused_and_changes_nothing()
    {
        var simulator = new Simulator(Scene.Published);
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(3, 4, 5), Vector3d.Up);
        BallState before = state;
        var log = new StepLog();
        foreach (double bad in new[] { 0, -1, double.NaN, double.PositiveInfinity })
        {
            Refused("timeStep", string.Empty, () => simulator.Run(ref state, bad, 1, StopAt.Time, log));
            Refused("duration", string.Empty, () => simulator.Run(ref state, 0.01, bad, StopAt.Time, log));
        }

        Refused("timeStep", "1E-13", () => simulator.Run(ref state, 1e-13, 1, StopAt.Time, log));
        Refused("stopAt", "8", () => simulator.Run(ref state, 0.01, 1, (StopAt)8, log));
        Assert.Throws<ArgumentNullException>(() => simulator.Run(ref state, 0.01, 1, StopAt.Time, null!));
        Assert.Throws<ArgumentNullException>(() => simulator.Step(ref state, 0.01, null!));
        Assert.Equal(before, state);
        Assert.Equal(0, log.Steps);
    }

    [Fact]
    public void A_null_where_something_is_needed_is_refused_by_name()
    {
        Assert.Equal("ball.dragCurve", Assert.Throws<ArgumentNullException>(() => new Simulator(s_scene with { Ball = new BallProperties { DragCurve = null! } })).ParamName);
        Assert.Equal("ground.pattern.surfaces", Assert.Throws<ArgumentNullException>(() => new Simulator(s_scene with { Ground = new Ground { Pattern = new NoSurfaces() } })).ParamName);
        Assert.Throws<ArgumentNullException>(() => new Simulator(s_scene with { Forces = ForceSet.Published with { CustomForces = [null!] } }));
        Assert.Throws<ArgumentNullException>(() => IForce.From(null!));
    }

    [Fact]
    public void Every_preset_is_valid()
    {
        Assert.All([Scene.Published, Scene.Published, Scene.Measured, Scene.Vacuum, Scene.HighAltitude, Scene.Published with { Air = new Air { Wind = new Vector3d(1, 2, 3) } }], scene => scene.Validate());
        Assert.All([ForceSet.None, ForceSet.Constant, ForceSet.Regularized, ForceSet.Measured], forces => (s_scene with { Forces = forces }).Validate());
        Assert.All([Ground.PublishedTurf, Ground.Presets["publishedWetTurf"], Ground.Presets["publishedCourt"], Ground.Presets["publishedSand"]], ground => (s_scene with { Ground = ground }).Validate());
        Assert.All(
            [
                BallProperties.Tunnel, BallProperties.Tango12, BallProperties.Teamgeist, BallProperties.Jabulani, BallProperties.Brazuca,
                BallProperties.YouthFootball, BallProperties.Futsal, BallProperties.BeachBall, BallProperties.MedicineBall,
            ],
            ball => (s_scene with { Ball = ball }).Validate());
        Assert.Equal(2.0 / 3 * 0.43 * 0.11 * 0.11, BallProperties.Tunnel.MomentOfInertia, 1e-18);
    }

    private static void Refused(string field, double value) =>
        Refused(
            field,
            value.ToString("R", System.Globalization.CultureInfo.InvariantCulture),
            () => Build(field, value));

    private static void Refused(string field, string value, Func<object> build)
    {
        ArgumentOutOfRangeException error = Assert.Throws<ArgumentOutOfRangeException>(() => { build(); });
        Assert.Equal(field, error.ParamName);
        Assert.Matches($"^{System.Text.RegularExpressions.Regex.Escape(field)} is .+; allowed: .+", error.Message);
        Assert.Contains(value, error.Message, StringComparison.Ordinal);
    }

    private static void Refused(string field, string value, Func<bool> run) => Refused(field, value, () => (object)run());

    private static Simulator Build(string field, double value)
    {
        Ground ground = Ground.PublishedTurf;
        ForceSet forces = ForceSet.Published;
        return field switch
        {
            "ball.mass" => new Simulator(s_scene with { Ball = new BallProperties { Mass = value } }),
            "ball.radius" => new Simulator(s_scene with { Ball = new BallProperties { Radius = value } }),
            "ball.inertiaFactor" => new Simulator(s_scene with { Ball = new BallProperties { InertiaFactor = value } }),
            "air.density" => new Simulator(s_scene with { Air = new Air { Density = value } }),
            "air.kinematicViscosity" => new Simulator(s_scene with { Air = new Air { KinematicViscosity = value } }),
            "air.wind" => new Simulator(s_scene with { Air = new Air { Wind = new Vector3d(0, value, 0) } }),
            "gravity" => new Simulator(s_scene with { Gravity = value }),
            "forces.dragCoefficient" => new Simulator(s_scene with { Forces = forces with { DragCoefficient = value } }),
            "forces.magnusCoefficient" => new Simulator(s_scene with { Forces = forces with { MagnusCoefficient = value } }),
            "forces.spinDecayCoefficient" => new Simulator(s_scene with { Forces = forces with { SpinDecayCoefficient = value } }),
            "ground.normalRestitution" => new Simulator(s_scene with { Ground = ground with { Material = ground.Material with { NormalRestitution = value } } }),
            "ground.tangentialRestitution[0]" => new Simulator(s_scene with { Ground = ground with { Material = ground.Material with { TangentialRestitution = value }, TangentialRestitutionZ = 0.2 } }),
            "ground.tangentialRestitution[1]" => new Simulator(s_scene with { Ground = ground with { Material = ground.Material with { }, TangentialRestitutionZ = value } }),
            "ground.spinRestitution" => new Simulator(s_scene with { Ground = ground with { Material = ground.Material with { SpinRestitution = value } } }),
            "ground.slidingFriction" => new Simulator(s_scene with { Ground = ground with { Material = ground.Material with { SlidingFriction = value } } }),
            "ground.rollingFriction" => new Simulator(s_scene with { Ground = ground with { Material = ground.Material with { RollingResistance = value } } }),
            "ground.spinDamping" => new Simulator(s_scene with { Ground = ground with { Material = ground.Material with { SpinDamping = value } } }),
            "ground.minimumBounceSpeed" => new Simulator(s_scene with { Ground = ground with { MinimumBounceSpeed = value } }),
            "ground.restEnergy" => new Simulator(s_scene with { Ground = ground with { RestEnergy = value } }),
            "ground.height" => new Simulator(s_scene with { Ground = ground with { Height = value } }),
            "solver.collisionTolerance" => new Simulator(s_scene, new SolverSettings { CollisionTolerance = value }),
            _ => throw new ArgumentOutOfRangeException(nameof(field), field, "unknown"),
        };
    }

    private sealed class NoSurfaces : ISurfacePattern
    {
        public IReadOnlyList<SurfaceMaterial> Surfaces => null!;

        public double MinimumWidth => 1;

        public int At(double x, double z) => 0;
    }
}
