namespace FootballPhysics.Tests.Things;

/// <summary>A bounce that nothing presses back is a bounce, however slow: off walls, boards, kerbs and objects that give way.</summary>
public sealed class SlowBounceTests
{
    private const double Radius = 0.11;
    private const double Gravity = 9.81;

    private static readonly SurfaceMaterial s_elastic = SurfaceMaterial.GoalFrame with { NormalRestitution = 1, RestitutionSpeedScale = double.PositiveInfinity, TangentialRestitution = 0, ImpactFriction = 0, SlidingFriction = 0, RollingResistance = 0 };

    private static readonly Scene s_space = new() { Ball = BallProperties.Tunnel, Gravity = 0, Air = new Air { Density = 0 }, Ground = new Ground { Material = SurfaceMaterial.DryTurf, Height = -1000 } };

    [Theory]
    [InlineData(false, 0.001)]
    [InlineData(false, 0.05)]
    [InlineData(false, 0.19)]
    [InlineData(true, 0.001)]
    [InlineData(true, 0.1)]
    [InlineData(true, 0.19)]
    public void Off_an_elastic_wall_in_space_it_comes_back_as_fast(bool isEngine, double speed)
    {
        Scene scene = s_space;
        var wall = PosedCollider.In(ref scene, new BoxShape(new Vector3d(1.5, 0, 0), new Vector3d(0.5, 1, 1)), s_elastic, isEngine);
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(1 - Radius - (0.5 * speed), 0, 0), new Vector3d(speed, 0, 0), default);
        var log = new StepLog();
        for (int i = 0; i < 60; i++)
        {
            wall.MoveTo(default, Quaterniond.Identity, default, default, state.Time);
            simulator.Step(ref state, 1 / 60.0, log);
        }

        Assert.Equal(0, Vector3d.Distance(new Vector3d(-speed, 0, 0), state.Velocity), 1e-15);
        Assert.Equal(1 - Radius - (0.5 * speed), state.Position.X, 1e-12);
        Assert.Equal(BallEventKind.Impact, Assert.Single(log.Events.Span.ToArray()).Kind);
        Assert.Equal(state.Velocity, log.Events[0].Velocity);
    }

    /// <summary>A body of the ball's own mass takes over what it may: all of an elastic impact, half of a dead one.</summary>
    [Theory]
    [InlineData(1.0, 0.0, 0.15)]
    [InlineData(0.0, 0.075, 0.075)]
    [InlineData(0.5, 0.0375, 0.1125)]
    public void Momentum_is_counted_once_where_an_object_gives_way(double restitution, double ball, double body)
    {
        var bodies = new KinematicBodies();
        KinematicBody other = bodies.Add("other", new SphereShape(default, 0.14), s_elastic with { NormalRestitution = restitution }, mass: BallProperties.Tunnel.Mass);
        other.MoveTo(new Vector3d(0.25 + 0.02, 0, 0), default, 0);
        var simulator = new Simulator(s_space with { Bodies = bodies });
        BallState state = simulator.Launch(default, new Vector3d(0.15, 0, 0), default);
        var log = new StepLog();
        for (int i = 0; i < 60; i++)
        {
            simulator.Step(ref state, 1 / 60.0, log);
        }

        Assert.Equal(ball, state.Velocity.X, 1e-9);
        Assert.Equal(body, other.Velocity.X, 1e-9);
        Assert.Single(log.Events.Span.ToArray(), item => item.Kind == BallEventKind.Impact);
    }

    /// <summary>With e 0 the ball moves along with a wall that comes, which nothing slows.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_dead_wall_that_moves_takes_it_along(bool isEngine)
    {
        Scene scene = s_space;
        var wall = PosedCollider.In(ref scene, new BoxShape(new Vector3d(-0.5, 0, 0), new Vector3d(0.5, 1, 1)), s_elastic with { NormalRestitution = 0 }, isEngine);
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(Radius + 0.02, 0, 0), default, default);
        var log = new StepLog();
        for (int i = 0; i < 60; i++)
        {
            wall.MoveTo(new Vector3d(0.1 * state.Time, 0, 0), Quaterniond.Identity, new Vector3d(0.1, 0, 0), default, state.Time);
            simulator.Step(ref state, 1 / 60.0, log);
        }

        Assert.Equal(0.1, state.Velocity.X, 1e-12);
        Assert.Equal(Radius + (0.1 * state.Time), state.Position.X, 1e-9);
    }

    /// <summary>On ice, off a board: the ground carries the ball on, and e counts.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void On_ice_it_comes_back_off_a_board(bool isEngine)
    {
        Scene scene = s_space with
        {
            Gravity = Gravity,
            Ground = new Ground
            {
                Material = SurfaceMaterial.DryTurf with
                {
                    ImpactFriction = 0,
                    SlidingFriction = 0,
                    RollingResistance = 0,
                    RollingResistancePerSpeed = 0,
                    TorsionalPatchRadius = 0,
                },
                RestEnergy = 1e-9,
            }
        };
        var board = PosedCollider.In(ref scene, new BoxShape(new Vector3d(1.05, 0.5, 0), new Vector3d(0.05, 0.5, 3)), s_elastic with { NormalRestitution = 0.8 }, isEngine);
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0.5, Radius, 0), new Vector3d(0.15, 0, 0), default);
        var log = new StepLog();
        for (int i = 0; i < 240; i++)
        {
            board.MoveTo(default, Quaterniond.Identity, default, default, state.Time);
            simulator.Step(ref state, 1 / 60.0, log);
        }

        Assert.Equal(-0.12, state.Velocity.X, 1e-9);
        Assert.Equal(Radius, state.Position.Y, 1e-9);
    }

    /// <summary>A dead, rough kerb lifts a ball from √(2 g h/(1 + k)) (1 + k)/(1 + k − h/r) on.</summary>
    [Theory]
    [InlineData(false, 0.002)]
    [InlineData(false, 0.005)]
    [InlineData(false, 0.02)]
    [InlineData(false, 0.05)]
    [InlineData(true, 0.005)]
    [InlineData(true, 0.03)]
    public void A_kerb_is_climbed_from_the_speed_that_energy_and_angular_momentum_give(bool isEngine, double height)
    {
        const double Inertia = 2.0 / 3;
        double least = Math.Sqrt(2 * Gravity * height / (1 + Inertia)) * (1 + Inertia) / (1 + Inertia - (height / Radius));
        Assert.False(Climbs(isEngine, height, 0.98 * least));
        Assert.True(Climbs(isEngine, height, 1.02 * least));
    }

    /// <summary>The control: on turf the hops end.</summary>
    [Fact]
    public void A_ball_dropped_on_turf_comes_to_rest_within_8_s_and_25_impacts()
    {
        var ball = new Ball(new Scene { Ball = BallProperties.Tunnel, Ground = Ground.Of(SurfaceMaterial.DryTurf) });
        ball.Place(new Vector3d(0, 2, 0));
        int impacts = 0;
        while (ball.Motion != MotionState.Rest && ball.Time < 20)
        {
            ball.Step(1 / 60.0);
            impacts += ball.Events.Impacts > 0 ? (int)ball.Events.Impacts : 0;
        }

        Assert.InRange(ball.Time, 1, 8);
        Assert.InRange(impacts, 4, 25);
    }

    private static bool Climbs(bool isEngine, double height, double speed)
    {
        Scene scene = s_space with
        {
            Gravity = Gravity,
            Ground = new Ground
            {
                Material = SurfaceMaterial.DryTurf with
                {
                    ImpactFriction = 10,
                    SlidingFriction = 10,
                    RollingResistance = 0,
                    RollingResistancePerSpeed = 0,
                    TorsionalPatchRadius = 0,
                },
                RestEnergy = 1e-9,
            },
        };
        var rough = SurfaceMaterial.GoalFrame with { NormalRestitution = 0, RestitutionSpeedScale = double.PositiveInfinity, TangentialRestitution = 0, ImpactFriction = 100, SlidingFriction = 10, RollingResistance = 0 };
        var kerb = PosedCollider.In(ref scene, new BoxShape(new Vector3d(5, height - 0.5, 0), new Vector3d(4, 0.5, 4)), rough, isEngine);
        var simulator = new Simulator(scene);
        BallState state = simulator.Launch(new Vector3d(0.7, Radius, 0), new Vector3d(speed, 0, 0), new Vector3d(0, 0, -speed / Radius));
        var log = new StepLog();
        double end = 0.3 / speed * 8;
        while (state.Time < end)
        {
            kerb.MoveTo(default, Quaterniond.Identity, default, default, state.Time);
            simulator.Step(ref state, 0.01, log);
        }

        return state.Position.X > 1;
    }
}
