using System.Numerics;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Api;

/// <summary>The front for games: kick, step, read.</summary>
public sealed class BallTests
{
    private static readonly Vector3d s_goalwards = new(0, 0.3, -1);

    [Fact]
    public void A_new_ball_lies_at_the_origin_on_the_ground()
    {
        var ball = new Ball(Scene.Published with { Ground = Ground.PublishedTurf with { Height = 2 } });
        Assert.Equal(new Vector3d(0, 2.11, 0), ball.Position);
        Assert.Equal(Vector3.Zero, ball.Velocity);
        Assert.Equal(Vector3.Zero, ball.Spin);
        Assert.Equal(Quaternion.Identity, ball.Orientation);
        Assert.Equal(0, ball.Time);
        Assert.Equal(0, ball.Events.Count);
        ball.Step(0.1);
        Assert.Equal(MotionState.Rest, ball.Motion);
        Assert.Equal(0, ball.Events.Count);
        ball.Step(0.1);
        Assert.Equal(0, ball.Events.Count);
    }

    /// <summary>A launch is a place and a kick at once; the ball's own look-ahead and names are its simulator's.</summary>
    [Fact]
    public void A_ball_answers_for_its_scene()
    {
        Scene scene = Scene.Default with { Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(0, 0, -8), new Vector3d(0, 0, 1)) }] };
        var ball = new Ball(scene);
        ball.Step(0.5);
        ball.Launch(new Vector3d(1, 2, 3), new Vector3d(0, 4, -20), new Vector3d(5, 30, 0));
        Assert.Equal(0, ball.Time);
        Assert.Equal(ball.Simulator.Launch(new Vector3d(1, 2, 3), new Vector3d(0, 4, -20), new Vector3d(5, 30, 0)), ball.State);
        var path = new Trajectory();
        var same = new Trajectory();
        ball.LookAhead(new LookAheadRequest { Duration = 1 }, path);
        ball.Simulator.LookAhead(ball.State, new LookAheadRequest { Duration = 1 }, same);
        Assert.Equal(same.Final, path.Final);
        Assert.True(path.EndTime > 0.9);
        ball.Step(1.0);
        BallEvent hit = Assert.Single(ball.Events.Span.ToArray(), happened => happened.ColliderIndex == 1);
        Assert.Equal("wall", ball.NameOf(hit));
        Assert.Null(ball.NameOf(new BallEvent(BallEventKind.Rest, -1, default, 0, default, default, default, default, default)));
        Assert.Contains("launch.velocity", Assert.Throws<ArgumentOutOfRangeException>(() => ball.Launch(default, new Vector3d(2000, 0, 0), default)).Message, StringComparison.Ordinal);
        Assert.True(ball.Time > 0);
        Assert.Throws<ArgumentNullException>(() => ball.LookAhead(null!, path));
    }

    [Fact]
    public void Side_spin_bends_to_the_left_when_positive_and_to_the_right_when_negative()
    {
        Assert.True(Land(0, 40).X < -1);
        Assert.True(Land(0, -40).X > 1);
        Assert.Equal(Land(0, 40).X, -Land(0, -40).X);
        Assert.Equal(0, Land(0, 0).X);
    }

    [Fact]
    public void Top_spin_dips_and_back_spin_lifts()
    {
        double Time(double top) => Land(top, 0).Y;
        Assert.True(Time(40) < Time(0.01) - 0.1);
        Assert.True(Time(-40) > Time(0.01) + 0.1);
    }

    [Fact]
    public void Top_spin_turns_the_ball_the_way_it_would_roll()
    {
        var ball = new Ball();
        ball.Kick(10, new Vector3d(0, 0, -3), topSpin: 10 / 0.11);

        // Rolling to −z is a turn about −x; the ball rolls from the first instant.
        Assert.Equal(-10 / 0.11, ball.State.Spin.X, 1e-9);
        Assert.Equal(MotionState.Rolling, ball.Motion);
    }

    [Theory]
    [InlineData(0, 0, -1)]
    [InlineData(3, 5, 4)]
    [InlineData(-2, -1, 0.5)]
    public void The_spin_of_a_kick_is_top_about_the_axis_across_and_side_about_the_vertical(double x, double y, double z)
    {
        var direction = new Vector3d(x, y, z);
        Vector3d flat = direction.Horizontal / direction.Horizontal.Length;
        Vector3d expected = (7 * Vector3d.Cross(Vector3d.Up, flat)) + (-4 * Vector3d.Up);
        Assert.Equal(0, Vector3d.Distance(expected, KickVectors.Spin(direction, 7, -4)), 1e-14);
    }

    [Fact]
    public void A_kick_by_speed_and_direction_is_the_kick_by_vectors()
    {
        var a = new Ball();
        var b = new Ball();
        Vector3d unit = s_goalwards / s_goalwards.Length;
        a.Kick(22, 5 * s_goalwards, 12, -8);
        b.Kick(22 * unit, KickVectors.Spin(s_goalwards, 12, -8));
        Assert.Equal(0, Vector3d.Distance(a.State.Velocity, b.State.Velocity), 1e-13);
        Assert.Equal(0, Vector3d.Distance(a.State.Spin, b.State.Spin), 1e-13);
        Assert.Equal(22, a.State.Velocity.Length, 1e-13);
    }

    [Fact]
    public void A_vertical_kick_takes_side_spin_but_no_top_spin()
    {
        var ball = new Ball();
        ball.Kick(5, Vector3d.Up, 0, 12);
        Assert.Equal(new Vector3d(0, 12, 0), ball.State.Spin);
        BallState before = ball.State;
        ArgumentOutOfRangeException error = Assert.Throws<ArgumentOutOfRangeException>(() => ball.Kick(5, Vector3d.Up, 1));
        Assert.Contains("direction", error.Message, StringComparison.Ordinal);
        Assert.Equal(before, ball.State);
    }

    [Fact]
    public void A_kick_keeps_place_time_and_orientation()
    {
        var ball = new Ball();
        ball.Kick(20, s_goalwards, 5, 5);
        ball.Step(0.5);
        BallState before = ball.State;
        ball.Kick(new Vector3(1, 2, 3), new Vector3(4, 5, 6));
        Assert.Equal(before.Position, ball.State.Position);
        Assert.Equal(before.Time, ball.State.Time);
        Assert.InRange(Differences.Rotation(before.Orientation, ball.State.Orientation), 0, 1e-15);
        Assert.Equal(new Vector3(1, 2, 3), ball.Velocity);
        Assert.Equal(0, Vector3d.Distance(new Vector3d(4, 5, 6), ball.State.Spin), 1e-14);
    }

    [Fact]
    public void Placing_a_ball_stops_it_and_starts_its_clock_again()
    {
        var ball = new Ball();
        ball.Kick(20, s_goalwards, 5, 5);
        ball.Step(3.0);
        Assert.NotEqual(0, ball.Events.Count);
        ball.Place(new Vector3(1, 4, 2));
        Assert.Equal(0, ball.Time);
        Assert.Equal(0, ball.Events.Count);
        Assert.Equal(Vector3.Zero, ball.Velocity);
        ball.Step(0.1);
        Assert.True(ball.Velocity.Y < -0.9);
    }

    [Fact]
    public void Events_are_those_of_the_last_step_only()
    {
        var ball = new Ball();
        ball.Place(new Vector3d(0, 1, 0));
        int impacts = 0;
        for (int i = 0; i < 300; i++)
        {
            double start = ball.Time;
            ball.Step(0.02);
            foreach (ref readonly BallEvent item in ball.Events)
            {
                Assert.InRange(item.Time, start, ball.Time);
                impacts += item.Kind == BallEventKind.Impact ? 1 : 0;
            }
        }

        var log = new StepLog();
        BallState state = ball.Simulator.Launch(new Vector3d(0, 1, 0), Vector3d.Zero, Vector3d.Zero);
        ball.Simulator.Run(ref state, 0.02, 6, StopAt.Time, log);
        Assert.Equal(log.Events.Span.ToArray().Count(item => item.Kind == BallEventKind.Impact), impacts);
        Assert.True(impacts > 3);
    }

    [Fact]
    public void A_step_of_no_time_changes_nothing()
    {
        foreach (Ball ball in new[] { Flying(), Sliding() })
        {
            BallState before = ball.State;
            ball.Step(0.0);
            Assert.Equal(before, ball.State);
            Assert.Equal(0, ball.Events.Count);
        }
    }

    [Theory]
    [InlineData(double.Epsilon)]
    [InlineData(1e-300)]
    [InlineData(1e-18)]
    public void A_step_of_hardly_any_time_changes_hardly_anything(double dt)
    {
        foreach (Ball ball in new[] { Flying(), Sliding() })
        {
            BallState before = ball.State;
            ball.Step(dt);
            Assert.InRange(Vector3d.Distance(before.Position, ball.State.Position), 0, 1e-15);
            Assert.InRange(Vector3d.Distance(before.Velocity, ball.State.Velocity), 0, 1e-14);
            Assert.True(ball.State.Spin.IsFinite && ball.State.Orientation.IsFinite);
        }
    }

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(-1e-9)]
    [InlineData(double.PositiveInfinity)]
    [InlineData(double.NegativeInfinity)]
    public void A_step_that_is_no_time_is_refused_and_changes_nothing(double dt)
    {
        Ball ball = Flying();
        BallState before = ball.State;
        ArgumentOutOfRangeException error = Assert.Throws<ArgumentOutOfRangeException>(() => ball.Step(dt));
        Assert.StartsWith("dt is ", error.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => ball.Simulator.Step(ref before, dt, new StepLog()));
        Assert.Equal(before, ball.State);
    }

    [Fact]
    public void A_hitch_of_five_seconds_loses_no_event()
    {
        Ball hitch = Flying();
        Ball smooth = Flying();
        hitch.Step(5.0);
        var kinds = new List<BallEventKind>();
        for (int i = 0; i < 500; i++)
        {
            smooth.Step(0.01);
            foreach (ref readonly BallEvent item in smooth.Events)
            {
                kinds.Add(item.Kind);
            }
        }

        Assert.Equal(kinds, hitch.Events.Span.ToArray().Select(item => item.Kind));
        Assert.True(kinds.Count > 3);
        Assert.Equal(smooth.Time, hitch.Time, 1e-9);
        Assert.InRange(Vector3d.Distance(smooth.Position, hitch.Position), 0, 0.5);
    }

    [Fact]
    public void A_refused_kick_or_place_changes_nothing()
    {
        Ball ball = Flying();
        BallState before = ball.State;
        Refused("launch.velocity", () => ball.Kick(new Vector3d(1001, 0, 0), Vector3d.Zero));
        Refused("launch.velocity", () => ball.Kick(new Vector3d(double.NaN, 0, 0), Vector3d.Zero));
        Refused("launch.spin", () => ball.Kick(Vector3d.Up, new Vector3d(0, 10_001, 0)));
        Refused("speed", () => ball.Kick(-1, s_goalwards));
        Refused("speed", () => ball.Kick(double.NaN, s_goalwards));
        Refused("direction", () => ball.Kick(10, Vector3d.Zero));
        Refused("direction", () => ball.Kick(10, new Vector3d(double.PositiveInfinity, 0, 0)));
        Refused("topSpin", () => ball.Kick(10, s_goalwards, double.NaN));
        Refused("sideSpin", () => ball.Kick(10, s_goalwards, 0, 10_001));
        Refused("launch.position", () => ball.Place(new Vector3d(0, double.NegativeInfinity, 0)));
        Assert.Equal(before, ball.State);
    }

    [Fact]
    public void A_ball_needs_a_simulator() => Assert.Throws<ArgumentNullException>(() => new Ball((Simulator)null!));

    private static void Refused(string field, Action action) =>
        Assert.StartsWith($"{field} is ", Assert.Throws<ArgumentOutOfRangeException>(action).Message, StringComparison.Ordinal);

    private static Ball Flying()
    {
        var ball = new Ball();
        ball.Kick(15, s_goalwards, -20, 30);
        ball.Step(0.1);
        return ball;
    }

    private static Ball Sliding()
    {
        var ball = new Ball();
        ball.Kick(10, new Vector3d(1, 0, 0));
        ball.Step(0.01);
        Assert.Equal(MotionState.Sliding, ball.Motion);
        return ball;
    }

    /// <summary>Where a free kick to −z lands (x, z) and when (in place of the height).</summary>
    private static Vector3d Land(double top, double side)
    {
        var ball = new Ball();
        ball.Kick(25, s_goalwards, top, side);
        BallState state = ball.State;
        ball.Simulator.Run(ref state, 0.01, 10, StopAt.Impact, new StepLog());
        Assert.True(state.Position.Z < -15);
        return new Vector3d(state.Position.X, state.Time, state.Position.Z);
    }
}
