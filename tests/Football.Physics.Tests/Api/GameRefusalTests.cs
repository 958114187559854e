namespace FootballPhysics.Tests.Api;

/// <summary>What a game says wrongly is refused with field, value and what is allowed, before anything changes.</summary>
public sealed class GameRefusalTests
{
    private static readonly Obstacle s_wall = new() { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, -14), new Vector3d(0, 0, 1)) };

    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -12), Facing = new Vector3d(0, 0, 1) };

    [Fact]
    public void Null_in_a_list_of_a_scene_is_named_with_its_place()
    {
        Refused("obstacles[1] is null; allowed: an obstacle.", () => new Simulator(new Scene { Obstacles = [s_wall, null!] }));
        Refused("goals[0] is null; allowed: a goal.", () => new Ball(new Scene { Goals = [null!] }));
        Refused("nets[0] is null; allowed: a net.", () => new Simulator(new Scene { Nets = [null!] }));
        Refused("ground.pattern.surfaces[1] is null; allowed: a surface.", () => new Simulator(new Scene { Ground = new Ground { Pattern = new Holes() } }));
    }

    [Fact]
    public void A_strike_without_a_ball_is_refused()
    {
        var foot = new Foot();
        Refused("ball is null. Pass a value.", () => foot.Strike(null!, Vector3d.Zero, Vector3d.Zero, new Vector3d(0, 0, -20), new Vector3d(0, 0, -1)));
        Refused("ball is null. Pass a value.", () => foot.StrikeFor(null!, Vector3d.Zero, Vector3d.Zero, new Vector3d(0, 0, -20), Vector3d.Zero));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(1_000_000_000_000_001)]
    [InlineData(long.MaxValue)]
    public void A_tick_is_in_range(long tick)
    {
        var runner = new FixedStepRunner();
        runner.QueueKick(25, new Vector3d(0, 0.3, -1));
        runner.Step();
        BallState before = runner.State;
        Refused($"tick is {tick}; allowed: 0 … 1000000000000000.", () => runner.Restore(tick, in before));
        Refused($"kick.tick is {tick}; allowed: 0 … 1000000000000000.", () => new KickInput(tick, Vector3d.Zero, Vector3d.Zero));
        Assert.Equal(1, runner.Tick);
        runner.Restore(1_000_000_000_000_000, in before);
        runner.Step();
        Assert.Equal(1_000_000_000_000_001, runner.Tick);
    }

    [Fact]
    public void Room_for_fewer_than_none_is_refused()
    {
        Refused("capacity is -1; allowed: a finite number, 0 or more.", () => new BatchKicks(-1));
        Refused("capacity is -1;", () => new BatchAims(-1));
        Refused("capacity is -1;", () => new BatchFlights(-1));
    }

    [Fact]
    public void An_index_that_nothing_has_is_refused()
    {
        var simulator = new Simulator(new Scene { Goals = [s_goal] });
        Assert.Null(simulator.NameOf(-1));
        int last = 0;
        while (simulator.NameOf(last) != "goal")
        {
            last++;
        }

        Refused($"thing is {last + 1}; allowed: 0 … {last}.", () => simulator.NameOf(last + 1));
        Refused($"thing is 99; allowed: 0 … {last}.", () => simulator.NameOf(99));
        var bulges = new NetBulges(simulator);
        Refused("net is 4; allowed: 0 … 3.", () => bulges.NameOf(4));
        Refused("net is -1; allowed: 0 … 3.", () => bulges[-1]);
        Refused("net is 0; allowed: none", () => new NetBulges(new Simulator()).NameOf(0));
        TrackPoint[] track = [.. Enumerable.Range(0, 9).Select(i => new TrackPoint(0.05 * i, new Vector3d(i, 1 + (0.2 * i) - (0.01 * i * i), 0)))];
        TrackFitResult fit = new TrackFit(new Scene()).Find(track);
        Refused("index is 99; allowed: 0 … 8.", () => fit.Value(99));
        Refused("index is -1; allowed: 0 … 8.", () => fit.StandardError(-1));
        Refused("index is 9; allowed: 0 … 8.", () => fit.IsIdentified(9));
        Refused("column is 9; allowed: 0 … 8.", () => fit.Covariance(0, 9));
        Refused("row is -1; allowed: 0 … 8.", () => fit.Covariance(-1, 9));
    }

    [Fact]
    public void A_plane_that_was_never_made_is_refused()
    {
        var simulator = new Simulator();
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0, 4, -20), Vector3d.Zero);
        var path = new Trajectory();
        simulator.LookAhead(in state, new LookAheadRequest { Duration = 1 }, path);
        Refused("plane.normal is", () => path.TryGetCrossing(default, out _));
        double end = path.Final.Time;
        Refused("lookAhead.untilPlane.normal is", () => simulator.LookAhead(in state, new LookAheadRequest { Duration = 2, UntilPlane = default(Plane3d) }, path));
        Assert.Equal(end, path.Final.Time);
    }

    [Fact]
    public void A_name_that_several_things_have_is_asked_for_with_its_number()
    {
        Goal[] two = [s_goal, s_goal with { Center = new Vector3d(0, 0, 40), Facing = new Vector3d(0, 0, -1) }];
        var aimer = new BankShotAimer(new Scene { Goals = two, Obstacles = [s_wall] });
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(2.2, 0.9, -12.6), Speed = 24, MaximumElevationDegrees = 30 };
        Refused("aim.after[0] is left post; allowed: left post[0] … left post[1], because the scene has 2 colliders with this name.", () => aimer.Find(request, "left post"));
        Refused("aim.after[1] is crossbar;", () => aimer.Find(request, "wall", "crossbar"));
        Refused("aim.after[0] is left post[2]; allowed: ground | wall | left post |", () => aimer.Find(request, "left post[2]"));
        Refused("aim.after[0] is null;", () => aimer.Find(request, (string)null!));
        AimResult alone = new BankShotAimer(new Scene { Goals = [s_goal], Obstacles = [s_wall] }).Find(request, "left post");
        Assert.Equal(AimStatus.Hit, alone.Status);
        AimResult first = aimer.Find(request, "left post[0]");
        Assert.Equal(AimStatus.Hit, first.Status);
        Assert.Equal(alone.Velocity, first.Velocity);
        Assert.NotEqual(AimStatus.Hit, aimer.Find(request, "left post[1]").Status);
    }

    [Fact]
    public void A_log_that_is_never_cleared_stays_small_and_says_what_it_dropped()
    {
        var simulator = new Simulator(Scene.Vacuum with { Ground = Ground.Of(SurfaceMaterial.DryTurf with { NormalRestitution = 1, RestitutionSpeedScale = double.PositiveInfinity }) });
        BallState state = simulator.Launch(new Vector3d(0, 0.13, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        var every = new StepLog(mostEvents: 1 << 20);
        BallState other = state;
        long before = GC.GetAllocatedBytesForCurrentThread();
        for (int i = 0; i < 40_000; i++)
        {
            simulator.Step(ref state, 0.01, log);
        }

        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 500_000);
        for (int i = 0; i < 40_000; i++)
        {
            simulator.Step(ref other, 0.01, every);
        }

        Assert.Equal(EventBuffer.DefaultMost, log.Events.Count);
        Assert.True(log.Events.Dropped > 0);
        Assert.Equal(every.Events.Count, log.Events.Count + log.Events.Dropped);
        Assert.Equal(every.Events[^1].Time, log.Events[^1].Time);
        Assert.Equal(every.Events[0].Time, log.Events[0].Time);
    }

    [Fact]
    public void A_body_moved_for_another_time_than_the_step_s_is_refused_before_the_step()
    {
        Ball ball = AmongTwo(out KinematicBody keeper, out KinematicBody wall);
        wall.MoveTo(new Vector3d(3, 1, -9), Vector3d.Zero, 0);
        for (int i = 0; i < 60; i++)
        {
            keeper.MoveTo(new Vector3d(0, 1, -11), new Vector3d(2, 0, 0), ball.Time);
            ball.Step(1.0 / 60.0);
        }

        BallState before = ball.State;
        keeper.MoveTo(new Vector3d(0, 1, -11), new Vector3d(2, 0, 0), 0);
        Refused(FormattableString.Invariant($"bodies[0].time is 0; allowed: the ball's time before the step, {before.Time:R} s, ± 0.25 s."), () => ball.Step(1.0 / 60.0));
        Assert.True(Snapshot.Same(before, ball.State));
        keeper.MoveTo(new Vector3d(0, 1, -11), new Vector3d(2, 0, 0), before.Time + 0.3);
        Refused("bodies[0].time is", () => ball.Simulator.Run(ref before, 0.01, 0.1, StopAt.Time, new StepLog()));

        // A position of a fifth of a second ago, as a network has it; and nothing said is no mistake.
        keeper.MoveTo(new Vector3d(0, 1, -11), new Vector3d(2, 0, 0), ball.Time - 0.2);
        ball.Step(1.0 / 60.0);
        ball.Step(1.0 / 60.0);
    }

    [Fact]
    public void Bodies_moved_within_a_look_ahead_or_before_a_rollback_are_no_mistake()
    {
        Ball ball = AmongTwo(out KinematicBody keeper, out _);
        var runner = new FixedStepRunner(ball.Simulator, 1.0 / 60.0);
        var rollback = new Rollback(runner, 60);
        var path = new Trajectory();
        for (int i = 0; i < 50; i++)
        {
            keeper.MoveTo(new Vector3d(0, 1, -11), Vector3d.Zero, runner.Time);
            runner.Step();
        }

        BallState state = runner.State;
        keeper.MoveTo(new Vector3d(0, 1, -11), Vector3d.Zero, runner.Time);
        ball.Simulator.LookAhead(in state, new LookAheadRequest { Duration = 2, MoveBodies = time => keeper.MoveTo(new Vector3d(time, 1, -11), Vector3d.Zero, time) }, path);
        Assert.NotNull(rollback.ApplyKick(new KickInput(5, new Vector3d(0, 3, -15), Vector3d.Zero)));
        runner.Step();
    }

    private static Ball AmongTwo(out KinematicBody keeper, out KinematicBody wall)
    {
        var bodies = new KinematicBodies();
        keeper = bodies.Add("keeper", new SphereShape(Vector3d.Zero, 0.5), SurfaceMaterial.Glove);
        wall = bodies.Add("wall", new SphereShape(Vector3d.Zero, 0.5));
        wall.MoveTo(new Vector3d(30, 1, 0), Vector3d.Zero, 0);
        keeper.MoveTo(new Vector3d(0, 1, -11), Vector3d.Zero, 0);
        return new Ball(new Scene { Bodies = bodies });
    }

    private static void Refused(string begins, Action action)
    {
        ArgumentException refusal = Assert.ThrowsAny<ArgumentException>(action);
        Assert.StartsWith(begins, refusal.Message);
    }

    private static void Refused(string begins, Func<object?> action) => Refused(begins, () => { _ = action(); });

    private sealed class Holes : ISurfacePattern
    {
        public double MinimumWidth => 1;

        public IReadOnlyList<SurfaceMaterial> Surfaces { get; } = [SurfaceMaterial.Wood, null!];

        public int At(double x, double z) => -1;
    }
}
