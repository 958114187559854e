using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Motion;

/// <summary>How a launch at or near the ground starts.</summary>
public sealed class LaunchTests
{
    private const double Threshold = 0.2;
    private static readonly Simulator s_simulator = new(Scene.Published with { Ground = Ground.Turf with { Height = 1.5, MinimumBounceSpeed = Threshold } });

    [Fact]
    public void A_launch_below_contact_height_is_raised_to_it()
    {
        foreach (double y in new[] { -100, 0, 1.5, 1.6, 1.61 - 1e-12, 1.61 })
        {
            Assert.Equal(new Vector3d(3, 1.61, 4), s_simulator.Launch(new Vector3d(3, y, 4), new Vector3d(1, 5, 0), Vector3d.Zero).Position);
        }

        Assert.Equal(1.61, s_simulator.ContactHeight);
        Assert.Equal(1.6100001, s_simulator.Launch(new Vector3d(0, 1.6100001, 0), Vector3d.Zero, Vector3d.Zero).Position.Y);
    }

    [Theory]
    [InlineData(0.2, "")]
    [InlineData(5.0, "")]
    [InlineData(-0.2, "Impact Slide")]
    [InlineData(-0.5, "Impact")]
    [InlineData(-9.0, "Impact")]
    [InlineData(0.1999, "")]
    [InlineData(0.0, "")]
    [InlineData(-0.1999, "")]
    public void At_contact_the_vertical_speed_decides_between_flight_impact_and_ground(double vertical, string events)
    {
        BallState state = s_simulator.Launch(new Vector3d(0, 1.61, 0), new Vector3d(3, vertical, 0), Vector3d.Zero);
        bool ground = Math.Abs(vertical) < Threshold;
        Assert.Equal(ground ? MotionState.Sliding : MotionState.Airborne, state.Motion);
        Assert.Equal(ground ? 0 : vertical, state.Velocity.Y);

        var log = new StepLog();
        s_simulator.Step(ref state, 1e-9, log);
        Assert.Equal(events, Flight.Kinds(log));
        if (log.Events.Count > 0)
        {
            BallEvent impact = log.Events[0];
            Assert.Equal(0, impact.Time);
            Assert.Equal(new Vector3d(0, 1.61, 0), impact.Position);
            Assert.Equal(vertical, impact.VelocityBefore.Y);
            Assert.Equal(-0.6 * vertical, impact.Velocity.Y, 1e-15);
        }
    }

    [Fact]
    public void A_launch_on_the_ground_without_slip_rolls_without_an_event()
    {
        BallState state = s_simulator.Launch(new Vector3d(0, 1.61, 0), new Vector3d(3, 0.1, 0), new Vector3d(0, 5, -3 / 0.11));
        Assert.Equal(MotionState.Rolling, state.Motion);
        var log = new StepLog();
        s_simulator.Step(ref state, 0.1, log);
        Assert.Equal(0, log.Events.Count);
    }

    [Fact]
    public void The_orientation_of_a_launch_is_normalised()
    {
        BallState state = s_simulator.Launch(new Vector3d(0, 5, 0), Vector3d.Zero, Vector3d.Zero, new Quaterniond(0, 3, 0, 4));
        Assert.Equal(new Quaterniond(0, 0.6000000000000001, 0, 0.8), state.Orientation);
    }

    [Theory]
    [InlineData(0.4, MotionState.Airborne, "Impact")]
    [InlineData(0.3999, MotionState.Sliding, "Impact Slide")]
    public void After_an_impact_a_ball_slower_than_the_minimum_bounce_speed_stays_down(double speed, MotionState motion, string events)
    {
        var simulator = new Simulator(Scene.Published with { Ground = Ground.Turf with { NormalRestitution = 0.5, MinimumBounceSpeed = 0.2 } });
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, -speed, 0), Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, 0.01, 1, StopAt.Impact, log);
        Assert.Equal(motion, state.Motion);
        Assert.Equal(events, Flight.Kinds(log));

        // The impact carries the impulse's own vertical speed, the state and the slide have it set to zero.
        Assert.Equal(0.5 * speed, log.Events[0].Velocity.Y, 1e-15);
        Assert.Equal(motion == MotionState.Airborne ? 0.5 * speed : 0, state.Velocity.Y, 1e-15);
        if (motion == MotionState.Sliding)
        {
            Assert.Equal(0, log.Events[1].Velocity.Y);
            Assert.Equal(log.Events[0].Velocity.X, log.Events[1].Velocity.X);
        }
    }

    [Fact]
    public void A_ball_that_does_not_bounce_at_all_slides_or_rolls_at_once()
    {
        var simulator = new Simulator(Scene.Published with { Ground = Ground.Turf with { NormalRestitution = 0 } });
        BallState slides = simulator.Launch(new Vector3d(0, 2, 0), new Vector3d(4, 0, 0), Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref slides, 0.01, 60, StopAt.Rest, log);
        Assert.Equal("Impact Slide Roll Rest", Flight.Kinds(log));

        log.Clear();
        BallState sticks = simulator.Launch(new Vector3d(0, 2, 0), Vector3d.Zero, Vector3d.Zero);
        simulator.Run(ref sticks, 0.01, 60, StopAt.Rest, log);
        Assert.Equal("Impact Roll Rest", Flight.Kinds(log));
        Assert.Equal(log.Events[0].Time, log.Events[2].Time);
    }

    [Fact]
    public void A_ball_without_slip_after_its_last_impact_rolls_and_emits_no_slide()
    {
        var simulator = new Simulator(Scene.Published);
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(3, -0.3, 0), new Vector3d(0, 0, -3 / 0.11));
        var log = new StepLog();
        simulator.Step(ref state, 0.01, log);
        Assert.Equal("Impact Roll", Flight.Kinds(log));
        Assert.Equal(MotionState.Rolling, state.Motion);
    }

    [Fact]
    public void A_ball_lighter_than_the_air_leaves_the_ground()
    {
        var simulator = new Simulator(Scene.Published with { Ball = new BallProperties { Mass = 0.03, Radius = 0.2 } });
        foreach (Vector3d velocity in new[] { Vector3d.Zero, new Vector3d(2, 0, 0), new Vector3d(0, -3, 0) })
        {
            BallState state = simulator.Launch(new Vector3d(0, 0.2, 0), velocity, Vector3d.Zero);
            Assert.Equal(MotionState.Airborne, state.Motion);
            var log = new StepLog();
            simulator.Run(ref state, 0.01, 5, StopAt.Time, log);
            Assert.Equal(MotionState.Airborne, state.Motion);
            Assert.True(state.Position.Y > 1, $"{state.Position}");
            Assert.Equal(velocity.Y < 0 ? "Impact" : string.Empty, Flight.Kinds(log));
        }
    }

    /// <summary>Lighter than the air, and yet pressed to the ground by a downdraught.</summary>
    [Fact]
    public void A_balloon_in_a_downdraught_does_not_sink_into_the_ground()
    {
        var scene = Scene.Published with { Ball = new BallProperties { Mass = 0.03, Radius = 0.2 }, Air = new Air { Wind = new Vector3d(2, -5, 0) } };
        foreach (Integrator integrator in Flight.Integrators)
        {
            var simulator = new Simulator(scene, Flight.With(integrator));
            BallState state = simulator.Launch(new Vector3d(0, 1, 0), Vector3d.Zero, Vector3d.Zero);
            var limit = new PieceLimit(100_000);
            var log = new StepLog { Observer = limit };
            for (int i = 0; i < 300; i++)
            {
                simulator.Step(ref state, 0.016, log);
                Assert.False(limit.Reached, $"{integrator}, step {i} does not end");
                Assert.True(state.Position.Y >= 0.2 - 1e-9, $"{integrator}, step {i}: {state.Position}");
            }
        }
    }
}
