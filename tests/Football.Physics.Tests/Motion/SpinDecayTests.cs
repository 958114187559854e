using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>Spin decay stops a spin at most; it never turns it round.</summary>
public sealed class SpinDecayTests
{
    private static readonly Vector3d s_high = new(0, 5000, 0);

    [Theory]
    [InlineData(ForceLaw.Empirical)]
    [InlineData(ForceLaw.Constant)]
    public void A_spin_never_grows_and_never_reverses(ForceLaw law)
    {
        foreach (AerodynamicModel form in Enum.GetValues<AerodynamicModel>())
        {
            Scene scene = Scene.Published with { Gravity = 0, Forces = ForceSet.Published with { SpinDecay = law, SpinDecayCoefficient = 0.01, Coefficients = form } };
            ForEach(scene, (simulator, state, timeStep) =>
            {
                Vector3d axis = state.Spin / state.Spin.Length;
                double rate = state.Spin.Length;
                var log = new StepLog();
                for (int i = 0; i < 8; i++)
                {
                    simulator.Step(ref state, timeStep, log);
                    double along = Vector3d.Dot(state.Spin, axis);
                    Assert.True(along >= 0 && along <= rate * (1 + 1e-14), $"{simulator.Settings.Integrator} {timeStep} s: {rate} to {along}");
                    Assert.InRange(Vector3d.Distance(state.Spin, along * axis), 0, 1e-14 * rate);
                    rate = along;
                }
            });
        }
    }

    [Fact]
    public void A_tiny_spin_is_gone_at_the_instant_the_torque_says_and_stays_gone()
    {
        // The torque on a ball at rest in the spin's sense is finite: ω̇ ≈ −0.5 rad/s² at 25 m/s.
        Scene scene = Scene.Published with { Gravity = 0, Forces = ForceSet.None with { Coefficients = AerodynamicModel.Published, SpinDecay = ForceLaw.Empirical } };
        double rate = Laws.PlainLaws.DecayTorque(scene, 25, 0) / scene.Ball.MomentOfInertia;
        Assert.InRange(rate, 0.4, 0.6);
        foreach (Integrator integrator in Flight.Integrators)
        {
            foreach (double timeStep in new[] { 0.001, 0.04, 1.0 })
            {
                var simulator = new Simulator(scene, Flight.With(integrator));
                BallState before = simulator.Launch(s_high, new Vector3d(25, 0, 0), new Vector3d(0, 1e-3, 0));
                BallState after = before;
                double end = 1e-3 / rate;
                var log = new StepLog();
                simulator.Run(ref before, timeStep, 0.99 * end, StopAt.Time, log);
                simulator.Run(ref after, timeStep, 1.01 * end, StopAt.Time, log);
                Assert.Equal(1e-5, before.Spin.Y, 1e-9);
                Assert.Equal(Vector3d.Zero, after.Spin);
                simulator.Step(ref after, 1, log);
                Assert.Equal(Vector3d.Zero, after.Spin);
            }
        }
    }

    [Fact]
    public void The_angle_turned_until_the_spin_is_gone_is_half_the_spin_times_its_time()
    {
        Scene scene = Scene.Published with { Gravity = 0, Forces = ForceSet.None with { Coefficients = AerodynamicModel.Published, SpinDecay = ForceLaw.Empirical } };
        double rate = Laws.PlainLaws.DecayTorque(scene, 25, 0) / scene.Ball.MomentOfInertia;
        BallState state = Flight.Play(scene, SolverSettings.Default, 0.5, 2, StopAt.Time, s_high, new Vector3d(25, 0, 0), new Vector3d(0, 0.05, 0), out _);
        double angle = 0.05 * 0.05 / (2 * rate);
        Assert.Equal(Math.Sin(angle / 2), state.Orientation.Y, 1e-8);
    }

    [Theory]
    [ProfileData]
    public void A_ball_in_flight_without_spin_stays_without(Profile profile)
    {
        foreach (Integrator integrator in Flight.Integrators)
        {
            BallState state = Flight.Play(
                profile.Scene() with { Air = new Air { Wind = new Vector3d(5, 1, 3) } }, Flight.With(integrator), 0.01, 2, StopAt.Time, s_high, new Vector3d(25, 5, 3), Vector3d.Zero, out _);
            Assert.Equal(Vector3d.Zero, state.Spin);
            Assert.Equal(Quaterniond.Identity, state.Orientation);
        }
    }

    [Theory]
    [ProfileData]
    public void Drag_never_turns_the_ball_round_whatever_the_step(Profile profile)
    {
        Scene scene = profile.Scene() with { Gravity = 0, Air = new Air { Density = 100 }, Forces = profile.Forces() with { Magnus = ForceLaw.None } };
        foreach (AerodynamicModel form in Enum.GetValues<AerodynamicModel>())
        {
            ForEach(scene with { Forces = scene.Forces with { Coefficients = form } }, (simulator, state, timeStep) =>
            {
                var limit = new PieceLimit(200_000);
                var log = new StepLog { Observer = limit };
                Vector3d from = state.Velocity;
                for (int i = 0; i < 5; i++)
                {
                    double speed = state.Velocity.Length;
                    simulator.Step(ref state, timeStep, log);
                    Assert.False(limit.Reached, $"{simulator.Settings.Integrator} {timeStep} s does not end");
                    Assert.True(Vector3d.Dot(state.Velocity, from) >= 0, $"{simulator.Settings.Integrator} {timeStep} s: {from} to {state.Velocity}");
                    Assert.True(state.Velocity.Length <= speed, $"{simulator.Settings.Integrator} {timeStep} s: {speed} m/s to {state.Velocity}");
                    Assert.True(state.Position.IsFinite && state.Spin.IsFinite);
                }
            });
        }
    }

    private static void ForEach(Scene scene, Action<Simulator, BallState, double> hold)
    {
        var random = new Shots(214);
        foreach (Integrator integrator in Flight.Integrators)
        {
            var simulator = new Simulator(scene, Flight.With(integrator));
            foreach (double timeStep in new[] { 0.001, 0.04, 0.5, 3 })
            {
                foreach (double spin in new[] { 1e-12, 1e-6, 1e-3, 0.1, 1, 20, 300 })
                {
                    Vector3d velocity = random.Uniform(1, 60) * random.Direction();
                    hold(simulator, simulator.Launch(s_high, velocity, spin * random.Direction()), timeStep);
                }
            }
        }
    }
}
