using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>A force of the game's own, against what the library's do by themselves.</summary>
public sealed class CustomForceTests
{
    private static readonly Vector3d s_high = new(0, 500, 0);

    public static TheoryData<Integrator> Integrators() => Flight.EveryIntegrator();

    [Theory]
    [ProfileData(Member = nameof(Integrators))]
    public void A_constant_force_is_more_gravity(Profile profile, Integrator integrator)
    {
        Scene heavy = profile.Scene() with { Gravity = 9.81 + 2, Forces = profile.Forces() with { Buoyancy = false } };
        Scene pulled = profile.Scene() with
        {
            Forces = profile.Forces() with { Buoyancy = false, CustomForces = [IForce.From(_ => new Vector3d(0, -2 * 0.43, 0))] },
        };
        BallEvent expected = Flight.ToImpact(heavy, integrator, 0.01, new Vector3d(0, 0.11, 0), new Vector3d(16, 9, 3), new Vector3d(3, 30, -9));
        BallEvent actual = Flight.ToImpact(pulled, integrator, 0.01, new Vector3d(0, 0.11, 0), new Vector3d(16, 9, 3), new Vector3d(3, 30, -9));
        Assert.InRange(Vector3d.Distance(expected.Position, actual.Position), 0, 1e-8);
        Assert.InRange(Vector3d.Distance(expected.VelocityBefore, actual.VelocityBefore), 0, 1e-8);
        Assert.InRange(Vector3d.Distance(expected.SpinBefore, actual.SpinBefore), 0, 1e-8);
    }

    [Theory]
    [MemberData(nameof(Integrators))]
    public void A_copy_of_the_librarys_drag_is_the_librarys_drag(Integrator integrator)
    {
        const double Coefficient = 0.3;
        double k = 0.5 * 1.2 * Coefficient * Math.PI * 0.11 * 0.11;
        var builtIn = Scene.Published with { Air = new Air { Wind = new Vector3d(3, 1, -2) }, Forces = ForceSet.Published with { Drag = ForceLaw.Constant, DragCoefficient = Coefficient, Coefficients = AerodynamicModel.Regularized } };
        Scene copy = builtIn with
        {
            Forces = builtIn.Forces with { Drag = ForceLaw.None, CustomForces = [IForce.From(ball => -k * ball.AirVelocity.Length * ball.AirVelocity)] },
        };
        BallState expected = Flight.Play(builtIn, Flight.With(integrator), 0.01, 2, StopAt.Time, s_high, new Vector3d(20, 5, 3), new Vector3d(3, 30, -9), out _);
        BallState actual = Flight.Play(copy, Flight.With(integrator), 0.01, 2, StopAt.Time, s_high, new Vector3d(20, 5, 3), new Vector3d(3, 30, -9), out _);
        Assert.InRange(Vector3d.Distance(expected.Position, actual.Position), 0, 1e-10);
        Assert.InRange(Vector3d.Distance(expected.Spin, actual.Spin), 0, 1e-10);
        Assert.InRange(Differences.Rotation(expected.Orientation, actual.Orientation), 0, 1e-8);
    }

    /// <summary>A ball that rolls against a constant force turns round if rolling friction cannot hold it there, and stays if it can.</summary>
    [Theory]
    [ProfileData]
    public void A_force_turns_a_rolling_ball_round_unless_friction_holds_it(Profile profile)
    {
        foreach ((double force, bool holds) in new[] { (2.0, false), (0.05, true) })
        {
            Scene scene = profile.Scene() with { Air = new Air { Density = 0 }, Forces = profile.Forces() with { Buoyancy = false, CustomForces = [IForce.From(_ => new Vector3d(-force, 0, 0))] } };
            double r = scene.Ball.Radius;
            BallState s = Flight.Play(scene, SolverSettings.Default, 0.01, 6, StopAt.Time, new Vector3d(0, r, 0), new Vector3d(1, 0, 0), new Vector3d(0, 0, -1 / r), out _);
            Assert.Equal(holds, s.Motion == MotionState.Rest);
            Assert.True(holds ? s.Velocity == Vector3d.Zero : s.Velocity.X < -1, $"{s}");
        }
    }

    [Theory]
    [ProfileData]
    public void A_force_that_does_nothing_changes_nothing_through_a_whole_life(Profile profile)
    {
        Scene scene = profile.Scene() with { Air = new Air { Wind = new Vector3d(2, 0, 1) } };
        Scene idle = scene with { Forces = profile.Forces() with { CustomForces = [IForce.From(_ => Vector3d.Zero)] } };
        var random = new Shots(81);
        for (int i = 0; i < 20; i++)
        {
            Vector3d velocity = random.Velocity(5, 25, 0, 35);
            Vector3d spin = random.Uniform(10, 40) * random.Direction();
            BallState a = Flight.Play(scene, SolverSettings.Default, 0.01, 60, StopAt.Rest, new Vector3d(0, 0.11, 0), velocity, spin, out StepLog logA);
            BallState b = Flight.Play(idle, SolverSettings.Default, 0.01, 60, StopAt.Rest, new Vector3d(0, 0.11, 0), velocity, spin, out StepLog logB);
            Assert.Equal(Flight.Kinds(logA), Flight.Kinds(logB));
            Assert.InRange(Vector3d.Distance(a.Position, b.Position), 0, 1e-6);
            Assert.InRange(Differences.Rotation(a.Orientation, b.Orientation), 0, 1e-4);
        }
    }

    /// <summary>The Magnus force alone does no work, whatever way a ball with forces of the game is integrated.</summary>
    [Theory]
    [InlineData(AerodynamicModel.Published)]
    [InlineData(AerodynamicModel.Regularized)]
    public void A_law_that_is_left_out_does_not_act_beside_a_force_of_the_game(AerodynamicModel form)
    {
        var scene = Scene.Published with
        {
            Gravity = 0,
            Forces = ForceSet.Published with { Drag = ForceLaw.None, Coefficients = form, CustomForces = [IForce.From(_ => Vector3d.Zero)] },
        };
        BallState end = Flight.Play(scene, SolverSettings.Default, 0.01, 1, StopAt.Time, s_high, new Vector3d(20, 5, 3), new Vector3d(3, 30, -9), out _);
        Assert.Equal(new Vector3d(20, 5, 3).Length, end.Velocity.Length, 1e-6);
        Assert.True(end.Velocity.Z < 2);
    }

    [Theory]
    [ProfileData]
    public void A_torque_of_the_game_turns_the_spin(Profile profile)
    {
        var scene = profile.Scene() with { Forces = ForceSet.None with { CustomForces = [new Torque(new Vector3d(0.001, 0.02, -0.003))] } };
        BallState state = Flight.Play(scene, SolverSettings.Default, 0.01, 2, StopAt.Time, s_high, Vector3d.Zero, new Vector3d(5, 0, 0), out _);
        Vector3d expected = new Vector3d(5, 0, 0) + (2 / scene.Ball.MomentOfInertia * new Vector3d(0.001, 0.02, -0.003));
        Assert.InRange(Vector3d.Distance(expected, state.Spin), 0, 1e-11);
    }

    /// <summary>About a fixed axis from rest the angle is half the spin times the time.</summary>
    [Theory]
    [ProfileData]
    public void A_torque_of_the_game_turns_the_ball(Profile profile)
    {
        var scene = profile.Scene() with { Forces = ForceSet.None with { CustomForces = [new Torque(new Vector3d(0, 0.003, 0))] } };
        BallState state = Flight.Play(scene, SolverSettings.Default, 0.01, 0.5, StopAt.Time, s_high, Vector3d.Zero, Vector3d.Zero, out _);
        double angle = 0.5 * 0.003 / scene.Ball.MomentOfInertia * 0.25;
        Assert.Equal(Math.Sin(angle / 2), state.Orientation.Y, 1e-10);
    }

    [Theory]
    [ProfileData]
    public void A_torque_of_the_game_may_reverse_a_spin(Profile profile)
    {
        var scene = profile.Scene() with { Forces = profile.Forces() with { CustomForces = [new Torque(new Vector3d(0, -0.01, 0))] } };
        BallState state = Flight.Play(scene, SolverSettings.Default, 0.01, 2, StopAt.Time, s_high, new Vector3d(10, 0, 0), new Vector3d(0, 2, 0), out _);
        Assert.True(state.Spin.Y < -1);
    }

    [Theory]
    [ProfileData]
    public void A_force_sees_the_ball_as_it_is(Profile profile)
    {
        var seen = new Recorder();
        Scene scene = profile.Scene() with { Air = new Air { Wind = new Vector3d(1, 2, 3) }, Forces = profile.Forces() with { CustomForces = [seen] } };
        var simulator = new Simulator(scene, Flight.With(Integrator.Euler));
        BallState state = simulator.Launch(new Vector3d(0, 5, 0), new Vector3d(10, 1, 2), new Vector3d(4, 5, 6));
        var log = new StepLog();
        simulator.Step(ref state, 0.01, log);
        BallState before = state;
        seen.First = null;
        simulator.Step(ref state, 0.01, log);
        ForceContext first = seen.First!.Value;
        Assert.Equal(before.Time, first.Time);
        Assert.Equal(before.Position, first.Position);
        Assert.Equal(before.Velocity, first.Velocity);
        Assert.Equal(before.Velocity - new Vector3d(1, 2, 3), first.AirVelocity);
        Assert.InRange(Vector3d.Distance(before.Spin, first.Spin), 0, 1e-14);
        Assert.Equal(MotionState.Airborne, first.Motion);
        simulator.Run(ref state, 0.005, 60, StopAt.Rest, log);
        Assert.Equal([MotionState.Airborne, MotionState.Sliding, MotionState.Rolling], seen.Motions.Order());
    }

    [Theory]
    [ProfileData]
    public void Forces_add_up_in_their_order_and_by_mass(Profile profile)
    {
        var scene = profile.Scene() with
        {
            Gravity = 0,
            Ball = new BallProperties { Mass = 2 },
            Forces = ForceSet.None with { CustomForces = [IForce.From(_ => new Vector3d(4, 0, 0)), IForce.From(_ => new Vector3d(2, 0, 6))] },
        };
        BallState state = Flight.Play(scene, SolverSettings.Default, 0.1, 1, StopAt.Time, s_high, Vector3d.Zero, Vector3d.Zero, out _);
        Assert.InRange(Vector3d.Distance(state.Velocity, new Vector3d(3, 0, 3)), 0, 1e-13);
    }

    /// <summary>On the ground a push of the game works against friction, and its vertical part is dropped.</summary>
    [Fact]
    public void A_push_along_the_ground_works_against_the_rolling_friction()
    {
        var push = IForce.From(ball => ball.Motion == MotionState.Rolling ? new Vector3d(0.5, 99, 0) : Vector3d.Zero);
        Scene scene = Scene.Vacuum with { Forces = ForceSet.None with { CustomForces = [push] } };
        BallState state = Flight.Play(
            scene, SolverSettings.Default, 0.01, 1, StopAt.Time, new Vector3d(0, 0.11, 0), new Vector3d(2, 0, 0), new Vector3d(0, 0, -2 / 0.11), out _);
        Assert.Equal(2 + (0.5 / 0.43) - (0.05 * 9.81), state.Velocity.X, 1e-10);
        Assert.Equal(0.11, state.Position.Y);
        Assert.Equal(MotionState.Rolling, state.Motion);
    }

    /// <summary>Finite forces and winds may still lead to a state that is not finite, in any of its parts.</summary>
    [Fact]
    public void A_state_that_is_not_finite_is_refused()
    {
        BallState fine = new Simulator().Launch(s_high, new Vector3d(1, 2, 3), new Vector3d(4, 5, 6));
        SceneAir.Of(Scene.Default).CheckOutcome(in fine);
        Refused(fine, (ref BallState s) => s.Position = new Vector3d(0, double.PositiveInfinity, 0));
        Refused(fine, (ref BallState s) => s.Velocity = new Vector3d(double.NaN, 0, 0));
        Refused(fine, (ref BallState s) => s.SpinRate = double.PositiveInfinity);
        Refused(fine, (ref BallState s) => s.BaseOrientation = default);
    }

    private delegate void Change(ref BallState state);

    private static void Refused(BallState state, Change change)
    {
        change(ref state);
        Scene windy = Scene.Default with { Air = new Air { WindField = new WindByHeight(8, 1, 2) } };
        ForceSet pushed = ForceSet.Measured with { CustomForces = [IForce.From(_ => Vector3d.Zero)] };
        Names("air.windField made", windy);
        Names("forces.customForces made", Scene.Default with { Forces = pushed });
        Names("air.windField or forces.customForces made", windy with { Forces = pushed });

        void Names(string cause, Scene scene) =>
            Assert.StartsWith(cause, Assert.Throws<InvalidOperationException>(() => SceneAir.Of(scene).CheckOutcome(in state)).Message, StringComparison.Ordinal);
    }

    private sealed class Torque : IForce
    {
        private readonly Vector3d _torque;

        public Torque(Vector3d torque) => _torque = torque;

        public void Apply(in ForceContext ball, ref ForceAndTorque sum) => sum.AddTorque(_torque);
    }

    private sealed class Recorder : IForce
    {
        public ForceContext? First { get; set; }

        public HashSet<MotionState> Motions { get; } = [];

        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
            First ??= ball;
            Motions.Add(ball.Motion);
        }
    }
}
