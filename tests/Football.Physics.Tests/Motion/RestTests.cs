using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>What does not move stays where it is, to the last bit.</summary>
public sealed class RestTests
{
    private static readonly Quaterniond s_turned = new Quaterniond(0.1, -0.5, 0.7, 0.2).Normalized();

    public static TheoryData<Integrator> Integrators() => Flight.EveryIntegrator();

    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void A_ball_left_alone_on_the_ground_never_moves(Profile profile, Integrator integrator)
    {
        // The friction of a roll holds the default ball against a breeze, the thesis' ball feels no wind at rest.
        Vector3d blows = profile == Profile.Default ? new Vector3d(1, 0.2, -2) : new Vector3d(30, 3, -50);
        foreach (Vector3d wind in new[] { Vector3d.Zero, blows })
        {
            var simulator = new Simulator(profile.Scene() with { Air = new Air { Wind = wind } }, Flight.With(integrator));
            BallState state = simulator.Launch(new Vector3d(1.1, 0.11, -3.3), Vector3d.Zero, Vector3d.Zero, s_turned);
            BallState start = state;
            var log = new StepLog();
            simulator.Step(ref state, 0.01, log);
            BallEvent rest = Assert.Single(log.Events.Span.ToArray());
            Assert.Equal(BallEventKind.Rest, rest.Kind);
            Assert.Equal(0, rest.Time);
            for (int i = 0; i < 1000; i++)
            {
                simulator.Step(ref state, 0.3, log);
            }

            AssertStill(start, state);
            Assert.Equal(MotionState.Rest, state.Motion);
            Assert.Equal(1, log.Events.Count);
            Assert.InRange(log.Evaluations, 0, 1);
            Assert.Equal(300.01, state.Time, 1e-9);
        }
    }

    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void A_ball_in_still_air_without_gravity_never_moves(Profile profile, Integrator integrator)
    {
        foreach (AerodynamicModel form in Enum.GetValues<AerodynamicModel>())
        {
            var simulator = new Simulator(profile.Scene() with { Gravity = 0, Forces = profile.Forces() with { Coefficients = form } }, Flight.With(integrator));
            BallState state = simulator.Launch(new Vector3d(1.1, 5, -3.3), Vector3d.Zero, Vector3d.Zero, s_turned);
            BallState start = state;
            var log = new StepLog();
            for (int i = 0; i < 1000; i++)
            {
                simulator.Step(ref state, 0.05, log);
            }

            AssertStill(start, state);
            Assert.Equal(MotionState.Airborne, state.Motion);
            Assert.Equal(0, log.Events.Count);
        }
    }

    [Theory]
    [ProfileData]
    public void A_ball_that_came_to_rest_stays_put_in_wind_until_the_next_kick(Profile profile)
    {
        var simulator = new Simulator(profile.Scene() with { Air = new Air { Wind = new Vector3d(-3, 0, 1) } });
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(6, 2, 0), new Vector3d(0, 3, 20));
        var log = new StepLog();
        Assert.True(simulator.Run(ref state, 0.01, 60, StopAt.Rest, log));
        Assert.Equal(Vector3d.Zero, state.Velocity);
        Assert.Equal(Vector3d.Zero, state.Spin);
        BallState rested = state;
        int events = log.Events.Count;
        simulator.Run(ref state, 0.01, 5, StopAt.Time, log);
        AssertStill(rested, state);
        Assert.Equal(events, log.Events.Count);

        simulator.Kick(ref state, new Vector3d(0, 8, -12), new Vector3d(1, 2, 3));
        Assert.Equal(MotionState.Airborne, state.Motion);
        Assert.Equal(rested.Position, state.Position);
        Assert.InRange(Differences.Rotation(rested.Orientation, state.Orientation), 0, 1e-15);
        Assert.Equal(rested.Time + 5, state.Time, 1e-9);
        simulator.Step(ref state, 0.1, log);
        Assert.True(state.Position.Y > 0.5);
    }

    [Theory]
    [ProfileData]
    public void Rest_is_declared_where_the_energy_falls_to_the_threshold(Profile profile)
    {
        var random = new Shots(33);
        foreach (Integrator integrator in Flight.Integrators)
        {
            for (int i = 0; i < 20; i++)
            {
                double energy = random.Uniform(1e-5, 0.05);
                var scene = profile.Scene() with { Ground = profile.Ground() with { RestEnergy = energy }, Air = new Air { Wind = new Vector3d(1, 0, 0.5) } };
                Vector3d velocity = random.Velocity(1, 10, 0, 40);
                Flight.Play(
                    scene, Flight.With(integrator), 0.005, 100, StopAt.Rest, new Vector3d(0, 0.11, 0), velocity, random.Uniform(0, 40) * random.Direction(), out StepLog log);
                BallEvent rest = Flight.First(log, BallEventKind.Rest);
                double left = 0.5 * ((0.43 * rest.Velocity.LengthSquared) + (scene.Ball.MomentOfInertia * rest.Spin.LengthSquared));

                // A ball that starts to roll with less than that rests at once.
                bool atOnce = rest.Time == Flight.First(log, BallEventKind.Roll).Time;
                Assert.InRange(left / energy, atOnce ? 0 : 1 - 1e-6, 1 + 1e-6);
            }
        }
    }

    private static void AssertStill(in BallState expected, in BallState actual)
    {
        Assert.Equal(expected.Position, actual.Position);
        Assert.Equal(expected.Velocity, actual.Velocity);
        Assert.Equal(expected.Spin, actual.Spin);
        Assert.Equal(expected.Orientation, actual.Orientation);
    }
}
