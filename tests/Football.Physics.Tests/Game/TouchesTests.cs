namespace FootballPhysics.Tests.Game;

/// <summary>The ball at a player's feet. football lab matches tells of a thousand of each.</summary>
public sealed class TouchesTests
{
    private static readonly Simulator s_simulator = new();

    [Fact]
    public void A_dribbling_touch_brings_the_ball_where_the_player_is_then()
    {
        var touches = new Touches();
        BallState ball = s_simulator.Launch(new Vector3d(0.3, 0.11, -0.3), new Vector3d(2, 0, 1), new Vector3d(5, 3, 8));
        var request = new DribbleRequest { Direction = new Vector3d(0, 0, -1), RunSpeed = 5 };
        Touch touch = touches.Dribble(in ball, request);
        Assert.Equal(TouchStatus.Done, touch.Status);

        // By the foot itself, in other steps.
        FootStrike strike = touches.Foot.Strike(s_simulator.Scene.Ball, ball.Velocity, ball.Spin, touch.Strike.FootVelocity, touch.Strike.Normal);
        Assert.InRange(Vector3d.Distance(strike.Velocity, touch.Velocity), 0, 1e-9);
        s_simulator.Kick(ref ball, strike.Velocity, strike.Spin);
        s_simulator.Run(ref ball, 1 / 60.0, request.Duration, StopAt.Time, new StepLog());
        Assert.InRange(Vector3d.Distance(ball.Position.Horizontal, new Vector3d(0, 0, -3.1)), 0, touch.Miss + 1e-4);
        Assert.InRange(Math.Abs(ball.Velocity.Length - 5), 0, touch.SpeedError + 1e-3);
        Assert.InRange(touch.Chance, 0.5, 1);
    }

    [Fact]
    public void A_trap_leaves_the_ball_dead_and_one_on_the_run_rolling_with_the_player()
    {
        var touches = new Touches();
        BallState ball = s_simulator.Launch(new Vector3d(0, 0.5, 0), new Vector3d(3, -2, 12), new Vector3d(10, 5, 0));
        foreach (Vector3d player in new[] { default, new Vector3d(0, 0, -4) })
        {
            var request = new TrapRequest { Velocity = player };
            Touch touch = touches.Trap(in ball, request);
            BallState trapped = ball;
            s_simulator.Kick(ref trapped, touch.Velocity, touch.Spin);
            s_simulator.Run(ref trapped, 1 / 60.0, request.Duration, StopAt.Time, new StepLog());
            Assert.True(touch.Succeeds);
            Assert.InRange((trapped.Velocity - player).Horizontal.Length, 0, 0.05);
        }
    }

    [Fact]
    public void A_shot_of_a_moving_ball_hits_and_one_beyond_the_leg_is_slower_or_said_to_be_none()
    {
        var touches = new Touches();
        BallState ball = s_simulator.Launch(new Vector3d(4, 0.6, 16), new Vector3d(-9, 1, 3), new Vector3d(0, 30, 20));
        var request = new FirstTimeRequest { Target = new Vector3d(2, 1.8, 0), Speed = 24, SideSpin = 20 };
        Touch touch = touches.FirstTimeShot(in ball, request);
        Assert.Equal(TouchStatus.Done, touch.Status);
        var path = new Trajectory();
        BallState kicked = ball;
        s_simulator.Kick(ref kicked, touch.Velocity, touch.Spin);
        s_simulator.LookAhead(in kicked, new LookAheadRequest { TimeStep = 1 / 60.0 }, path);
        Assert.InRange((path.ClosestApproach(request.Target).Position - request.Target).Length, 0, 0.01);

        // A slow leg: a slower ball that still hits, or none.
        var weak = new Touches(foot: new Foot { MaximumSpeed = 15 });
        Touch slower = weak.FirstTimeShot(in ball, request);
        Assert.True(slower.Strike.FootVelocity.Length <= 15 + 1e-9);
        Assert.True(slower.Succeeds ? slower.Velocity.Length < 24 : slower.Status is TouchStatus.FootTooSlow or TouchStatus.OutOfReach);
        Assert.Equal(TouchStatus.Degenerate, touches.FirstTimeShot(in ball, request with { Target = ball.Position }).Status);
    }

    [Fact]
    public void The_ball_is_shielded_on_the_far_side_of_the_player()
    {
        var request = new ShieldRequest
        {
            Player = new Player { Position = default },
            Opponents = [new Player { Position = new Vector3d(1.5, 0, 0), Reaction = 0.1 }],
        };
        ShieldResult answer = Touches.Shield(request);
        Assert.True(answer.IsShielded);
        Assert.True(answer.Position.X < -0.4, $"the best place is {answer.Position}");
        Assert.True(answer.MarginAt(new Vector3d(-0.5, 0, 0)) > answer.MarginAt(new Vector3d(0.5, 0, 0)));
        Assert.Equal(3600, Touches.Shield(request with { Opponents = [] }).Margin);

        // Opponents from all sides: less of it is safe.
        Player[] all = [.. Enumerable.Range(0, 6).Select(i => new Player { Position = new Vector3d(1.2 * Math.Cos(i), 0, 1.2 * Math.Sin(i)), Reaction = 0 })];
        Assert.True(Touches.Shield(request with { Opponents = all }).Margin < answer.Margin);
    }

    /// <summary>An opponent behind the player runs along a tangent, an arc of the body and a tangent; one in front runs straight.</summary>
    [Fact]
    public void An_opponent_runs_around_the_body_of_the_player()
    {
        var opponent = new Player { Position = new Vector3d(1.5, 0, 0), Reaction = 0.1 };
        var request = new ShieldRequest { Player = new Player { Reaction = 0.3 }, Opponents = [opponent] };
        ShieldResult answer = Touches.Shield(request);
        double radius = request.BodyRadius;
        double arc = Math.PI - Math.Acos(radius / 1.5) - Math.Acos(radius);
        double around = Math.Sqrt(2.25 - (radius * radius)) + (radius * arc) + Math.Sqrt(1 - (radius * radius));
        foreach ((double x, double way) in new[] { (-1.0, around), (1.0, 0.5) })
        {
            double own = new RunnerMotion(request.Player.Reacting(0), request.Time).ArrivalAt(1);
            Assert.Equal(new RunnerMotion(in opponent, request.Time).ArrivalAt(way) - own, answer.MarginAt(new Vector3d(x, 0, 0)), 1e-9);
        }
    }

    [Fact]
    public void Numbers_out_of_range_are_refused_by_name()
    {
        var touches = new Touches();
        BallState ball = s_simulator.Launch(default, default, default);
        Assert.StartsWith("dribble.runSpeed", Assert.Throws<ArgumentOutOfRangeException>(() => touches.Dribble(in ball, new DribbleRequest { RunSpeed = 99 })).Message, StringComparison.Ordinal);
        Assert.StartsWith("dribble.direction", Assert.Throws<ArgumentOutOfRangeException>(() => touches.Dribble(in ball, new DribbleRequest { Direction = Vector3d.Up })).Message, StringComparison.Ordinal);
        Assert.StartsWith("trap.tolerance", Assert.Throws<ArgumentOutOfRangeException>(() => touches.Trap(in ball, new TrapRequest { Tolerance = 0 })).Message, StringComparison.Ordinal);
        Assert.StartsWith("firstTime.target", Assert.Throws<ArgumentOutOfRangeException>(() => touches.FirstTimeShot(in ball, new FirstTimeRequest())).Message, StringComparison.Ordinal);
        Assert.StartsWith("spread.draws", Assert.Throws<ArgumentOutOfRangeException>(() => new Touches(spread: new TouchSpread { Draws = -1 })).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => touches.Trap(default, new TrapRequest()));
    }
}
