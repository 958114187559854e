using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Predictors;

/// <summary>When a player can reach a ball whose motion is known in closed form.</summary>
public sealed class InterceptWindowTests
{
    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) };

    /// <summary>The ball starts beside him and leaves his reach before the first segment ends.</summary>
    [Theory]
    [InlineData(0.1, 0)]
    [InlineData(0.1, 0.09)]
    [InlineData(0.3, 0)]
    public void A_ball_that_leaves_at_once_was_within_reach_until_then(double reach, double from)
    {
        Trajectory path = Path(Straight(0, 1, new Vector3d(from, 1, 0), new Vector3d(20, 0, 0)));
        var query = new FootballPhysics.Prediction.Interception();
        query.Find(path, [new Player { Reaction = 10, Reach = reach }]);
        InterceptWindow window = Assert.Single(query.Windows.ToArray());
        Assert.Equal(0, window.From);
        Assert.Equal((reach - from) / 20, window.To, 1e-9);
    }

    /// <summary>Something carries the ball off between two segments: from then on he cannot reach it.</summary>
    [Fact]
    public void A_ball_that_is_carried_off_is_out_of_reach_from_then_on()
    {
        Trajectory path = Path(
            Straight(0, 0.5, new Vector3d(0.2, 1, 0), Vector3d.Zero),
            Straight(0.5, 0.5, new Vector3d(90, 1, 0), new Vector3d(1, 0, 0)));
        var query = new FootballPhysics.Prediction.Interception();
        query.Find(path, [new Player { Reaction = 10 }]);
        Assert.Equal([(0, 0.5)], query.Windows.ToArray().Select(window => (window.From, window.To)));
    }

    /// <summary>It leaves his reach sideways at the very time at which it comes up to his height.</summary>
    [Theory]
    [InlineData(1e-8)]
    [InlineData(1e-9)]
    [InlineData(1e-5)]
    public void A_ball_that_leaves_his_reach_as_it_comes_up_to_his_height_is_never_met(double later)
    {
        const double Time = 0.437;
        var velocity = new Vector3d(10, 5, 0);
        Trajectory path = Path(Straight(0, 1, new Vector3d(0, 1, 0), velocity));
        var player = new Player { Reaction = 10, Reach = Time * velocity.X, MinimumHeight = 1 + ((Time + later) * velocity.Y) + 1e-8, MaximumHeight = 9 };
        var query = new FootballPhysics.Prediction.Interception();
        query.Find(path, [player]);
        Assert.Empty(query.Windows.ToArray());
        Assert.Equal(-1, query.FindFirst(path, [player], out _));
    }

    /// <summary>Between the two, it is met for that long.</summary>
    [Fact]
    public void A_ball_that_comes_up_to_his_height_before_it_leaves_is_met_in_between()
    {
        const double Time = 0.437;
        const double Sooner = 1e-5;
        var velocity = new Vector3d(10, 5, 0);
        Trajectory path = Path(Straight(0, 1, new Vector3d(0, 1, 0), velocity));
        var player = new Player { Reaction = 10, Reach = Time * velocity.X, MinimumHeight = 1 + ((Time - Sooner) * velocity.Y), MaximumHeight = 9 };
        var query = new FootballPhysics.Prediction.Interception();
        query.Find(path, [player]);
        InterceptWindow window = Assert.Single(query.Windows.ToArray());
        Assert.Equal(Time - Sooner, window.From, 1e-9);
        Assert.Equal(Time, window.To, 1e-9);
    }

    /// <summary>At its apex the ball is at his greatest height, and never above: there is no gap.</summary>
    [Fact]
    public void A_ball_that_rises_just_to_his_height_stays_within_reach()
    {
        // y = 10 − 500 (t − 0.3)², with the apex 1e-13 m below the limit.
        const double Apex = 0.3;
        var start = new Vector3d(0, 10 - (500 * Apex * Apex), 0);
        var velocity = new Vector3d(0, 1000 * Apex, 0);
        var gravity = new Vector3d(0, -1000, 0);
        var piece = new PathSegment(
            0, 1, in start, in velocity, in gravity, start + velocity + (0.5 * gravity), velocity + gravity, in gravity, MotionState.Airborne, 2);
        var player = new Player { Reaction = 10, MinimumHeight = -1000, MaximumHeight = 10 + 1e-13 - 1e-9 };
        var query = new FootballPhysics.Prediction.Interception();
        query.Find(Path(piece), [player]);
        Assert.Equal([(0, 1)], query.Windows.ToArray().Select(window => (window.From, window.To)));
    }

    /// <summary>The limits of height belong to his range.</summary>
    [Fact]
    public void A_ball_that_lies_at_the_limit_of_his_height_is_met()
    {
        var player = new Player { MinimumHeight = 0.5, MaximumHeight = 2 };
        var motion = new RunnerMotion(in player, 0);
        var query = new FootballPhysics.Prediction.Interception();
        foreach (double height in new[] { motion.Lowest, motion.Highest })
        {
            query.Find(Path(Straight(0, 1, new Vector3d(0.2, height, 0), Vector3d.Zero)), [player]);
            Assert.Equal([(0, 1)], query.Windows.ToArray().Select(window => (window.From, window.To)));
        }
    }

    /// <summary>He stands on the goal line, and the ball crosses it at a distance L: he must react D⁻¹(L − reach) before that.</summary>
    [Fact]
    public void The_latest_reaction_of_a_keeper_on_his_line_is_exact()
    {
        var random = new Shots(91);
        var query = new FootballPhysics.Prediction.Interception();
        for (int i = 0; i < 20; i++)
        {
            double speed = random.Uniform(15, 30);
            double aside = random.Uniform(1.5, 3.5);
            Trajectory path = Path(Straight(0, 22 / speed, new Vector3d(aside, 1, 0), new Vector3d(0, 0, -speed)));
            var keeper = new Player { Position = s_goal.Center, Reach = 1, Acceleration = random.Uniform(12, 20), Speed = random.Uniform(5, 9), Reaction = 0.01, MaximumHeight = 2.7 };
            KeeperResult result = query.FindSave(path, in keeper, s_goal);
            double run = aside - keeper.Reach;
            double ramp = keeper.Speed * keeper.Speed / (2 * keeper.Acceleration);
            double needed = run <= ramp ? Math.Sqrt(2 * run / keeper.Acceleration) : (keeper.Speed / keeper.Acceleration) + ((run - ramp) / keeper.Speed);
            Assert.True(result.Crosses && result.IsOnTarget && result.Saves);
            Assert.Equal(20 / speed, result.Crossing.Time, 1e-9);
            Assert.Equal((20 / speed) - needed, result.LatestReaction, 5e-9);
            Assert.Contains("on target, saved", result.ToString(), StringComparison.Ordinal);
        }
    }

    [Fact]
    public void A_shot_that_passes_wide_of_the_goal_and_of_the_keeper_is_told_so()
    {
        Trajectory path = Path(Straight(0, 1, new Vector3d(9, 1, 0), new Vector3d(0, 0, -25)));
        var keeper = new Player { Position = s_goal.Center };
        KeeperResult result = new FootballPhysics.Prediction.Interception().FindSave(path, in keeper, s_goal);
        Assert.Equal((true, false, false), (result.Crosses, result.IsOnTarget, result.Saves));
        Assert.Contains("after 0.8 s, off target, not saved", result.ToString(), StringComparison.Ordinal);
        KeeperResult away = new FootballPhysics.Prediction.Interception().FindSave(Path(Straight(0, 1, new Vector3d(9, 1, 0), new Vector3d(0, 0, 5))), in keeper, s_goal);
        Assert.Equal((false, "no shot at the goal"), (away.Crosses, away.ToString()));
    }

    [Fact]
    public void A_reaction_before_the_start_is_refused()
    {
        var query = new FootballPhysics.Prediction.Interception();
        Trajectory path = Path(Straight(0, 1, new Vector3d(0, 1, 0), Vector3d.Zero));
        ArgumentOutOfRangeException refusal = Assert.Throws<ArgumentOutOfRangeException>(() => query.Find(path, [new Player { Reaction = -0.1 }]));
        Assert.Contains("runner.reaction", refusal.Message, StringComparison.Ordinal);
    }

    /// <summary>He runs beside the ball, a nanometre too far away, until he reacts.</summary>
    [Fact]
    public void A_search_along_the_rim_of_his_reach_ends_with_a_reaction_that_succeeds()
    {
        var velocity = new Vector3d(0, 0, -5);
        var keeper = new Player { Velocity = velocity, Reach = 1, Reaction = 0.2 };
        Trajectory path = Path(Straight(0, 9.9, new Vector3d(1 + 1e-9, 1, 0), velocity));
        var query = new FootballPhysics.Prediction.Interception();
        KeeperResult result = query.FindSave(path, in keeper, s_goal with { Center = new Vector3d(0, 0, -60) });
        Assert.True(result.Saves);
        Assert.InRange(result.LatestReaction, 0.2, 9.9);
        Assert.Equal(0, query.FindFirst(path, [keeper with { Reaction = result.LatestReaction }], out _));
    }

    private static PathSegment Straight(double time, double length, Vector3d from, Vector3d velocity) => new(
        time, length, in from, in velocity, default, from + (length * velocity), in velocity, default, MotionState.Airborne, 5);

    /// <summary>A path of these segments.</summary>
    private static Trajectory Path(params PathSegment[] pieces)
    {
        var simulator = new Simulator(Scene.Vacuum);
        BallState state = simulator.Launch(pieces[0].PositionAt(pieces[0].Time), new Vector3d(0, 0, 1), Vector3d.Zero);
        var path = new Trajectory(pieces.Length + 1);
        path.Begin(simulator, in state, new LookAheadRequest(), endsWhenFull: true);
        foreach (PathSegment piece in pieces)
        {
            path.Log.Observer!.Add(in piece);
        }

        state.Time = pieces[^1].EndTime;
        state.Position = pieces[^1].PositionAt(state.Time);
        path.End(in state);
        return path;
    }
}
