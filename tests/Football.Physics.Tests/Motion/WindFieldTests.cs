using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>A ball in wind by place and time, and the knuckle force.</summary>
public sealed class WindFieldTests
{
    private static readonly Vector3d s_start = new(0, 0.11, 0);
    private static readonly Vector3d s_velocity = new(20, 7, -4);
    private static readonly Vector3d s_spin = new(3, 40, -25);
    private static readonly Vector3d s_wind = new(-5, 0.5, 3);

    /// <summary>Drag, lift and spin decay all see it, in flight and on the ground, by every law; half of it may be steady.</summary>
    [Theory]
    [ProfileData]
    public void A_field_that_is_the_same_everywhere_is_a_steady_wind(Profile profile)
    {
        foreach (AerodynamicModel form in new[] { AerodynamicModel.Regularized, AerodynamicModel.Measured })
        {
            foreach (double steady in new[] { 0, 0.5 })
            {
                var forces = profile.Forces() with { Coefficients = form };
                Scene field = profile.Scene() with { Forces = forces, Air = new Air { Wind = steady * s_wind, WindField = new UniformWind((1 - steady) * s_wind) } };
                Scene wind = profile.Scene() with { Forces = forces, Air = new Air { Wind = s_wind } };
                foreach (Integrator integrator in Flight.Integrators)
                {
                    Same(field, wind, integrator, 1e-9);
                }
            }
        }
    }

    /// <summary>The jump of the drag law is not located there, so it costs accuracy.</summary>
    [Fact]
    public void So_it_is_for_the_published_law_to_what_its_jump_costs()
    {
        var scene = Scene.Published with { Air = new Air { WindField = new UniformWind(s_wind) } };
        Same(scene, Scene.Published with { Air = new Air { Wind = s_wind } }, Integrator.Rk4, 0.05);
    }

    [Fact]
    public void Air_that_stands_still_everywhere_changes_nothing()
    {
        Scene field = Scene.Measured with { Air = new Air { WindField = new UniformWind(Vector3d.Zero) } };
        Same(field, Scene.Measured, Integrator.Rk4, 1e-10);
    }

    /// <summary>A ball as light as air in a storm ends in the wind's own velocity, whatever the step.</summary>
    [Fact]
    public void A_ball_with_hardly_a_mass_goes_with_the_wind()
    {
        foreach (Integrator integrator in Flight.Integrators)
        {
            foreach (double mass in new[] { 1e-3, 1e-2 })
            {
                Scene scene = Scene.Measured with
                {
                    Gravity = 0,
                    Ball = new BallProperties { Mass = mass },
                    Air = new Air { WindField = new UniformWind(new Vector3d(30, 10, 0)) },
                };
                BallState state = Flight.Play(scene, Flight.With(integrator), 0.1, 5, StopAt.Time, new Vector3d(0, 10, 0), new Vector3d(-20, 0, 5), Vector3d.Zero, out _);
                Assert.InRange(Vector3d.Distance(state.Velocity, new Vector3d(30, 10, 0)), 0, 0.2);
            }
        }
    }

    [Fact]
    public void The_axis_of_a_spin_in_a_field_is_constant_and_the_ball_turns_about_it()
    {
        Scene scene = Scene.Measured with { Air = new Air { WindField = new WindByHeight(8, 1, 2, gusts: new Gusts()) } };
        BallState state = Flight.Play(scene, SolverSettings.Default, 0.01, 0.5, StopAt.Time, new Vector3d(0, 5, 0), s_velocity, s_spin, out _);
        Assert.InRange(Vector3d.Cross(state.Spin, s_spin).Length, 0, 1e-9 * s_spin.LengthSquared);
        Assert.InRange(state.Spin.Length, 0.9 * s_spin.Length, 0.99 * s_spin.Length);
        Vector3d axis = s_spin / s_spin.Length;
        Assert.InRange(Vector3d.Distance(state.Orientation.Rotate(axis), axis), 0, 1e-12);
        Assert.Equal(1, state.Orientation.LengthSquared, 1e-12);
    }

    /// <summary>Whoever looks ahead sees the bits that the game will have.</summary>
    [Fact]
    public void A_ball_that_is_watched_flies_to_the_bit_as_one_that_is_not()
    {
        Scene scene = Scene.Measured with
        {
            Air = new Air { WindField = new WindByHeight(8, 1, 2, gusts: new Gusts { Seed = 4 }) },
            Forces = ForceSet.Measured with { KnuckleSeed = 8 },
        };
        foreach (Integrator integrator in Flight.Integrators)
        {
            var simulator = new Simulator(scene, Flight.With(integrator));
            BallState alone = simulator.Launch(s_start, s_velocity, new Vector3d(0, 3, 2));
            BallState watched = alone;
            simulator.Run(ref alone, 0.01, 6, StopAt.Time, new StepLog());
            simulator.Run(ref watched, 0.01, 6, StopAt.Time, new StepLog { Observer = new ApexObserver(s_start.Y) });
            Assert.True(Snapshot.Same(alone, watched), integrator.ToString());
        }
    }

    /// <summary>A light ball takes on the speed of the air in a fraction of a step, although it starts at rest.</summary>
    [Theory]
    [ProfileData]
    public void A_light_ball_in_a_storm_takes_its_steps_in_parts(Profile profile)
    {
        Scene scene = profile.Scene() with { Air = new Air { WindField = new UniformWind(new Vector3d(40, 0, 0)) }, Ball = new BallProperties { Mass = 0.06, Radius = 0.2 } };
        var start = new Vector3d(0, 20, 0);
        BallState fine = Flight.Play(scene, Flight.With(Integrator.Rk4), 0.001, 1, StopAt.Time, start, Vector3d.Zero, Vector3d.Zero, out _);
        BallState coarse = Flight.Play(scene, Flight.With(Integrator.Rk4), 0.25, 1, StopAt.Time, start, Vector3d.Zero, Vector3d.Zero, out StepLog log);
        Assert.True(log.Steps > 4, $"{log.Steps} steps");
        Assert.True(Vector3d.Distance(coarse.Position, fine.Position) < 5e-3, $"{coarse.Position} and {fine.Position}");
    }

    [Fact]
    public void A_field_and_a_force_of_the_game_act_together()
    {
        Scene field = Scene.Measured with { Air = new Air { WindField = new UniformWind(s_wind) } };
        Scene wind = Scene.Measured with { Air = new Air { Wind = s_wind } };
        var force = IForce.From(ball => 0.01 * ball.AirVelocity);
        var forces = ForceSet.Measured with { CustomForces = [force] };
        Same(field with { Forces = forces }, wind with { Forces = forces }, Integrator.Rk4, 1e-9);
    }

    [Fact]
    public void A_kick_begins_the_knuckle_force_anew_and_an_impact_does_not()
    {
        Scene scene = Scene.Measured with { Forces = ForceSet.Measured with { KnuckleSeed = 1 } };
        var simulator = new Simulator(scene);
        var log = new StepLog();
        BallState state = simulator.Launch(s_start, new Vector3d(10, 3, 0), Vector3d.Zero);
        simulator.Run(ref state, 0.01, 5, StopAt.Impact, log);
        double flown = state.AirDistance;
        Assert.InRange(flown, Vector3d.Distance(state.Position, s_start), 1.3 * state.Position.X);
        simulator.Run(ref state, 0.01, 0.1, StopAt.Time, log);
        Assert.True(state.AirDistance > flown + 0.2);
        simulator.Kick(ref state, new Vector3d(5, 5, 5), Vector3d.Zero);
        Assert.Equal(0, state.AirDistance);
    }

    [Fact]
    public void Without_a_knuckle_force_nothing_is_counted()
    {
        Scene scene = Scene.Measured with { Air = new Air { WindField = new UniformWind(s_wind) } };
        Assert.Equal(0, Flight.Play(scene, SolverSettings.Default, 0.01, 1, StopAt.Time, s_start, s_velocity, s_spin, out _).AirDistance);
    }

    private static void Same(Scene one, Scene other, Integrator integrator, double tolerance)
    {
        BallState a = Flight.Play(one, Flight.With(integrator), 0.01, 3, StopAt.Time, s_start, s_velocity, s_spin, out StepLog logA);
        BallState b = Flight.Play(other, Flight.With(integrator), 0.01, 3, StopAt.Time, s_start, s_velocity, s_spin, out StepLog logB);
        string what = $"{integrator}, {one.Forces.Coefficients}";
        Assert.Equal((what, Flight.Kinds(logB)), (what, Flight.Kinds(logA)));
        Assert.True(Vector3d.Distance(a.Position, b.Position) < tolerance, $"{what}: {a.Position} and {b.Position}");
        Assert.True(Vector3d.Distance(a.Spin, b.Spin) < 100 * tolerance, $"{what}: {a.Spin} and {b.Spin}");
        Assert.True(Math.Abs(Math.Abs(Quaternion(a.Orientation, b.Orientation)) - 1) < 100 * tolerance, what);
    }

    private static double Quaternion(Quaterniond a, Quaterniond b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W);
}
