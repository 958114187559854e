using FootballPhysics.Labs.Stability;
using FootballPhysics.Prediction;
using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Tests.Stability;

/// <summary>What the stress matrix has found, by name, so that it stays found.</summary>
public sealed class FoundByTheLabTests
{
    private const string BalloonInADowndraught =
        "{\"launch\":{\"position\":[0,1,0],\"velocity\":[20,5,0],\"spin\":[1,2,3]},\"ball\":{\"mass\":0.01,\"radius\":0.2},\"air\":{\"wind\":[5,-30,3]},\"stop\":{\"at\":\"time\",\"time\":2}}";

    private const string SlowEnd =
        "{\"ball\":{\"mass\":0.1,\"radius\":0.2,\"inertiaFactor\":0.6666666666666666},\"air\":{\"density\":1.1033023468138958,\"kinematicViscosity\":1.3498802604024886e-05,\"wind\":[0,0,0]},\"gravity\":1.6206046637381846,\"forces\":{\"buoyancy\":true,\"drag\":\"empirical\",\"magnus\":\"empirical\",\"spinDecay\":\"none\",\"coefficients\":\"published\",\"dragCoefficient\":0.25,\"magnusCoefficient\":0.25,\"spinDecayCoefficient\":0},\"ground\":{\"normalRestitution\":0.8143477420802645,\"tangentialRestitution\":[0,-0.3775325707656807],\"spinRestitution\":1,\"slidingFriction\":0.02614954239350715,\"rollingFriction\":0.041476359427294045,\"spinDamping\":0.00039387873483535,\"minimumBounceSpeed\":0.001,\"restEnergy\":4.271496969544195e-06,\"height\":0,\"aerodynamics\":\"horizontal\"},\"launch\":{\"position\":[11.23551051753445,0.20000007251544197,39.01885546103574],\"velocity\":[-0.5988440431123022,111.11230995181069,36.10218992032804],\"spin\":[0.006711106777204456,0.0036294471342275753,-0.001970905161856672]},\"solver\":{\"integrator\":\"semiImplicitEuler\",\"timeStep\":0.016418037356277657,\"rollingTransition\":\"heuristic\",\"collisionTiming\":\"exact\"},\"stop\":{\"at\":\"rest\",\"time\":300}}";

    private const string SuddenEnd =
        "{\"ball\":{\"mass\":0.1,\"radius\":0.2,\"inertiaFactor\":0.6666666666666666},\"air\":{\"density\":1.1762562914182562,\"kinematicViscosity\":1.3951860254354255e-05,\"wind\":[0,0,0]},\"gravity\":5.272505996161495,\"forces\":{\"buoyancy\":true,\"drag\":\"empirical\",\"magnus\":\"empirical\",\"spinDecay\":\"constant\",\"coefficients\":\"regularised\",\"dragCoefficient\":0.644523874491457,\"magnusCoefficient\":0.25,\"spinDecayCoefficient\":0.000177260342930598},\"ground\":{\"normalRestitution\":0.2542465753203128,\"tangentialRestitution\":[1,0],\"spinRestitution\":0.8774676695157354,\"slidingFriction\":1.0523758826972465,\"rollingFriction\":0.02191011467771921,\"spinDamping\":0.0029924964380844024,\"minimumBounceSpeed\":0.2,\"restEnergy\":0.0001593796889270851,\"height\":18.666325181443426,\"aerodynamics\":\"none\"},\"launch\":{\"position\":[41.224377115789906,31.246972884560805,-36.61968908044834],\"velocity\":[-0.06901910205911946,-0.07886720140431411,-0.0587855414366288],\"spin\":[0,0,0]},\"solver\":{\"integrator\":\"rk4\",\"timeStep\":0.024295629392409174,\"rollingTransition\":\"heuristic\",\"collisionTiming\":\"exact\"},\"stop\":{\"at\":\"rest\",\"time\":300}}";

    /// <summary>Struck along the ground, its spin carries it: it touches, does not leave, and is pressed again a moment later. It went on 2 mm within the ground.</summary>
    [Theory]
    [InlineData(0.01)]
    [InlineData(0.04)]
    [InlineData(0.08)]
    public void A_ball_whose_lift_is_about_its_weight_stays_above_the_ground(double timeStep)
    {
        var simulator = new Simulator(Scene.Measured);
        BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), new Vector3d(25.96, 0, 11.01), new Vector3d(-22.3, 41.2, 52.6));
        Assert.Equal(MotionState.Airborne, ball.Motion);
        var path = new Trajectory();
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 0.4, TimeStep = timeStep, StopAt = StopAt.Time }, path);
        double lowest = Enumerable.Range(0, 4001).Min(i => path.PositionAt(0.0001 * i).Y);
        Assert.InRange(lowest, simulator.ContactHeight - 1e-9, 1);
        Assert.Equal(MotionState.Sliding, path.Final.Motion);
    }

    /// <summary>The apex of a straight piece of path was 0/0.</summary>
    [Fact]
    public void A_path_that_does_not_turn_has_a_finite_apex()
    {
        var result = FootballCommand.Play(BalloonInADowndraught, "--set", "solver.integrator=euler");
        Assert.InRange(result.GetProperty("apex").GetDouble(), 1, 2);
    }

    /// <summary>It bounced ever lower and never stayed down: no end of impacts within one step.</summary>
    [Theory]
    [InlineData("euler")]
    [InlineData("semiImplicitEuler")]
    [InlineData("rk2")]
    [InlineData("rk4")]
    public void A_balloon_that_the_wind_presses_to_the_ground_stays_down(string integrator)
    {
        var result = FootballCommand.Play(BalloonInADowndraught, "--set", $"solver.integrator={integrator}");
        Assert.InRange(result.GetProperty("bounces").GetInt32(), 1, 2000);
    }

    /// <summary>With hardly an inertia a ball goes with the wind and rises or sinks at its terminal speed, at once and without end of pieces.</summary>
    [Theory]
    [InlineData("0.001")]
    [InlineData("0.003")]
    public void A_ball_with_hardly_an_inertia_goes_with_the_wind_at_its_terminal_speed(string mass)
    {
        foreach (string integrator in new[] { "euler", "semiImplicitEuler", "rk2", "rk4" })
        {
            var result = FootballCommand.Play(
                "{\"profile\":\"published\",\"launch\":{\"position\":[0,1,0],\"velocity\":[20,5,0],\"spin\":[1,2,3]},\"stop\":{\"at\":\"time\",\"time\":2},\"air\":{\"wind\":[3,0,-4]},\"ball\":{\"mass\":"
                + mass + "}}",
                "--set",
                $"solver.integrator={integrator}");
            double[] velocity = [.. result.GetProperty("final").GetProperty("velocity").EnumerateArray().Select(item => item.GetDouble())];

            // ½ ρ C_D A u² = (4/3 π r³ ρ − m) g with C_D 0.5009 at this speed
            double lighter = 1 - (double.Parse(mass, System.Globalization.CultureInfo.InvariantCulture) / (4.0 / 3.0 * Math.PI * Math.Pow(0.11, 3) * 1.2));
            Assert.Equal(3, velocity[0], 1e-3);
            Assert.Equal(2.397 * Math.Sqrt(lighter), velocity[1], 2e-3);
            Assert.Equal(-4, velocity[2], 1e-3);
            Assert.InRange(result.GetProperty("steps").GetInt64(), 200, 200 * 1100);
        }
    }

    [Fact]
    public void A_strong_Magnus_force_without_drag_does_not_feed_a_method_of_low_order()
    {
        foreach (string integrator in new[] { "euler", "semiImplicitEuler", "rk2", "rk4" })
        {
            var result = FootballCommand.Play(
                "{\"launch\":{\"position\":[0,50,0],\"velocity\":[20,5,0],\"spin\":[100,200,300]},\"stop\":{\"at\":\"time\",\"time\":2},"
                + "\"ball\":{\"mass\":0.1,\"radius\":0.2},\"forces\":{\"drag\":\"none\",\"magnus\":\"constant\",\"magnusCoefficient\":10}}",
                "--set",
                $"solver.integrator={integrator}");
            double[] velocity = [.. result.GetProperty("final").GetProperty("velocity").EnumerateArray().Select(item => item.GetDouble())];
            Assert.All(velocity, component => Assert.InRange(component, -40, 40));
        }
    }

    /// <summary>The cap for spins near zero left out that a fast spin decays by itself: in one step ω grew to 10¹¹ rad/s.</summary>
    [Fact]
    public void A_fast_spin_of_a_slow_ball_on_the_ground_in_dense_air_only_decays()
    {
        var scene = Scene.Published with
        {
            Ball = new BallProperties { Mass = 0.4, Radius = 0.24, InertiaFactor = 0.1 },
            Air = new Air { Density = 100, KinematicViscosity = 0.1 },
            Gravity = 1e-6,
            Forces = ForceSet.Regularized with { Buoyancy = false },
            Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { NormalRestitution = 0, RollingResistance = 0 } },
        };
        var log = new StepLog();
        foreach (Integrator integrator in Enum.GetValues<Integrator>())
        {
            var simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
            BallState state = simulator.Launch(new Vector3d(0, 0.24, 0), new Vector3d(-0.1, -0.1, 0.1), new Vector3d(60, -370, -470));
            for (int i = 0; i < 100; i++)
            {
                double before = state.Spin.Length;
                simulator.Step(ref state, 0.001, log);
                Assert.InRange(state.Spin.Length, 0, before);
                Assert.InRange(state.Velocity.Length, 0, 0.2);
            }
        }
    }

    /// <summary>The sum of the pieces of a step ran past its end by rounding, and the next event lay before the one before.</summary>
    [Theory]
    [InlineData(SlowEnd)]
    [InlineData(SuddenEnd)]
    public void Events_are_in_order_to_the_last_bit(string scenario)
    {
        var result = FootballCommand.Play(scenario);
        double[] times = [.. result.GetProperty("events").EnumerateArray().Select(item => item.GetProperty("time").GetDouble())];
        Assert.InRange(times.Length, 2, 1000);
        Assert.Equal(times.Order(), times);
        Assert.True(times[^1] <= result.GetProperty("final").GetProperty("time").GetDouble());
    }

    /// <summary>A stage past the end of the spin was turned on by the decay, and without a grip of the ground the spin grew again on the other side.</summary>
    [Theory]
    [InlineData(0.0, 0.5)]
    [InlineData(0.0, 2.0)]
    [InlineData(0.009, 0.5)]
    [InlineData(0.009, 2.0)]
    public void A_spin_that_the_air_stops_while_the_ball_slides_stays_stopped(double friction, double step)
    {
        var scene = Scene.Published with
        {
            Ball = BallProperties.BeachBall,
            Gravity = 2.5,
            Forces = ForceSet.Published with { Buoyancy = false, Drag = ForceLaw.None, Magnus = ForceLaw.None },
            Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { NormalRestitution = 0, SlidingFriction = friction, SpinDamping = 0 } },
        };
        var log = new StepLog();
        foreach (Integrator integrator in Enum.GetValues<Integrator>())
        {
            var simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
            BallState state = simulator.Launch(new Vector3d(0, scene.Ball.Radius, 0), new Vector3d(-75, 0, 160), new Vector3d(22, 53, -45));
            for (int i = 0; i < 40; i++)
            {
                double before = Energy(scene, in state);
                simulator.Step(ref state, step, log);
                Assert.Equal(MotionState.Sliding, state.Motion);
                Assert.True(Energy(scene, in state) <= before, $"{integrator}, step {i}: {before} J to {Energy(scene, in state)} J");
            }

            Assert.Equal(Vector3d.Zero, state.Spin);
        }
    }

    /// <summary>In still air there was no force to divide the next step by, and the first breath of a stage threw a ball without inertia to infinity.</summary>
    [Theory]
    [ProfileData(ForceLaw.Constant)]
    [ProfileData(ForceLaw.Empirical)]
    public void A_huge_light_ball_that_goes_with_the_wind_stays_with_it(Profile profile, ForceLaw drag)
    {
        var scene = profile.Scene() with
        {
            Ball = new BallProperties { Mass = 100, Radius = 1.6, InertiaFactor = 0.1 },
            Air = new Air { Density = 100, KinematicViscosity = 0.1, Wind = new Vector3d(-0.1, 0.135, -0.07) },
            Gravity = 0.001,
            Forces = profile.Forces() with
            {
                Buoyancy = false,
                Drag = drag,
                Magnus = ForceLaw.Constant,
                MagnusCoefficient = -0.3,
                SpinDecay = ForceLaw.None,
                Coefficients = AerodynamicModel.Regularized,
            },
        };
        var log = new StepLog();
        foreach (Integrator integrator in Enum.GetValues<Integrator>())
        {
            var simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
            BallState state = simulator.Launch(new Vector3d(0, 100, 0), new Vector3d(0.2, -24, -9), new Vector3d(0, 0, 31));
            for (int i = 0; i < 40; i++)
            {
                simulator.Step(ref state, 0.01, log);
                Assert.True(state.Velocity.Length <= 30 && state.Spin.Length <= 40, $"{integrator}, step {i}: {state.Velocity}, {state.Spin}");
            }
        }
    }

    /// <summary>The fused laws took every gravity for the earth's: a stage slower than their tables had another ball's drag.</summary>
    [Theory]
    [ProfileData(Integrator.Rk2)]
    [ProfileData(Integrator.Rk4)]
    public void Gravity_that_turns_a_ball_round_within_a_step_leaves_its_drag_alone(Profile profile, Integrator integrator)
    {
        const double Step = 0.0028;
        var simulator = new Simulator(profile.Scene() with { Gravity = 1000 }, new SolverSettings { Integrator = integrator });
        BallState once = simulator.Launch(new Vector3d(0, 10, 0), new Vector3d(0, 1.87, 0), new Vector3d(0, 5, 0));
        BallState often = once;
        var log = new StepLog();
        simulator.Step(ref once, Step, log);
        for (int i = 0; i < 64; i++)
        {
            simulator.Step(ref often, Step / 64, log);
        }

        Assert.Equal(0, Vector3d.Distance(once.Velocity, often.Velocity), 2e-4);
    }

    /// <summary>Scenes of the lab: a spin about the vertical so small that its product with the one before is zero was reversed; the energy of a ball that strong gravity turns round grew.</summary>
    [Theory]
    [InlineData(694308)]
    [InlineData(504698)]
    public void A_scene_of_the_lab_holds(int scene)
    {
        var done = FootballCommand.Run("", "lab", "stability", "--seed", "2", "--scene", $"{scene}");
        Assert.Contains("holds", done.Error);
        Assert.Equal(0, done.ExitCode);
    }

    /// <summary>A ball that the air lifts as long as it lies, and drops as soon as it does not, came down 1e10 times in a step; and one of 1e-322 s was never searched to its end.</summary>
    [Fact]
    public void A_step_ends_even_where_a_ball_is_lifted_and_dropped_without_end()
    {
        var done = FootballCommand.Run("", "lab", "stability", "--profile", "measured", "--seed", "4", "--scene", "8323");
        Assert.Contains("holds", done.Error);
        Assert.Equal(0, done.ExitCode);
    }

    private static double Energy(Scene scene, in BallState s) =>
        0.5 * ((scene.Ball.Mass * s.Velocity.LengthSquared) + (scene.Ball.MomentOfInertia * s.Spin.LengthSquared));

    /// <summary>Without weight it was pressed on the ground by an air that did not act there: sliding it was not slowed and left, flying it was slowed and taken up, in turn.</summary>
    [Theory]
    [ProfileData]
    public void A_ball_without_weight_on_ground_without_aerodynamics_is_not_taken_up_and_let_go_in_turn(Profile profile)
    {
        var scene = profile.Scene() with
        {
            Ball = new BallProperties { Mass = 0.1, Radius = 0.2 },
            Air = new Air { Wind = new Vector3d(0, 0.02, 0.05) },
            Gravity = 0,
            Ground = profile.Ground() with
            {
                Material = profile.Ground().Material with
                {
                    NormalRestitution = 0,
                    SlidingFriction = 1,
                },
                Aerodynamics = GroundAerodynamics.None
            },
        };
        foreach (Integrator integrator in Flight.Integrators)
        {
            Flight.Play(
                scene, Flight.With(integrator), 0.5, 60, StopAt.Time, new Vector3d(0, 1, 0), new Vector3d(9, 2, 23), new Vector3d(390, -8, 190), out StepLog log);
            Assert.Matches("^Impact( Impact)*( Slide)?( ContactEnd)?$", Flight.Kinds(log));
        }
    }

    /// <summary>A stage found the spin next to zero and pointing anywhere, and the air, which only ends a spin, made it five times as fast.</summary>
    [Theory]
    [InlineData(369441)]
    [InlineData(762821)]
    public void A_slide_whose_spin_the_air_ends_gains_none(long index) => Assert.Null(StressRun.Play(StressGenerator.Make(5, index)).Failure);
}
