using System.Runtime.InteropServices;
using FsCheck;
using FsCheck.Fluent;

namespace FootballPhysics.Tests.Game;

public sealed class FixedStepRunnerTests
{
    private static readonly Vector3d s_velocity = new(4, 9, -24);
    private static readonly Vector3d s_spin = new(12, 45, 3);

    [Fact]
    public void Irregular_frames_give_the_bits_and_events_of_regular_ones()
    {
        const int Ticks = 240;
        var matches =
            from simulator in Inputs.Simulators
            from kicks in Inputs.Kicks(Ticks)
            from frames in Gen.Choose(0, 120_000).Select(us => us * 1e-6).ListOf(200)
            select (simulator, kicks, frames);
        Prop.ForAll(matches.ToArbitrary(), match =>
        {
            FixedStepRunner regular = Inputs.Runner(match.simulator, match.kicks);
            var expected = new List<BallEvent>();
            var states = new List<BallState> { regular.State };
            FixedStepRunner irregular = Inputs.Runner(match.simulator, match.kicks);
            var seen = new List<BallEvent>();
            foreach (double frame in match.frames)
            {
                irregular.Advance(frame);
                seen.AddRange(irregular.Events.Span.ToArray());
                while (regular.Tick < irregular.Tick)
                {
                    regular.Step();
                    expected.AddRange(regular.Events.Span.ToArray());
                }

                Assert.True(Snapshot.Same(regular.State, irregular.State));
            }

            Assert.True(MemoryMarshal.AsBytes<BallEvent>(expected.ToArray()).SequenceEqual(MemoryMarshal.AsBytes<BallEvent>(seen.ToArray())));
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void It_makes_the_steps_that_the_time_asks_for_and_keeps_the_rest()
    {
        var runner = new FixedStepRunner(timeStep: 0.01);
        Assert.Equal(0, runner.Advance(0.004));
        Assert.Equal(0.4, runner.Fraction, 1e-12);
        Assert.Equal(1, runner.Advance(0.008));
        Assert.Equal(0.2, runner.Fraction, 1e-12);
        Assert.Equal(10, runner.Advance(0.1));
        Assert.Equal(11, runner.Tick);
        Assert.Equal(0, runner.Advance(0));
        Assert.Equal(0, runner.DroppedTime);
    }

    [Fact]
    public void A_frame_as_long_as_a_step_makes_that_step_at_once()
    {
        var runner = new FixedStepRunner(timeStep: 1.0 / 60.0);
        for (int frame = 0; frame < 120; frame++)
        {
            Assert.Equal(1, runner.Advance(runner.TimeStep));
            Assert.Equal(0, runner.Fraction);
        }
    }

    [Fact]
    public void A_hitch_is_cut_short_and_reported()
    {
        var runner = new FixedStepRunner(timeStep: 0.01, maximumFrameTime: 0.105);
        Assert.Equal(10, runner.Advance(3));
        Assert.Equal(2.895, runner.DroppedTime, 1e-12);
        Assert.Equal(0.5, runner.Fraction, 1e-9);
        runner.Advance(0.01);
        Assert.Equal(0, runner.DroppedTime);
        runner.Advance(double.MaxValue);
        Assert.Equal(double.MaxValue, runner.TotalDroppedTime);
    }

    [Theory]
    [InlineData(-1e-9)]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    public void A_frame_time_that_is_none_is_refused_and_changes_nothing(double frameTime)
    {
        var runner = new FixedStepRunner();
        runner.QueueKick(s_velocity, s_spin);
        runner.Advance(0.255);
        BallState before = runner.State;
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.Advance(frameTime));
        Assert.True(Snapshot.Same(before, runner.State));
        Assert.Equal(0.005, runner.DroppedTime, 1e-12);
    }

    [Theory]
    [InlineData(0, 0.25)]
    [InlineData(double.NaN, 0.25)]
    [InlineData(0.01, 0)]
    [InlineData(0.01, double.PositiveInfinity)]
    [InlineData(0.5, 0.25)]
    public void Settings_out_of_range_are_refused(double timeStep, double maximumFrameTime) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new FixedStepRunner(timeStep, maximumFrameTime));

    [Fact]
    public void Stepping_and_drawing_allocate_nothing()
    {
        var runner = new FixedStepRunner(timeStep: 0.01);
        double sum = 0;
        Assert.Equal(0, Allocation.Of(() => sum = Play(runner, 300)));
        Assert.True(double.IsFinite(sum));

        static double Play(FixedStepRunner runner, int frames)
        {
            double sum = 0;
            for (int frame = 0; frame < frames; frame++)
            {
                if (frame == 10)
                {
                    runner.QueueKick(20, new Vector3d(0, 0.4, -1), topSpin: -20, sideSpin: 30);
                }

                runner.Advance(frame % 3 == 0 ? 0.03 : 0.007);
                sum += runner.Position.X + runner.Orientation.W + Snapshot.Hash(runner.State);
            }

            return sum;
        }
    }

    [Fact]
    public void The_ends_of_a_step_are_drawn_as_they_are()
    {
        var runner = new FixedStepRunner(timeStep: 0.02);
        runner.QueueKick(s_velocity, s_spin);
        BallState[] states = Inputs.Play(runner, 30);
        Assert.Equal(states[30].Position, runner.PoseAt(1).Position);
        Assert.Equal(states[30].Orientation, runner.PoseAt(1).Orientation);
        Assert.Equal(states[29].Position, runner.PoseAt(0).Position);
        AssertSameRotation(states[29].Orientation, runner.PoseAt(-1).Orientation, 1e-15);
        Assert.Equal(runner.PoseAt(1).Position, runner.PoseAt(7).Position);
    }

    [Fact]
    public void Between_steps_the_ball_is_drawn_within_the_sagitta_of_its_path()
    {
        var coarse = new FixedStepRunner(timeStep: 0.02);
        var fine = new FixedStepRunner(timeStep: 0.0025);
        coarse.QueueKick(s_velocity, s_spin);
        fine.QueueKick(s_velocity, s_spin);
        for (int tick = 0; tick < 100; tick++)
        {
            coarse.Step();
            for (int part = 1; part < 8; part++)
            {
                fine.Step();
                BallPose pose = coarse.PoseAt(part / 8.0);
                Assert.InRange(Vector3d.Distance(pose.Position, fine.State.Position), 0, 2.5e-3);
                if (coarse.Events.Count == 0)
                {
                    AssertSameRotation(fine.State.Orientation, pose.Orientation, 1e-4);
                }
            }

            fine.Step();
        }
    }

    [Fact]
    public void A_bounce_inside_a_step_is_drawn_down_to_the_ground()
    {
        var runner = new FixedStepRunner(timeStep: 0.05);
        runner.Restore(0, runner.Simulator.Launch(new Vector3d(0, 2, 0), new Vector3d(3, 0, 0), Vector3d.Zero));
        while (runner.Events.Count == 0)
        {
            runner.Step();
        }

        BallEvent impact = runner.Events[0];
        double start = runner.State.Time - runner.TimeStep;
        BallPose pose = runner.PoseAt((impact.Time - start) / runner.TimeStep);
        Assert.Equal(runner.Simulator.ContactHeight, pose.Position.Y, 1e-9);
        Assert.Equal(impact.Position.X, pose.Position.X, 1e-9);
    }

    [Fact]
    public void Restoring_draws_the_ball_where_it_is_put()
    {
        var runner = new FixedStepRunner();
        runner.QueueKick(s_velocity, s_spin);
        runner.Advance(0.105);
        var place = new Vector3d(7, 0.11, -3);
        runner.Restore(0, runner.Simulator.Launch(place, Vector3d.Zero, Vector3d.Zero));
        Assert.Equal(place, runner.PoseAt(0.3).Position);
        Assert.Equal(0, runner.Tick);
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.Restore(-1, runner.State));
    }

    [Fact]
    public void A_runner_of_several_balls_names_what_one_ball_cannot_do()
    {
        var simulator = new Simulator();
        var runner = new FixedStepRunner(new BallGroup(simulator, 2));
        Assert.Contains("RestoreAll", Assert.Throws<ArgumentException>(() => runner.Restore(0, simulator.Launch(Vector3d.Up, Vector3d.Up, Vector3d.Zero))).Message, StringComparison.Ordinal);
        Assert.Equal("ball", Assert.Throws<ArgumentOutOfRangeException>(() => runner.PoseAt(0.5, 2)).ParamName);
        Assert.Equal(runner.States[1].Position, runner.PoseAt(0.5, 1).Position);
    }

    /// <summary>Only a rollback keeps the motions of a fixed number of bodies.</summary>
    [Fact]
    public void A_scene_with_more_bodies_is_refused_with_a_rollback_only()
    {
        var box = new Obstacle { Name = "box", Shape = new BoxShape(new Vector3d(5, 0.3, 0), new Vector3d(0.3, 0.3, 0.3)), Mass = 4 };
        var other = new Simulator(new Scene { Obstacles = [box] });
        var alone = new FixedStepRunner { Simulator = other };
        Assert.Same(other, alone.Simulator);
        var kept = new FixedStepRunner();
        _ = new Rollback(kept);
        Assert.Throws<InvalidOperationException>(() => kept.Simulator = other);
        var windy = new Simulator(Scene.Windy(new Vector3d(3, 0, 0)));
        kept.Simulator = windy;
        Assert.Same(windy, kept.Simulator);
    }

    [Fact]
    public void Angles_of_a_kick_are_those_of_its_velocity()
    {
        var ball = new Ball();
        ball.Kick(20, elevationDegrees: 30, azimuthDegrees: 90, topSpin: 8, sideSpin: -5);

        // 90° to the left of −z is −x. Topspin turns about the horizontal axis to the left of the kick: +z.
        Assert.Equal(0, (ball.Velocity - new Vector3d(-20 * Math.Sqrt(0.75), 10, 0)).Length, 1e-13);
        Assert.Equal(0, (ball.Spin - new Vector3d(0, -5, 8)).Length, 1e-13);
    }

    [Fact]
    public void A_kick_in_numbers_is_the_ball_s_own()
    {
        var runner = new FixedStepRunner();
        var ball = new Ball(runner.Simulator);
        runner.QueueKick(25, new Vector3d(1, 3, -5), topSpin: -12, sideSpin: 40);
        ball.Kick(25, new Vector3d(1, 3, -5), topSpin: -12, sideSpin: 40);
        runner.Step();
        ball.Step(runner.TimeStep);
        Assert.True(Snapshot.Same(ball.State, runner.State));
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.QueueKick(-1, new Vector3d(1, 0, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.QueueKick(1, Vector3d.Zero));
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.QueueKick(new Vector3d(2000, 0, 0), Vector3d.Zero));
    }

    [Fact]
    public void Scheduled_kicks_wait_for_their_tick()
    {
        var runner = new FixedStepRunner();
        runner.Kicks.Add(new KickInput(5, s_velocity, s_spin));
        Inputs.Play(runner, 5);
        Assert.Equal(MotionState.Rest, runner.State.Motion);
        runner.Step();
        Assert.Equal(MotionState.Airborne, runner.State.Motion);
    }

    internal static void AssertSameRotation(Quaterniond expected, Quaterniond actual, double tolerance)
    {
        double cosine = (expected.X * actual.X) + (expected.Y * actual.Y) + (expected.Z * actual.Z) + (expected.W * actual.W);
        double sign = cosine < 0 ? -1 : 1;
        double square = Square(expected.X - (sign * actual.X)) + Square(expected.Y - (sign * actual.Y))
            + Square(expected.Z - (sign * actual.Z)) + Square(expected.W - (sign * actual.W));
        Assert.InRange(Math.Sqrt(square), 0, tolerance);
    }

    private static double Square(double x) => x * x;
}
