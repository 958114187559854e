using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Accuracy;

/// <summary>Flights whose equations have a solution in closed form.</summary>
public sealed class FlightClosedFormTests
{
    private static readonly Vector3d s_high = new(0, 1000, 0);
    private static readonly BallProperties s_ball = BallProperties.Tunnel;
    private static readonly double s_area = Math.PI * s_ball.Radius * s_ball.Radius;

    [Fact]
    public void Drag_alone_slows_the_ball_by_its_hyperbola()
    {
        Scene scene = Air(ForceSet.None with { Drag = ForceLaw.Constant, DragCoefficient = 0.3 }, gravity: 0);
        double k = 0.5 * 1.2 * 0.3 * s_area / s_ball.Mass;
        BallState end = Fly(scene, 0.01, 2, new Vector3d(30, 0, 0), Vector3d.Zero);
        Assert.Equal(30 / (1 + (k * 30 * 2)), end.Velocity.X, 1e-9);
        Assert.Equal(Math.Log(1 + (k * 30 * 2)) / k, end.Position.X, 1e-8);
        Assert.Equal(1000, end.Position.Y);
    }

    [Fact]
    public void A_falling_ball_reaches_its_terminal_velocity_along_a_hyperbolic_tangent()
    {
        Scene scene = Air(ForceSet.None with { Drag = ForceLaw.Constant, DragCoefficient = 0.5 }, gravity: 9.81);
        double terminal = Math.Sqrt(2 * s_ball.Mass * 9.81 / (1.2 * 0.5 * s_area));
        BallState early = Fly(scene, 0.01, 2, Vector3d.Zero, Vector3d.Zero);
        Assert.Equal(-terminal * Math.Tanh(9.81 * 2 / terminal), early.Velocity.Y, 1e-8);
        BallState late = Fly(scene, 0.01, 30, Vector3d.Zero, Vector3d.Zero);
        Assert.Equal(-terminal, late.Velocity.Y, 1e-6);
    }

    [Theory]
    [InlineData(0.25)]
    [InlineData(-0.4)]
    public void Constant_lift_alone_bends_the_path_into_a_circle(double coefficient)
    {
        Scene scene = Air(ForceSet.None with { Magnus = ForceLaw.Constant, MagnusCoefficient = coefficient }, gravity: 0);
        double turn = coefficient * Math.PI * 1.2 * Math.Pow(s_ball.Radius, 3) * 50 / s_ball.Mass; // rad/s about +y
        BallState end = Fly(scene, 0.01, 3, new Vector3d(0, 0, -20), new Vector3d(0, 50, 0));
        Assert.Equal(-20 * Math.Sin(turn * 3), end.Velocity.X, 1e-7);
        Assert.Equal(-20 * Math.Cos(turn * 3), end.Velocity.Z, 1e-7);
        Assert.Equal(-20 / turn * (1 - Math.Cos(turn * 3)), end.Position.X, 1e-7);
        Assert.Equal(-20 / turn * Math.Sin(turn * 3), end.Position.Z, 1e-7);
    }

    [Fact]
    public void Buoyancy_lightens_the_fall()
    {
        Scene scene = Air(ForceSet.None with { Buoyancy = true }, gravity: 9.81);
        double up = 4.0 / 3 * Math.PI * Math.Pow(s_ball.Radius, 3) * 1.2 * 9.81 / s_ball.Mass;
        BallState end = Fly(scene, 0.01, 2, new Vector3d(1, 2, 3), Vector3d.Zero);
        Assert.Equal(1000 + (2 * 2) - (0.5 * (9.81 - up) * 4), end.Position.Y, 1e-9);
        Assert.InRange(up / 9.81, 0.015, 0.016);
    }

    [Fact]
    public void Constant_spin_decay_is_exponential()
    {
        Scene scene = Air(ForceSet.None with { SpinDecay = ForceLaw.Constant, SpinDecayCoefficient = 1e-3 }, gravity: 9.81);
        double rate = 1e-3 / (2.0 / 3 * 0.43 * 0.11 * 0.11);
        var spin = new Vector3d(30, -40, 20);
        BallState end = Fly(scene, 0.01, 1.5, new Vector3d(10, 0, 0), spin);
        Assert.Equal(0, Vector3d.Distance(end.Spin, Math.Exp(-rate * 1.5) * spin), 1e-7);
    }

    /// <summary>The angle turned is the time integral of the spin; the axis is exact at any step.</summary>
    [Theory]
    [InlineData(0.01, 1e-9)]
    [InlineData(0.04, 1e-8)]
    [InlineData(0.5, 1e-3)]
    public void Orientation_turns_by_the_integral_of_the_spin_about_its_own_axis(double timeStep, double tolerance)
    {
        Scene scene = Air(ForceSet.None with { SpinDecay = ForceLaw.Constant, SpinDecayCoefficient = 1e-3 }, gravity: 9.81);
        double rate = 1e-3 / (2.0 / 3 * 0.43 * 0.11 * 0.11);
        var axis = new Vector3d(2.0 / 3, -2.0 / 3, 1.0 / 3);
        double angle = 60 * (1 - Math.Exp(-rate * 1.5)) / rate;
        BallState end = Fly(scene, timeStep, 1.5, new Vector3d(10, 0, 0), 60 * axis);
        double half = 0.5 * angle;
        var expected = new Quaterniond(Math.Sin(half) * axis.X, Math.Sin(half) * axis.Y, Math.Sin(half) * axis.Z, Math.Cos(half));
        Assert.InRange(Differences.Rotation(end.Orientation, expected), 0, tolerance);
        Assert.InRange(Vector3d.Cross(end.Spin / end.Spin.Length, axis).Length, 0, 1e-15);
        Assert.Equal(0, Vector3d.Distance(end.Orientation.Rotate(axis), axis), 1e-13);
    }

    [Fact]
    public void Orientation_of_a_fast_spin_is_exact_where_spin_does_not_decay()
    {
        Scene scene = Air(ForceSet.None, gravity: 9.81);
        foreach (Integrator integrator in Flight.Integrators)
        {
            var simulator = new Simulator(scene, Flight.With(integrator));
            BallState state = simulator.Launch(s_high, new Vector3d(10, 0, 0), new Vector3d(0, 0, 60), new Quaterniond(0, 1, 0, 0));
            simulator.Run(ref state, 0.04, 2, StopAt.Time, new StepLog());
            Quaterniond expected = new Quaterniond(0, 0, Math.Sin(60), Math.Cos(60)) * new Quaterniond(0, 1, 0, 0);
            Assert.InRange(Differences.Rotation(state.Orientation, expected), 0, 1e-12);
        }
    }

    [Fact]
    public void Wind_carries_the_ball_until_it_moves_with_the_air()
    {
        Scene scene = Air(ForceSet.None with { Drag = ForceLaw.Constant, DragCoefficient = 5 }, gravity: 0) with
        {
            Air = new Air { Wind = new Vector3d(7, 2, -3) },
        };
        double k = 0.5 * 1.2 * 5 * s_area / s_ball.Mass;
        double speed = Math.Sqrt(49 + 4 + 9);
        BallState end = Fly(scene, 0.01, 60, Vector3d.Zero, Vector3d.Zero);
        double remaining = 1 / (1 + (k * speed * 60));
        Assert.Equal(0, Vector3d.Distance(end.Velocity, (1 - remaining) * scene.Air.Wind), 1e-7);
        Assert.True(remaining < 0.01);
    }

    /// <summary>Wind is the change to a frame that moves with the air: every law of flight.</summary>
    [Theory]
    [InlineData(AerodynamicModel.Published)]
    [InlineData(AerodynamicModel.Regularized)]
    public void A_flight_in_wind_is_the_flight_in_still_air_seen_from_a_moving_frame(AerodynamicModel form)
    {
        var wind = new Vector3d(4, -1, 6);
        var scene = Scene.Published with { Forces = ForceSet.Published with { Coefficients = form } };
        BallState still = Fly(scene, 0.01, 2, new Vector3d(18, 6, -9), new Vector3d(10, 30, -20));
        BallState windy = Fly(scene with { Air = new Air { Wind = wind } }, 0.01, 2, new Vector3d(22, 5, -3), new Vector3d(10, 30, -20));
        Assert.Equal(0, Vector3d.Distance(still.Velocity + wind, windy.Velocity), 1e-10);
        Assert.Equal(0, Vector3d.Distance(still.Position + (2 * wind), windy.Position), 1e-10);
        Assert.Equal(0, Vector3d.Distance(still.Spin, windy.Spin), 1e-10);
    }

    [Fact]
    public void The_check_value_of_the_design_notes_holds()
    {
        var scene = Scene.Published with { Air = new Air { Density = 1.2041, KinematicViscosity = 1.51e-5 } };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(s_high, new Vector3d(24, 7, 1), new Vector3d(1, 20, 15));
        var log = new StepLog();
        for (int i = 0; i < 120; i++)
        {
            simulator.Step(ref state, 0.01, log);
        }

        Assert.Equal(0, Vector3d.Distance(state.Position - s_high, new Vector3d(24.488465, 2.551997, -1.129625)), 2e-6);
        Assert.Equal(0, Vector3d.Distance(state.Velocity, new Vector3d(17.501009, -2.466996, -2.449186)), 2e-6);
        Assert.Equal(0, Vector3d.Distance(state.Spin, new Vector3d(0.98208, 19.64160, 14.73120)), 1e-5);
        Assert.Equal(0, log.Events.Count);
    }

    private static Scene Air(ForceSet forces, double gravity) => Scene.Published with { Gravity = gravity, Forces = forces };

    private static BallState Fly(Scene scene, double timeStep, double duration, Vector3d velocity, Vector3d spin) =>
        Flight.Play(scene, SolverSettings.Default, timeStep, duration, StopAt.Time, s_high, velocity, spin, out _);
}
