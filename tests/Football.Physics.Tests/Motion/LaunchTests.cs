using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>How a launch at or near the ground starts.</summary>
public sealed class LaunchTests
{
    private const double Threshold = 0.2;

    private static readonly Dictionary<Profile, Simulator> s_simulators = Profiles.All.ToDictionary(profile => profile, profile => new Simulator(profile.Scene() with
    {
        Ground = profile.Ground() with
        {
            Material = profile.Ground().Material with
            {
                GrazingRestitutionGain = 0,
                NormalRestitution = 0.6,
                RestitutionSpeedScale = double.PositiveInfinity,
            },
            Height = 1.5,
            MinimumBounceSpeed = Threshold,
        },
    }));

    [Theory]
    [ProfileData]
    public void A_launch_below_contact_height_is_raised_to_it(Profile profile)
    {
        foreach (double y in new[] { -100, 0, 1.5, 1.6, 1.61 - 1e-12, 1.61 })
        {
            Vector3d place = s_simulators[profile].Launch(new Vector3d(3, y, 4), new Vector3d(1, 5, 0), Vector3d.Zero).Position;
            Assert.InRange(Vector3d.Distance(new Vector3d(3, 1.61, 4), place), 0, 1e-11);
        }

        Assert.Equal(1.61, s_simulators[profile].ContactHeight);
        Assert.Equal(1.6100001, s_simulators[profile].Launch(new Vector3d(0, 1.6100001, 0), Vector3d.Zero, Vector3d.Zero).Position.Y);
    }

    [Theory]
    [ProfileData(0.2, "")]
    [ProfileData(5.0, "")]
    [ProfileData(-0.2, "Impact Slide")]
    [ProfileData(-0.5, "Impact")]
    [ProfileData(-9.0, "Impact")]
    [ProfileData(0.1999, "")]
    [ProfileData(0.0, "")]
    [ProfileData(-0.1999, "")]
    public void At_contact_the_vertical_speed_decides_between_flight_impact_and_ground(Profile profile, double vertical, string events)
    {
        BallState state = s_simulators[profile].Launch(new Vector3d(0, 1.61, 0), new Vector3d(3, vertical, 0), Vector3d.Zero);
        bool ground = Math.Abs(vertical) < Threshold;
        Assert.Equal(ground ? MotionState.Sliding : MotionState.Airborne, state.Motion);
        Assert.Equal(ground ? 0 : vertical, state.Velocity.Y);

        var log = new StepLog();
        s_simulators[profile].Step(ref state, 1e-9, log);
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

    [Theory]
    [ProfileData]
    public void A_launch_on_the_ground_without_slip_rolls_without_an_event(Profile profile)
    {
        BallState state = s_simulators[profile].Launch(new Vector3d(0, 1.61, 0), new Vector3d(3, 0.1, 0), new Vector3d(0, 5, -3 / 0.11));
        Assert.Equal(MotionState.Rolling, state.Motion);
        var log = new StepLog();
        s_simulators[profile].Step(ref state, 0.1, log);
        Assert.Equal(0, log.Events.Count);
    }

    [Theory]
    [ProfileData]
    public void The_orientation_of_a_launch_is_normalised(Profile profile)
    {
        BallState state = s_simulators[profile].Launch(new Vector3d(0, 5, 0), Vector3d.Zero, Vector3d.Zero, new Quaterniond(0, 3, 0, 4));
        Assert.Equal(new Quaterniond(0, 0.6000000000000001, 0, 0.8), state.Orientation);
    }

    [Theory]
    [ProfileData(0.4, MotionState.Airborne, "Impact")]
    [ProfileData(0.3999, MotionState.Sliding, "Impact Slide")]
    public void After_an_impact_a_ball_slower_than_the_minimum_bounce_speed_stays_down(Profile profile, double speed, MotionState motion, string events)
    {
        var simulator = new Simulator(profile.Scene() with
        {
            Ground = profile.Ground() with
            {
                Material = profile.Ground().Material with
                {
                    GrazingRestitutionGain = 0,
                    NormalRestitution = 0.5,
                    RestitutionSpeedScale = double.PositiveInfinity,
                },
                MinimumBounceSpeed = 0.2,
            }
        });
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

    [Theory]
    [ProfileData]
    public void A_ball_that_does_not_bounce_at_all_slides_or_rolls_at_once(Profile profile)
    {
        var simulator = new Simulator(profile.Scene() with { Ground = profile.Ground() with { Material = profile.Ground().Material with { GrazingRestitutionGain = 0, NormalRestitution = 0 } } });
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

    [Theory]
    [ProfileData]
    public void A_ball_without_slip_after_its_last_impact_rolls_and_emits_no_slide(Profile profile)
    {
        var simulator = new Simulator(profile.Scene());
        BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(3, -0.2, 0), new Vector3d(0, 0, -3 / 0.11));
        var log = new StepLog();
        simulator.Step(ref state, 0.01, log);
        Assert.Equal("Impact Roll", Flight.Kinds(log));
        Assert.Equal(MotionState.Rolling, state.Motion);
    }

    [Theory]
    [ProfileData]
    public void A_ball_lighter_than_the_air_leaves_the_ground(Profile profile)
    {
        var simulator = new Simulator(profile.Scene() with { Ball = new BallProperties { Mass = 0.03, Radius = 0.2 } });
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
    [Theory]
    [ProfileData]
    public void A_balloon_in_a_downdraught_does_not_sink_into_the_ground(Profile profile)
    {
        var scene = profile.Scene() with { Ball = new BallProperties { Mass = 0.03, Radius = 0.2 }, Air = new Air { Wind = new Vector3d(2, -5, 0) } };
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
