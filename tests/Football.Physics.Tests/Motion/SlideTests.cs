using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>Slides in closed form: without air the friction's direction never turns.</summary>
public sealed class SlideTests
{
    private static readonly Vector3d s_start = new(0, Flight.Radius, 0);

    [Theory]
    [InlineData(2.0 / 3, 0.6)]
    [InlineData(2.0 / 5, 5.0 / 7)]
    [InlineData(1.0, 0.5)]
    public void A_slide_without_spin_ends_at_the_speed_that_inertia_alone_sets(double inertiaFactor, double share)
    {
        Scene scene = Scene.Vacuum with { Ball = BallProperties.Tunnel with { InertiaFactor = inertiaFactor } };
        foreach (Integrator integrator in Flight.Integrators)
        {
            BallEvent roll = Slide(scene, integrator, 0.01, new Vector3d(8, 0, 0), Vector3d.Zero);
            Assert.Equal(8 * share, roll.Velocity.X, 1e-8);
            Assert.Equal(-8 * share / Flight.Radius, roll.Spin.Z, 1e-7);
            Assert.Equal(8 / ((1 + (1 / inertiaFactor)) * 0.5 * 9.81), roll.Time, 1e-8);
        }
    }

    [Fact]
    public void An_oblique_slide_runs_along_a_parabola_until_the_slip_is_gone()
    {
        var velocity = new Vector3d(6, 0, -3);
        var spin = new Vector3d(25, 12, 40);
        Vector3d slip = velocity + (Flight.Radius * Vector3d.Cross(Vector3d.Up, spin));
        double friction = 0.5 * 9.81;
        double time = slip.Length / ((1 + 1.5) * friction);
        Vector3d expected = velocity - (friction * time * (slip / slip.Length));
        foreach (double timeStep in new[] { 0.01, 0.1, 2 })
        {
            BallEvent roll = Slide(Scene.Vacuum, Integrator.Rk4, timeStep, velocity, spin);
            Assert.Equal(time, roll.Time, 1e-8);
            Assert.Equal(0, Vector3d.Distance(roll.Velocity, expected), 1e-8);
            Assert.Equal(0, Vector3d.Distance(roll.Position, s_start + (time / 2 * (velocity + expected))), 1e-8);
            Assert.Equal(expected.Z / Flight.Radius, roll.Spin.X, 1e-8);
            Assert.Equal(-expected.X / Flight.Radius, roll.Spin.Z, 1e-8);
        }
    }

    [Fact]
    public void The_spin_about_the_vertical_dies_exponentially_whatever_the_slide_does()
    {
        double rate = 0.002 / BallProperties.Tunnel.MomentOfInertia;
        BallEvent roll = Slide(Scene.Vacuum, Integrator.Rk4, 0.01, new Vector3d(8, 0, 0), new Vector3d(0, 40, 0));
        Assert.Equal(40 * Math.Exp(-rate * roll.Time), roll.Spin.Y, 1e-7);
        BallState later = Flight.Play(
            Scene.Vacuum, SolverSettings.Default, 0.01, 2, StopAt.Time, s_start, new Vector3d(8, 0, 0), new Vector3d(0, 40, 0), out _);
        Assert.Equal(MotionState.Rolling, later.Motion);
        Assert.Equal(40 * Math.Exp(-rate * 2), later.Spin.Y, 1e-7);
    }

    [Fact]
    public void Backspin_stops_a_slow_ball_and_brings_it_back()
    {
        // v' = (v − α r ω)/(1 + α) along the first direction
        BallEvent roll = Slide(Scene.Vacuum, Integrator.Rk4, 0.01, new Vector3d(2, 0, 0), new Vector3d(0, 0, 60));
        Assert.Equal((2 - (2.0 / 3 * Flight.Radius * 60)) / (5.0 / 3), roll.Velocity.X, 1e-8);
        Assert.True(roll.Velocity.X < 0);
    }

    [Fact]
    public void Buoyancy_takes_weight_off_the_friction()
    {
        Scene scene = Scene.Vacuum with { Forces = ForceSet.None with { Buoyancy = true } };
        double normal = 9.81 * (1 - (4.0 / 3 * Math.PI * Math.Pow(Flight.Radius, 3) * 1.2 / 0.43));
        Assert.Equal(8 / (2.5 * 0.5 * normal), Slide(scene, Integrator.Rk4, 0.01, new Vector3d(8, 0, 0), Vector3d.Zero).Time, 1e-8);
    }

    [Theory]
    [ProfileData]
    public void A_slide_without_friction_or_air_goes_on_for_ever(Profile profile)
    {
        Scene scene = Scene.Vacuum with { Ground = profile.Ground() with { Material = profile.Ground().Material with { SlidingFriction = 0 } } };
        BallState end = Flight.Play(scene, SolverSettings.Default, 0.1, 30, StopAt.Time, s_start, new Vector3d(5, 0, 1), Vector3d.Zero, out StepLog log);
        Assert.Equal(MotionState.Sliding, end.Motion);
        Assert.Equal(150, end.Position.X, 1e-9);
        Assert.Equal(0, log.Events.Count);
    }

    [Theory]
    [ProfileData]
    public void The_slip_never_turns_back_whatever_the_step(Profile profile)
    {
        var random = new Shots(219);
        foreach (Integrator integrator in Flight.Integrators)
        {
            var simulator = new Simulator(profile.Scene() with { Air = new Air { Wind = new Vector3d(3, 0, -2) } }, Flight.With(integrator));
            foreach (double timeStep in new[] { 0.003, 0.02, 0.2, 1.5 })
            {
                for (int i = 0; i < 20; i++)
                {
                    Vector3d spin = random.Uniform(0, 60) * random.Direction();
                    BallState state = simulator.Launch(s_start, random.Velocity(0.5, 15, 0, 0), spin);
                    var log = new StepLog();
                    while (state.Motion == MotionState.Sliding && state.Time < 10)
                    {
                        Vector3d before = Slip.Of(state.Velocity, state.Spin, Vector3d.Up, Flight.Radius);
                        simulator.Step(ref state, timeStep, log);
                        Vector3d after = Slip.Of(state.Velocity, state.Spin, Vector3d.Up, Flight.Radius);
                        Assert.True(Vector3d.Dot(before, after) >= -1e-14, $"{integrator} {timeStep} s: {before} to {after}");
                    }

                    Assert.Equal(BallEventKind.Roll, log.Events[0].Kind);
                }
            }
        }
    }

    /// <summary>The heuristic of the thesis ends a slide at the end of a step, late by less than that.</summary>
    [Fact]
    public void The_heuristic_ends_the_slide_in_the_step_in_which_the_slip_grew()
    {
        var settings = new SolverSettings { RollingTransition = RollingTransition.Heuristic };
        double exact = 8 / (2.5 * 0.5 * 9.81);
        foreach (double timeStep in new[] { 0.0013, 0.01, 0.037 })
        {
            Flight.Play(Scene.Vacuum, settings, timeStep, 3, StopAt.Time, s_start, new Vector3d(8, 0, 0), Vector3d.Zero, out StepLog log);
            BallEvent roll = log.Events[0];
            Assert.Equal(BallEventKind.Roll, roll.Kind);
            Assert.InRange(roll.Time - exact, -1.5 * timeStep, 2 * timeStep);
            Assert.Equal(roll.Time / timeStep, Math.Round(roll.Time / timeStep), 1e-6);
            Assert.Equal(0, Slip.Of(roll.Velocity, roll.Spin, Vector3d.Up, Flight.Radius).Length, 1e-14);
            Assert.Equal(4.8, roll.Velocity.X, 0.5 * 9.81 * 2 * timeStep);
        }
    }

    private static BallEvent Slide(Scene scene, Integrator integrator, double timeStep, Vector3d velocity, Vector3d spin)
    {
        Flight.Play(scene, Flight.With(integrator), timeStep, 5, StopAt.Time, s_start, velocity, spin, out StepLog log);
        Assert.Equal(BallEventKind.Roll, log.Events[0].Kind);
        return log.Events[0];
    }
}
