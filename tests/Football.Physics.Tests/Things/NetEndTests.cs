using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>The end of a net: at its greatest depth it stops the ball like a board without bounce and friction, and nothing changes before it.</summary>
public sealed class NetEndTests
{
    private const double Stiffness = 300;

    private static readonly BallProperties s_ball = new() { Mass = 0.5, Radius = 0.1, InertiaFactor = 0.5 };

    /// <summary>No air, no gravity, no ground: only the net acts.</summary>
    private static readonly Scene s_space = new() { Ball = s_ball, Gravity = 0, Air = new Air { Density = 0 }, Ground = Ground.None };

    private static readonly Net s_spring = new()
    {
        Center = new Vector3d(0.4, -0.2, 0.3),
        Normal = new Vector3d(0, 0, 2),
        Along = new Vector3d(3, 0, 0),
        HalfLength = 5,
        HalfWidth = 5,
        Stiffness = Stiffness,
        Damping = 0,
        TangentialDamping = 0,
        SpinDamping = 0,
        Give = 0.35,
    };

    /// <summary>A spring without damping, by its own equation: the ball reaches the end at sin ωt = ω give/v, and returns at ω give, which is all that the spring holds.</summary>
    [Theory]
    [InlineData(1, Integrator.Rk4, 1e-8)]
    [InlineData(-1, Integrator.Rk4, 1e-8)]
    [InlineData(1, Integrator.Rk2, 1e-8)]
    public void A_fast_ball_is_stopped_at_the_end_and_returns_by_the_spring(double side, Integrator integrator, double tolerance)
    {
        const double Speed = 20;
        var simulator = new Simulator(s_space with { Nets = [s_spring] }, Flight.With(integrator));
        var spin = new Vector3d(3, -4, 12);
        BallState state = simulator.Launch(s_spring.Center + new Vector3d(0, 0, side * 0.3), new Vector3d(1.5, -0.5, -side * Speed), spin);
        var log = new StepLog();
        Run(simulator, ref state, 0.2, 0.01, log);

        double omega = Math.Sqrt(Stiffness / s_ball.Mass);
        double met = 0.2 / Speed;
        double reached = met + (Math.Asin(omega * s_spring.Give / Speed) / omega);
        BallEvent[] events = log.Events.Span.ToArray();
        Assert.Equal([BallEventKind.Net, BallEventKind.Impact], events.Select(happened => happened.Kind));
        Assert.All(events, happened => Assert.Equal("net", simulator.NameOf(happened.ColliderIndex)));
        Assert.Equal(events[0].ColliderIndex, events[1].ColliderIndex);
        Assert.Equal(met, events[0].Time, 1e-12);
        Assert.Equal(reached, events[1].Time, tolerance);
        Assert.Equal(0, (events[1].Normal - new Vector3d(0, 0, side)).Length, 1e-12);
        Assert.Equal(0, (events[1].Velocity - new Vector3d(1.5, -0.5, 0)).Length, 1e-9);
        Assert.Equal(s_spring.Center.Z + (side * (s_ball.Radius - s_spring.Give)), events[1].Position.Z, 1e-9);

        // The rest of the way: a quarter of a period back to depth 0, and on at ω give.
        double left = 0.2 - reached - (Math.PI / 2 / omega);
        Assert.Equal(0, state.Velocity.X - 1.5, 1e-12);
        Assert.Equal(side * omega * s_spring.Give, state.Velocity.Z, 1e-6);
        Assert.Equal(s_spring.Center.Z + (side * (s_ball.Radius + (omega * s_spring.Give * left))), state.Position.Z, 1e-6);
        Assert.Equal(0, (state.Spin - spin).Length, 1e-12);
        Assert.Equal(0UL, state.Nets);
    }

    /// <summary>A ball too slow for the end keeps its bits, whatever the give.</summary>
    [Fact]
    public void A_ball_that_does_not_reach_the_end_keeps_its_bits()
    {
        var random = new Shots(7201);
        var goal = new Goal { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) };
        var near = new Simulator(Scene.Default with { Goals = [goal with { HasNet = false }], Nets = [.. goal.Nets()] });
        var far = new Simulator(Scene.Default with { Goals = [goal with { HasNet = false }], Nets = [.. goal.Nets().Select(net => net with { Give = 1e6 })] });
        int met = 0;
        for (int i = 0; i < 60; i++)
        {
            var at = new Vector3d(random.Uniform(-3.5, 3.5), random.Uniform(0.1, 2.4), -21);
            var from = new Vector3d(random.Uniform(-8, 8), 0.2, random.Uniform(-15, -4));
            Vector3d velocity = random.Uniform(10, 70) * (at - from).Normalized();
            Vector3d spin = 60 * new Vector3d(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
            BallState one = near.Launch(from, velocity, spin);
            BallState other = far.Launch(from, velocity, spin);
            var log = new StepLog();
            for (int step = 0; step < 300; step++)
            {
                near.Step(ref one, 1 / 60.0, log);
                far.Step(ref other, 1 / 60.0, log);
                met += one.Nets != 0 ? 1 : 0;
                Assert.Equal(Motion(in other), Motion(in one));
            }
        }

        Assert.True(met > 1000, $"{met} frames in a net");
    }

    /// <summary>A kick of no speed that a shot has reaches the end of a default net: an ordinary ball of 250 m/s stops before it, and a ball of 3 kg and 38 m/s does.</summary>
    [Theory]
    [InlineData(0.43, 250, false)]
    [InlineData(0.43, 270, true)]
    [InlineData(3, 38, false)]
    [InlineData(3, 40, true)]
    public void Only_a_ball_beyond_any_shot_reaches_the_end_of_a_default_net(double mass, double speed, bool reaches)
    {
        Net net = s_spring with { Give = 0.6, Stiffness = 400, Damping = 1.5, TangentialDamping = 60, SpinDamping = 0.02 };
        var simulator = new Simulator(s_space with { Ball = s_ball with { Mass = mass, Radius = 0.11 }, Nets = [net] });
        BallState state = simulator.Launch(net.Center + new Vector3d(0, 0, 1), new Vector3d(0, 0, -speed), default);
        var log = new StepLog();
        Run(simulator, ref state, 0.5, 0.01, log);
        Assert.Equal(reaches, log.Events.Span.ToArray().Any(happened => happened.Kind == BallEventKind.Impact));
    }

    /// <summary>A heavy ball lies on the end of a horizontal net, and the net's damping along it, F = −k_t give v, is all that brakes it.</summary>
    [Fact]
    public void A_heavy_ball_slides_on_the_end_against_the_damping_alone_and_rests_there()
    {
        const double Mass = 40;
        Net net = s_spring with { Center = new Vector3d(0, 3, 0), Normal = Vector3d.Up, Along = new Vector3d(1, 0, 0), Damping = 1.5, TangentialDamping = 60, SpinDamping = 0.02, HalfLength = 30 };
        var simulator = new Simulator(s_space with { Ball = s_ball with { Mass = Mass }, Gravity = 9.81, Nets = [net] });
        double height = net.Center.Y + s_ball.Radius - net.Give;
        BallState state = simulator.Launch(new Vector3d(0, 3.1, 0), default, default);
        var log = new StepLog();
        Run(simulator, ref state, 10, 0.02, log);
        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.Equal(height, state.Position.Y, 1e-9);
        simulator.Validate(in state);

        simulator.Kick(ref state, new Vector3d(2, 0, 0), default);
        log.Clear();
        Run(simulator, ref state, 1, 0.02, log);
        double rate = net.TangentialDamping * net.Give / Mass;
        Assert.Equal(MotionState.Sliding, state.Motion);
        Assert.Equal(height, state.Position.Y, 1e-9);
        Assert.Equal(2 * Math.Exp(-rate), state.Velocity.X, 1e-9);
        Assert.Equal(2 * (1 - Math.Exp(-rate)) / rate, state.Position.X, 1e-9);
        Assert.All(log.Events.Span.ToArray(), happened => Assert.Equal("net", simulator.NameOf(happened.ColliderIndex)));

        // The state on the end is one that a ball can have, and survives its bytes. On the other side of the net there is no such end.
        simulator.Validate(in state);
        BallState wrong = state;
        wrong.NetSides ^= 1;
        Assert.Throws<ArgumentOutOfRangeException>(() => simulator.Validate(in wrong));
        Run(simulator, ref state, 60, 0.02, log);
        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.Equal(0, state.Velocity.Length);
    }

    /// <summary>A ball that slides on the end leaves the net over its edge, by r and the depth, and then flies.</summary>
    [Fact]
    public void A_ball_falls_off_the_end_beyond_the_edge()
    {
        Net net = s_spring with { Center = new Vector3d(0, 3, 0), Normal = Vector3d.Up, Along = new Vector3d(1, 0, 0), HalfLength = 1, Damping = 1.5 };
        var simulator = new Simulator(s_space with { Ball = s_ball with { Mass = 40 }, Gravity = 9.81, Nets = [net] });
        BallState state = simulator.Launch(new Vector3d(0, 3.1, 0), default, default);
        var log = new StepLog();
        Run(simulator, ref state, 2, 0.02, log);
        simulator.Kick(ref state, new Vector3d(2, 0, 0), default);
        log.Clear();
        double edge = net.HalfLength + s_ball.Radius + net.Give;
        Run(simulator, ref state, (edge / 2) + 0.1, 0.02, log);
        BallEvent last = log.Events.Span[^1];
        Assert.Equal(BallEventKind.ContactEnd, last.Kind);
        Assert.Equal(edge, last.Position.X, 1e-9);
        Assert.Equal(0UL, state.Nets);
        Assert.Equal(MotionState.Airborne, state.Motion);
        Assert.Equal(net.Center.Y + s_ball.Radius - net.Give - (0.5 * 9.81 * 0.01), state.Position.Y, 1e-6);
        simulator.Validate(in state);
    }

    /// <summary>A light ball on the end of a roof does not stay there, although its weight presses: the net pulls with more.</summary>
    [Fact]
    public void The_net_pulls_a_light_ball_off_its_end()
    {
        Net net = s_spring with { Center = new Vector3d(0, 3, 0), Normal = Vector3d.Up, Along = new Vector3d(1, 0, 0), Damping = 1.5, TangentialDamping = 60, SpinDamping = 0.02 };
        var simulator = new Simulator(s_space with { Gravity = 9.81, Nets = [net] });
        BallState state = simulator.Launch(new Vector3d(0, 3.2, 0), new Vector3d(0, -400, 0), default);
        var log = new StepLog();
        Run(simulator, ref state, 0.1, 0.01, log);
        Assert.Contains(log.Events.Span.ToArray(), happened => happened.Kind == BallEventKind.Impact);
        Assert.Equal(MotionState.Airborne, state.Motion);
        Assert.InRange(state.Position.Y, 3.1 - net.Give + 0.01, 3.1);
        Run(simulator, ref state, 30, 0.01, log);
        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.Equal(3.1 - (s_ball.Mass * 9.81 / Stiffness), state.Position.Y, 1e-3);
    }

    /// <summary>A player who walks a ball into a net pins it at its end, as against a board, and the ball comes back when he has gone.</summary>
    [Theory]
    [InlineData(double.PositiveInfinity)]
    [InlineData(75)]
    public void A_walked_ball_is_pinned_at_the_end_and_comes_back(double mass)
    {
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", new CapsuleShape(new Vector3d(0, 0.3, 0), new Vector3d(0, 1.5, 0), 0.3), SurfaceMaterial.Boot, mass);
        Net net = s_spring with { Center = new Vector3d(0, 1, 0), Stiffness = 400, Damping = 1.5, TangentialDamping = 60, SpinDamping = 0.02, Give = 0.5 };
        var simulator = new Simulator(Scene.Default with { Bodies = bodies, Nets = [net] });
        double r = Scene.Default.Ball.Radius;
        BallState state = simulator.Launch(new Vector3d(0, r, 1), default, default);
        var log = new StepLog();
        bool pinned = false;
        double deepest = 0;
        for (int i = 0; i < 120; i++)
        {
            double at = Math.Max(1.5 - (i / 30.0), -0.3);
            player.MoveTo(new Vector3d(0, 0, at), new Vector3d(0, 0, at > -0.3 ? -2 : 0), state.Time);
            simulator.Step(ref state, 1 / 60.0, log);
            pinned |= state.Motion == MotionState.Pinned;
            deepest = Math.Max(deepest, r - state.Position.Z);
        }

        Assert.True(pinned);
        Assert.Equal(net.Give, deepest, 1e-9);
        double before = state.Position.Z;
        for (int i = 0; i < 120; i++)
        {
            player.MoveTo(new Vector3d(9, 0, 9), default, state.Time);
            simulator.Step(ref state, 1 / 60.0, log);
        }

        Assert.Equal(0UL, state.Nets);
        Assert.True(state.Position.Z > before + 0.3, $"{state}");
        Assert.True(state.Velocity.Length < 1 / net.Damping);
    }

    /// <summary>A look-ahead and a group of one ball take the same course up to the end of a net and back.</summary>
    [Fact]
    public void Look_aheads_and_groups_take_the_same_course()
    {
        Scene scene = Scene.Default with { Goals = [new Goal { Center = new Vector3d(0, 0, -3), Facing = new Vector3d(0, 0, 1) }] };
        var simulator = new Simulator(scene);
        BallState start = simulator.Launch(new Vector3d(0.4, 0.5, -2), new Vector3d(0, 8, -400), new Vector3d(0, 30, 0));
        var path = new Trajectory();
        simulator.LookAhead(in start, new LookAheadRequest(), path);
        var group = new BallGroup(simulator, 1);
        BallState[] states = [start];
        BallState state = start;
        var log = new StepLog();
        for (int i = 0; i < 300; i++)
        {
            simulator.Step(ref state, 0.01, log);
            group.Step(states, 0.01, new StepLog());
            Assert.Equal(Motion(in state), Motion(in states[0]));
            Assert.Equal(0, (path.PositionAt(state.Time) - state.Position).Length, 1e-4);
        }

        Assert.Contains(log.Events.Span.ToArray(), happened => happened.Kind == BallEventKind.Impact && simulator.NameOf(happened.ColliderIndex) == "back net");
        Assert.Contains(path.Events.Span.ToArray(), happened => happened.Kind == BallEventKind.Impact && simulator.NameOf(happened.ColliderIndex) == "back net");
    }

    [Theory]
    [InlineData(0.049)]
    [InlineData(1.1e6)]
    [InlineData(double.NaN)]
    public void A_give_out_of_range_is_refused_by_name(double give)
    {
        var refused = Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(s_space with { Nets = [s_spring with { Give = give }] }));
        Assert.Contains("nets[0].give is ", refused.Message, StringComparison.Ordinal);
        Assert.Contains("allowed: 0.05 … 1000000", refused.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void The_give_is_a_part_of_the_scene()
    {
        var one = new Simulator(s_space with { Nets = [s_spring] });
        var other = new Simulator(s_space with { Nets = [s_spring with { Give = 0.36 }] });
        Assert.NotEqual(one.SceneHash, other.SceneHash);
        Assert.Equal(0.6, Assert.Single(new Goal { Center = default, Facing = new Vector3d(0, 0, 1) }.Nets(), net => net.Name == "back net").Give);
        Assert.Equal(["ground", "net"], one.Names);
    }

    private static (Vector3d Position, Vector3d Velocity, Vector3d Spin, MotionState Motion, ulong Nets) Motion(in BallState s) => (s.Position, s.Velocity, s.Spin, s.Motion, s.Nets);

    private static void Run(Simulator simulator, ref BallState state, double duration, double step, StepLog log)
    {
        for (double end = state.Time + duration - 1e-9; state.Time < end;)
        {
            simulator.Step(ref state, Math.Min(step, end + 1e-9 - state.Time), log);
        }
    }
}
