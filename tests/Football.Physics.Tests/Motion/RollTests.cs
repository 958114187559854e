using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>Rolling and coming to rest, in closed form.</summary>
public sealed class RollTests
{
    private static readonly Vector3d s_start = new(0, Flight.Radius, 0);
    private static readonly BallProperties s_ball = BallProperties.Tunnel;

    [Theory]
    [MemberData(nameof(Integrators))]
    public void A_roll_without_air_is_as_long_as_friction_and_rest_energy_make_it(Integrator integrator)
    {
        const double Speed = 3;
        double friction = 0.05 * 9.81;
        double restSpeed = Math.Sqrt(2 * 1e-4 / (0.43 * (1 + (2.0 / 3))));
        BallEvent rest = ToRest(Scene.Vacuum, integrator, new Vector3d(0, 0, Speed), new Vector3d(Speed / Flight.Radius, 0, 0));
        Assert.Equal((Speed - restSpeed) / friction, rest.Time, 1e-9);
        Assert.Equal(restSpeed, rest.Velocity.Z, 1e-9);

        // First order methods lose or gain half a step of speed change over the way.
        double tolerance = integrator < Integrator.Rk2 ? 0.01 * Speed : 1e-9;
        Assert.Equal(((Speed * Speed) - (restSpeed * restSpeed)) / (2 * friction), rest.Position.Z, tolerance);
    }

    [Theory]
    [ProfileData]
    public void A_rolling_ball_spins_as_it_moves(Profile profile)
    {
        BallState state = Flight.Play(
            profile.Scene(), SolverSettings.Default, 0.01, 1, StopAt.Time, s_start, new Vector3d(3, 0, 4), new Vector3d(4 / Flight.Radius, 7, -3 / Flight.Radius), out _);
        Assert.Equal(MotionState.Rolling, state.Motion);
        Assert.Equal(0, Slip.Of(state.Velocity, state.Spin, Vector3d.Up, Flight.Radius).Length, 1e-14);
        Assert.Equal(0.75, state.Velocity.X / state.Velocity.Z, 0.05);
    }

    /// <summary>Without air and friction a ball turns once every 2π r of way.</summary>
    [Theory]
    [ProfileData]
    public void A_rolling_ball_turns_once_in_its_circumference(Profile profile)
    {
        Scene scene = Scene.Vacuum with { Ground = profile.Ground() with { Material = profile.Ground().Material with { RollingResistance = 0, RollingResistancePerSpeed = 0 } } };
        double time = 10 * 2 * Math.PI * Flight.Radius / 2.5;
        BallState state = Flight.Play(
            scene, SolverSettings.Default, 0.01, time, StopAt.Time, s_start, new Vector3d(2.5, 0, 0), new Vector3d(0, 0, -2.5 / Flight.Radius), out _);
        Assert.InRange(Differences.Rotation(state.Orientation, Quaterniond.Identity), 0, 1e-11);
    }

    [Fact]
    public void A_ball_that_only_spins_about_the_vertical_stays_where_it_is_and_dies_down()
    {
        double rate = 0.002 / s_ball.MomentOfInertia;
        double restSpin = Math.Sqrt(2 * 1e-4 / s_ball.MomentOfInertia);
        foreach (Integrator integrator in new[] { Integrator.Rk2, Integrator.Rk4 })
        {
            BallEvent rest = ToRest(Scene.Vacuum, integrator, Vector3d.Zero, new Vector3d(0, 30, 0));
            Assert.Equal(s_start, rest.Position);
            Assert.Equal(Math.Log(30 / restSpin) / rate, rest.Time, integrator == Integrator.Rk4 ? 1e-9 : 1e-4);
            Assert.Equal(restSpin, rest.Spin.Y, 1e-9);
        }
    }

    [Fact]
    public void A_light_touch_of_wind_rolls_a_ball_on_but_not_a_ball_at_rest()
    {
        Scene scene = Scene.Published with { Air = new Air { Wind = new Vector3d(40, 0, 0) } };
        BallState rolling = Flight.Play(
            scene, SolverSettings.Default, 0.01, 20, StopAt.Time, s_start, new Vector3d(1, 0, 0), new Vector3d(0, 0, -1 / Flight.Radius), out _);
        Assert.Equal(MotionState.Rolling, rolling.Motion);
        Assert.True(rolling.Velocity.X > 5);
        BallState still = Flight.Play(scene, SolverSettings.Default, 0.01, 20, StopAt.Time, s_start, Vector3d.Zero, Vector3d.Zero, out StepLog log);
        Assert.Equal(s_start, still.Position);
        Assert.Equal("Rest", Flight.Kinds(log));
    }

    /// <summary>Wind from behind drives a rolling ball to the speed at which drag and friction balance.</summary>
    [Fact]
    public void A_driven_roll_ends_at_the_balance_of_drag_and_friction()
    {
        var scene = Scene.Published with
        {
            Air = new Air { Wind = new Vector3d(20, 0, 0) },
            Forces = ForceSet.None with { Drag = ForceLaw.Constant, DragCoefficient = 0.5 },
        };
        double k = 0.5 * 1.2 * 0.5 * Math.PI * Flight.Radius * Flight.Radius / 0.43;
        double balance = 20 - Math.Sqrt(0.05 * 9.81 / k);
        BallState end = Flight.Play(
            scene, SolverSettings.Default, 0.02, 120, StopAt.Time, s_start, new Vector3d(2, 0, 0), new Vector3d(0, 0, -2 / Flight.Radius), out _);
        Assert.Equal(balance, end.Velocity.X, 1e-6);
        Assert.Equal(0, end.Velocity.Z);
    }

    [Fact]
    public void Without_aerodynamics_on_the_ground_the_air_only_brakes_the_spin()
    {
        Scene bare = Scene.Published with { Ground = Ground.PublishedTurf with { Aerodynamics = GroundAerodynamics.None }, Forces = ForceSet.Published with { Buoyancy = false } };
        Scene vacuum = Scene.Vacuum;
        var velocity = new Vector3d(16, 0, 0);
        var spin = new Vector3d(0, 60, -16 / Flight.Radius);
        BallState none = Flight.Play(bare, SolverSettings.Default, 0.01, 2, StopAt.Time, s_start, velocity, spin, out _);
        BallState without = Flight.Play(vacuum, SolverSettings.Default, 0.01, 2, StopAt.Time, s_start, velocity, spin, out _);
        BallState horizontal = Flight.Play(
            bare with { Ground = Ground.PublishedTurf }, SolverSettings.Default, 0.01, 2, StopAt.Time, s_start, velocity, spin, out _);
        Assert.Equal(0, Vector3d.Distance(none.Position, without.Position), 1e-12);
        Assert.True(none.Spin.Y < without.Spin.Y);
        Assert.True(horizontal.Position.X < none.Position.X - 1);
        Assert.True(horizontal.Position.Z < -0.01, $"counter-clockwise spin bends a roll to the left: {horizontal.Position}");
        Assert.Equal(Flight.Radius, horizontal.Position.Y);
    }

    /// <summary>The Magnus force does no work, and drag does not bend a roll: neither does what the other would.</summary>
    [Theory]
    [InlineData(AerodynamicModel.Published)]
    [InlineData(AerodynamicModel.Regularized)]
    public void A_law_that_is_left_out_does_not_act_on_the_ground(AerodynamicModel form)
    {
        Scene scene = Scene.Published with { Ground = Ground.PublishedTurf with { Material = SurfaceMaterial.PublishedTurf with { RollingResistance = 0 } } };
        var spin = new Vector3d(0, 50, -20 / Flight.Radius);
        BallState Roll(ForceSet forces) => Flight.Play(
            scene with { Forces = forces with { Coefficients = form } }, SolverSettings.Default, 0.01, 1, StopAt.Time, s_start, new Vector3d(20, 0, 0), spin, out _);
        BallState lifted = Roll(ForceSet.Published with { Drag = ForceLaw.None });
        Assert.Equal(20, lifted.Velocity.Length, 1e-6);
        Assert.True(lifted.Velocity.Z < -1);
        BallState braked = Roll(ForceSet.Published with { Magnus = ForceLaw.None });
        Assert.Equal(0, braked.Velocity.Z);
        Assert.True(braked.Velocity.X < 15);
    }

    [Theory]
    [ProfileData]
    public void Friction_never_turns_a_roll_back_whatever_the_step(Profile profile)
    {
        var scene = profile.Scene() with { Ground = profile.Ground() with { Material = profile.Ground().Material with { RollingResistance = 3, SpinDamping = 1 }, RestEnergy = 1e-12 } };
        foreach (Integrator integrator in Flight.Integrators)
        {
            foreach (double timeStep in new[] { 0.002, 0.05, 0.7, 5 })
            {
                var simulator = new Simulator(scene, Flight.With(integrator));
                BallState state = simulator.Launch(s_start, new Vector3d(-2, 0, 1), new Vector3d(1 / Flight.Radius, -30, 2 / Flight.Radius));
                double spin = state.Spin.Y;
                var log = new StepLog();
                for (int i = 0; i < 2000 && state.Motion != MotionState.Rest; i++)
                {
                    simulator.Step(ref state, timeStep, log);
                    Assert.True(state.Velocity.X <= 1e-12 && state.Velocity.Z >= -1e-12, $"{integrator} {timeStep} s: {state.Velocity}");
                    Assert.True(state.Spin.Y <= 0 && state.Spin.Y >= spin, $"{integrator} {timeStep} s: {state.Spin}");
                    spin = state.Spin.Y;
                }

                Assert.Equal(MotionState.Rest, state.Motion);
                Assert.Equal("Rest", Flight.Kinds(log));
            }
        }
    }

    public static TheoryData<Integrator> Integrators() => Flight.EveryIntegrator();

    private static BallEvent ToRest(Scene scene, Integrator integrator, Vector3d velocity, Vector3d spin)
    {
        BallState state = Flight.Play(scene, Flight.With(integrator), 0.01, 60, StopAt.Rest, s_start, velocity, spin, out StepLog log);
        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.Equal("Rest", Flight.Kinds(log));
        return log.Events[0];
    }
}
