namespace FootballPhysics.Tests.Motion;

/// <summary>Custom forces that change the motion faster than a step, against closed forms.</summary>
public sealed class StiffForceTests
{
    private const double Mass = 0.43;
    private const double Close = 0.003;

    private static readonly BallProperties s_ball = new() { Mass = Mass, Radius = 0.11, InertiaFactor = 2 / 3.0 };

    private static readonly Scene s_void = new() { Gravity = 0, Air = new Air { Density = 0 }, Ground = Ground.None, Ball = s_ball };

    public static TheoryData<double, double, Integrator> Rates()
    {
        var rates = new TheoryData<double, double, Integrator>();
        foreach (double stiffness in new[] { 3.0, 20, 60, 150, 300 })
        {
            foreach (double rate in new[] { 30.0, 60, 100 })
            {
                rates.Add(stiffness, rate, Integrator.Rk4);
            }

            rates.Add(stiffness, 100, Integrator.Rk2);
        }

        return rates;
    }

    /// <summary>y = y₀ + v/λ (1 − e^(−λt)).</summary>
    [Theory]
    [MemberData(nameof(Rates))]
    public void A_damping_stops_the_ball(double stiffness, double rate, Integrator integrator) => Check(
        ball => -Mass * stiffness * ball.Velocity, new Vector3d(0, 1, 0), new Vector3d(0, 20, 0), rate, integrator, 1 + (20 / stiffness * (1 - Math.Exp(-stiffness))));

    /// <summary>y = 1 + 0.3 cos ωt.</summary>
    [Theory]
    [MemberData(nameof(Rates))]
    public void A_spring_swings(double stiffness, double rate, Integrator integrator) =>
        Check(Spring(stiffness), new Vector3d(0, 1.3, 0), Vector3d.Zero, rate, integrator, 1 + (0.3 * Math.Cos(stiffness)));

    /// <summary>Methods of low order do not show that a force is stiff, so the end shows it.</summary>
    [Theory]
    [InlineData(Integrator.Euler)]
    [InlineData(Integrator.SemiImplicitEuler)]
    [InlineData(Integrator.Rk2)]
    public void Methods_of_low_order_do_not_overshoot(Integrator integrator)
    {
        Check(Spring(60), new Vector3d(0, 1.3, 0), Vector3d.Zero, 60, integrator, 1 + (0.3 * Math.Cos(60)));
        Check(ball => -Mass * 300 * ball.Velocity, new Vector3d(0, 1, 0), new Vector3d(0, 20, 0), 60, integrator, 1 + (20 / 300.0));
    }

    [Fact]
    public void A_stiff_path_fits_the_default_buffer()
    {
        var path = new Trajectory();
        Simulator simulator = Of(s_void, Spring(60));
        simulator.LookAhead(simulator.Launch(new Vector3d(0, 1.3, 0), default, default), new LookAheadRequest { Duration = 1 }, path);
        Assert.True(path.IsComplete);
        Assert.Equal(1 + (0.3 * Math.Cos(60)), path.PositionAt(1).Y, Close);
        Assert.Equal(0, path.StiffSteps);
    }

    /// <summary>The edge of this cord makes up for the second differences of the stages of RK4.</summary>
    [Theory]
    [InlineData(145.36, 60, 29.685, 15.027)]
    [InlineData(50.53, 30, 16.991, 1.299)]
    [InlineData(176.81, 60, 25.585, 6.569)]
    public void A_cord_returns_the_ball(double stiffness, double rate, double speed, double depth)
    {
        double exit = (depth / speed) + (Math.PI / stiffness);
        Check(
            ball => ball.Position.Y > 0 ? new Vector3d(0, -Mass * stiffness * stiffness * ball.Position.Y, 0) : Vector3d.Zero, new Vector3d(0, -depth, 0), new Vector3d(0, speed, 0),
            rate, Integrator.Rk4, -(1 - exit) * speed);
    }

    /// <summary>A layer of 1 cm lies between the stages of a step; the stated stiffness finds it.</summary>
    [Fact]
    public void A_stated_stiffness_finds_a_thin_layer()
    {
        static Vector3d Layer(ForceContext ball) => ball.Position.Y is > 1 and < 1.01 ? -Mass * 100 * ball.Velocity : Vector3d.Zero;
        var log = new StepLog();
        Scene scene = s_void with { Forces = new ForceSet { CustomForces = [IForce.From(Layer, 2000)] } };
        BallState state = Steps(new Simulator(scene), new Vector3d(0, 0.5, 0), new Vector3d(0, 20, 0), 60, log);

        // Across the layer, the speed decreases by λ d.
        Assert.Equal(19, state.Velocity.Y, 1e-3);
        Assert.Equal(0, log.StiffSteps);
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(1.1e6)]
    [InlineData(double.NaN)]
    public void A_stated_stiffness_out_of_range_is_refused(double stiffness)
    {
        Assert.StartsWith("stiffness is", Assert.Throws<ArgumentOutOfRangeException>(() => IForce.From(_ => default, stiffness)).Message, StringComparison.Ordinal);
        Scene scene = s_void with { Forces = new ForceSet { CustomForces = [new Stiff(stiffness)] } };
        Assert.StartsWith("forces.customForces[0].stiffness is", Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(scene)).Message, StringComparison.Ordinal);
    }

    /// <summary>Beyond all that a step can follow, the motion is finite, and the log counts the steps.</summary>
    [Theory]
    [InlineData(1e5)]
    [InlineData(1e7)]
    public void A_force_that_no_step_follows_is_counted(double stiffness)
    {
        var log = new StepLog();
        BallState state = Steps(Of(s_void, Spring(stiffness)), new Vector3d(0, 1.3, 0), Vector3d.Zero, 60, log);
        Assert.True(state.Position.Length < 2);
        Assert.True(log.StiffSteps > 0);
        Assert.InRange(log.Evaluations, 1, 60 * 33_000);
    }

    [Fact]
    public void A_constant_force_costs_nothing()
    {
        var none = new StepLog();
        var constant = new StepLog();
        BallState state = Steps(Of(s_void, _ => default), new Vector3d(0, 1, 0), new Vector3d(3, 5, 0), 60, none);
        BallState pushed = Steps(Of(s_void, _ => new Vector3d(0.43, 0, 0)), new Vector3d(0, 1, 0), new Vector3d(3, 5, 0), 60, constant);
        Assert.Equal((60L * 4, 60L), (none.Evaluations, none.Steps));
        Assert.Equal((none.Evaluations, none.Steps), (constant.Evaluations, constant.Steps));
        Assert.Equal(0.5, pushed.Position.X - state.Position.X, 1e-9);
    }

    [Fact]
    public void A_gravity_vector_costs_nothing()
    {
        var upright = new StepLog();
        var tilted = new StepLog();
        Steps(new Simulator(Scene.Default), new Vector3d(0, 9, 0), new Vector3d(3, 8, 0), 60, upright);
        Steps(new Simulator(Scene.Default with { GravityVector = new Vector3d(2, -9.6, 1) }), new Vector3d(0, 9, 0), new Vector3d(3, 8, 0), 60, tilted);
        Assert.Equal((upright.Evaluations, upright.Steps), (tilted.Evaluations, tilted.Steps));
    }

    /// <summary>A ball on frictionless ground swings like one in the air; one that rolls has the inertia 1 + α.</summary>
    [Theory]
    [InlineData(20, false)]
    [InlineData(150, false)]
    [InlineData(20, true)]
    [InlineData(150, true)]
    public void A_spring_swings_on_the_ground(double stiffness, bool rolls)
    {
        SurfaceMaterial material = SurfaceMaterial.Wood with { SlidingFriction = rolls ? 10 : 0, ImpactFriction = rolls ? 10 : 0, RollingResistance = 0, RollingResistancePerSpeed = 0, SpinDamping = 0, TorsionalPatchRadius = 0 };
        Scene scene = s_void with { Gravity = 9.81, Ground = Ground.Of(material) };
        Simulator simulator = Of(scene, ball => new Vector3d(-Mass * stiffness * stiffness * ball.Position.X, 0, 0));
        var log = new StepLog();
        BallState state = Steps(simulator, new Vector3d(0.01, 0.11, 0), Vector3d.Zero, 60, log);
        Assert.Equal(0.01 * Math.Cos(stiffness / (rolls ? Math.Sqrt(5 / 3.0) : 1)), state.Position.X, 0.1 * Close);
        Assert.Equal(0.11, state.Position.Y, 1e-9);
        Assert.Equal(0, log.StiffSteps);
    }

    /// <summary>In a corner of the ground and a board, the ball stays where a stiff spring pulls it.</summary>
    [Theory]
    [InlineData(100)]
    [InlineData(3000)]
    [InlineData(1e5)]
    public void A_spring_into_a_corner_holds_the_ball(double stiffness)
    {
        Scene scene = s_void with
        {
            Gravity = 9.81,
            Ground = Ground.Of(SurfaceMaterial.Wood),
            Obstacles = [new Obstacle { Shape = new PlaneShape(new Vector3d(1, 0, 0), new Vector3d(-1, 0, 0)), Surface = SurfaceMaterial.Board }],
        };
        Simulator simulator = Of(scene, ball => -Mass * stiffness * stiffness * (ball.Position - new Vector3d(1, 0, 0)));
        var log = new StepLog();
        BallState state = Steps(simulator, new Vector3d(0.7, 0.3, 0), new Vector3d(0, 0, 2), 60, log);
        Assert.InRange(state.Position.X, 0.5, 0.89 + 1e-9);
        Assert.InRange(state.Position.Y, 0.11 - 1e-9, 0.5);
        Assert.True(state.Velocity.Length < 100 && state.Spin.Length < 1000);
    }

    /// <summary>Stiff springs that press two balls together never make them fast, and are counted if a part is too long for them.</summary>
    [Theory]
    [InlineData(30, false)]
    [InlineData(3000, true)]
    public void Pressed_balls_stay_slow(double stiffness, bool isCounted)
    {
        Scene scene = s_void with { Forces = ForceSet.None with { CustomForces = [IForce.From(ball => -Mass * stiffness * stiffness * ball.Position)] } };
        var group = new BallGroup(scene, [s_ball, s_ball]);
        var simulator = new Simulator(scene);
        BallState[] balls = [simulator.Launch(new Vector3d(0, 0, 0.11), default, default), simulator.Launch(new Vector3d(0, 0.001, -0.11), default, default)];
        var log = new StepLog();
        for (int i = 0; i < 120; i++)
        {
            group.Step(balls, 1 / 60.0, log);
            Assert.All(balls, ball => Assert.True(ball.Position.Length < 1, $"{i}: {ball.Position}"));
        }

        Assert.Equal(isCounted, log.StiffSteps > 0);
        Assert.True((balls[0].Position - balls[1].Position).Length > 0.2);
    }

    /// <summary>In a group, far from others, a ball has the bits that it has alone.</summary>
    [Fact]
    public void A_ball_of_a_group_moves_as_alone()
    {
        Scene scene = s_void with { Forces = new ForceSet { CustomForces = [IForce.From(Spring(90))] } };
        var group = new BallGroup(scene, [s_ball, s_ball]);
        var simulator = new Simulator(scene);
        BallState alone = simulator.Launch(new Vector3d(0, 1.3, 0), default, default);
        BallState[] balls = [alone, simulator.Launch(new Vector3d(50, 1.2, 0), default, default)];
        var log = new StepLog();
        for (int i = 0; i < 60; i++)
        {
            simulator.Step(ref alone, 1 / 60.0, log);
            group.Step(balls, 1 / 60.0, log);
        }

        Assert.Equal(alone.Position, balls[0].Position);
        Assert.Equal(alone.Velocity, balls[0].Velocity);
    }

    /// <summary>About a fixed axis, the angle is ω/λ (1 − e^(−λt)).</summary>
    [Theory]
    [InlineData(20)]
    [InlineData(300)]
    public void A_damping_of_the_spin_turns_the_ball(double stiffness)
    {
        Scene scene = s_void with { Forces = ForceSet.None with { CustomForces = [new Brake(s_ball.MomentOfInertia * stiffness)] } };
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), default, new Vector3d(0, 90, 0));
        var log = new StepLog();
        for (int i = 0; i < 30; i++)
        {
            simulator.Step(ref state, 1 / 30.0, log);
        }

        double angle = 90 / stiffness * (1 - Math.Exp(-stiffness));
        Assert.Equal(Math.Abs(Math.Sin(angle / 2)), Math.Abs(state.Orientation.Y), 0.5 * Close / s_ball.Radius);
        Assert.Equal(0, log.StiffSteps);
    }

    /// <summary>No look-ahead of a ball near a moving body throws, and a weak force or a sideways gravity costs at most three times as much.</summary>
    [Theory]
    [InlineData(0.2, -9.8, 0)]
    [InlineData(1, -9.7, 0)]
    [InlineData(0, -9.81, 0.02)]
    public void Look_aheads_near_moving_bodies_never_throw(double sideways, double down, double force)
    {
        IForce[] own = force == 0 ? [] : [IForce.From(_ => new Vector3d(force, 0, 0))];
        long most = 0;
        long upright = 0;
        for (int i = 0; i < 360; i++)
        {
            most = Math.Max(most, Evaluations(new Vector3d(sideways, down, 0), own, i));
            upright = Math.Max(upright, Evaluations(new Vector3d(0, -9.81, 0), [], i));
        }

        Assert.InRange(most, 1, 3 * upright);
    }

    private static long Evaluations(in Vector3d gravity, IForce[] own, int play)
    {
        int i = play / 6;
        double x = 0.002 * i;
        var bodies = new KinematicBodies();
        bool foot = play % 6 == 1;
        KinematicBody body = bodies.Add("body", foot ? new CapsuleShape(new Vector3d(0, -0.9, 0.1), new Vector3d(0, -0.9, -0.1), 0.05) : new CapsuleShape(new Vector3d(0, 0.25, 0), new Vector3d(0, 1.55, 0), 0.25), SurfaceMaterial.Boot);
        Obstacle[] boards = [new Obstacle { Shape = new BoxShape(new Vector3d(0, 0.5, -5.05), new Vector3d(50, 0.5, 0.05)) }];
        var simulator = new Simulator(new Scene { GravityVector = gravity, Forces = ForceSet.Measured with { CustomForces = own }, Bodies = bodies, Obstacles = boards });
        (Vector3d position, Vector3d velocity) = (play % 6) switch
        {
            0 => (new Vector3d(0, 0.11, -4.8), Vector3d.Zero),
            1 => (new Vector3d(0, 0.11, 0), Vector3d.Zero),
            2 => (new Vector3d(0, 0.11, -4.85), new Vector3d(3 + x, 0, -0.4)),
            3 => (new Vector3d(0, 0.3, -4.9), new Vector3d(2 + x, 0, 0)),
            4 => (new Vector3d(0, 0.11, 0), new Vector3d(0, 0, -4)),
            _ => (new Vector3d(0, 0.11, 0), Vector3d.Zero),
        };
        switch (play % 6)
        {
            case 0:
                body.MoveTo(new Vector3d(x, 0, -3.6 - (0.01 * i)), new Vector3d(0, 0, -1.5), 0);
                break;
            case 1:
                body.MoveTo(new Vector3d(x, 1, 0.5), Quaterniond.FromAxisAngle(new Vector3d(1, 0, 0), 0.5), default, new Vector3d(-4 - (0.1 * i), 0, 0), 0);
                break;
            case 4:
                body.MoveTo(new Vector3d(x, 0, -2), default, 0);
                break;
            case 5:
                body.MoveTo(new Vector3d(x, 0.4, 0), new Vector3d(0, -0.8, 0), 0);
                break;
            default:
                body.MoveTo(new Vector3d(30, 0, 30), default, 0);
                break;
        }

        var path = new Trajectory(4096);
        simulator.LookAhead(simulator.Launch(position, velocity, default), new LookAheadRequest { Duration = 4 }, path);
        return path.Evaluations;
    }

    private static Func<ForceContext, Vector3d> Spring(double stiffness) => ball => -Mass * stiffness * stiffness * (ball.Position - new Vector3d(ball.Position.X, 1, ball.Position.Z));

    private static Simulator Of(Scene scene, Func<ForceContext, Vector3d> force, Integrator integrator = Integrator.Rk4) =>
        new(scene with { Forces = new ForceSet { CustomForces = [IForce.From(force)] } }, new SolverSettings { Integrator = integrator });

    private static BallState Steps(Simulator simulator, in Vector3d position, in Vector3d velocity, int rate, StepLog log)
    {
        BallState state = simulator.Launch(position, velocity, Vector3d.Zero);
        for (int i = 0; i < rate; i++)
        {
            simulator.Step(ref state, 1.0 / rate, log);
        }

        return state;
    }

    /// <summary>Steps, look-aheads with the step of the game, and default look-aheads are right after a second.</summary>
    private static void Check(Func<ForceContext, Vector3d> force, in Vector3d position, in Vector3d velocity, double rate, Integrator integrator, double right)
    {
        Simulator simulator = Of(s_void, force, integrator);
        var log = new StepLog();
        BallState state = Steps(simulator, in position, in velocity, (int)rate, log);
        Assert.Equal(right, state.Position.Y, Close);
        Assert.Equal((0, 0), (log.StiffSteps, log.StalledSteps));
        BallState start = simulator.Launch(position, velocity, Vector3d.Zero);
        var path = new Trajectory(4096);
        simulator.LookAhead(in start, new LookAheadRequest { Duration = 1, TimeStep = 1 / rate }, path);
        Assert.Equal(right, path.PositionAt(1).Y, Close);
        Assert.Equal(state.Position.Y, path.Final.Position.Y, 1e-9);
        if (integrator == Integrator.Rk4)
        {
            simulator.LookAhead(in start, new LookAheadRequest { Duration = 1 }, path);
            Assert.Equal(right, path.PositionAt(1).Y, Close);
        }
    }

    private sealed class Stiff(double stiffness) : IStiffForce
    {
        public double Stiffness => stiffness;

        public void Apply(in ForceContext ball, ref ForceAndTorque sum)
        {
        }
    }

    private sealed class Brake(double perSpin) : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum) => sum.AddTorque(-perSpin * ball.Spin);
    }
}
