using FootballPhysics.Aiming;
using FootballPhysics.Labs.Goals;
using FootballPhysics.Prediction;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Things;

/// <summary>What is reported to be a goal, and what is not.</summary>
public sealed class GoalTests
{
    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) };
    private static readonly Scene s_scene = Scene.Default with { Goals = [s_goal] };

    [Fact]
    public void All_shots_that_go_in_are_told_and_nothing_else()
    {
        var count = new GoalCount();
        for (int i = 0; i < 3000; i++)
        {
            Assert.True(count.Add(new SeededRandom(SeededRandom.Mix(11, i))), $"shot {i}");
        }

        LabCounts counts = count.Counts;
        Assert.Equal((0, 0, 0, 0), (counts[GoalCount.LieInUnreported], counts[GoalCount.Missed], counts[GoalCount.Wrong], counts[GoalCount.Cut]));
        Assert.InRange(counts[GoalCount.Undecided], 0, 2);
        Assert.True(counts[GoalCount.Reported] > 1000 && counts[GoalCount.Rebounds] > 150 && counts[GoalCount.Carried] > 150 && counts[GoalCount.LieIn] > 800);
    }

    [Theory]
    [InlineData(3.02, 0.8, 8, 1, -16)]
    [InlineData(-3.02, 0.8, -8, 1, -16)]
    [InlineData(0, 1.85, 0, 5.5, -12)]
    public void Into_the_side_net_or_under_the_roof_it_is_in(double x, double y, double vx, double vy, double vz)
    {
        // At the plane on which it counts, it is beside the opening, or above it.
        BallEvent reported = Assert.Single(Goals(new Vector3d(x, y, -19), new Vector3d(vx, vy, vz)));
        Assert.Equal(-20 - s_goal.PostRadius - s_scene.Ball.Radius, reported.Position.Z, 1e-9);
        Assert.True(Math.Abs(reported.Position.X) > 3.55 || reported.Position.Y > 2.33);
    }

    [Theory]
    [InlineData(3.9, 0.8, 0, 1, -16)]
    [InlineData(0, 2.75, 0, 1, -12)]
    public void Past_it_and_over_it_is_no_goal(double x, double y, double vx, double vy, double vz) =>
        Assert.Empty(Goals(new Vector3d(x, y, -19), new Vector3d(vx, vy, vz)));

    /// <summary>Over the bar, against what the side net has behind the back net, and back against that from behind.</summary>
    [Fact]
    public void A_ball_that_lies_against_the_back_net_from_behind_is_not_in()
    {
        var count = new GoalCount();
        Assert.True(count.Add(new SeededRandom(SeededRandom.Mix(77, 5390))));
        Assert.Equal((0, 0), (count.Counts[GoalCount.LieIn], count.Counts[GoalCount.Reported]));
    }

    [Fact]
    public void A_ball_that_was_not_wholly_over_and_comes_back_is_none()
    {
        // Up a slope: it turns with its centre through the mouth, and rolls back out.
        Scene slope = s_scene with { Ground = s_scene.Ground with { Normal = new Vector3d(0, 1, 0.3) } };
        Goal goal = s_goal with { Center = new Vector3d(0, 0, 0), HasNet = false };
        var simulator = new Simulator(slope with { Goals = [goal] });
        int entered = 0;
        int reported = 0;
        for (double speed = 1; speed < 6; speed += 0.02)
        {
            BallState state = simulator.Launch(new Vector3d(0, -0.2, 1), new Vector3d(0, 0, -speed), Vector3d.Zero);
            var log = new StepLog();
            double least = 1;
            bool isIn = false;
            for (int i = 0; i < 300; i++)
            {
                simulator.Step(ref state, 0.01, log);
                least = Math.Min(least, state.Position.Z);
                isIn |= state.GoalsEntered != 0;
                Assert.Equal(log.Events.Span.ToArray().Any(item => item.Kind == BallEventKind.Goal), state.GoalsPassed != 0);
            }

            bool scored = state.GoalsPassed != 0;
            Assert.Equal(scored, least < -0.17);
            Assert.Equal(isIn || scored, least < 0);
            Assert.Equal(0UL, state.GoalsEntered);
            entered += isIn && !scored ? 1 : 0;
            reported += scored ? 1 : 0;
        }

        Assert.True(entered > 2 && reported > 10, $"{entered} {reported}");
    }

    [Theory]
    [InlineData(-20.05, -3, 1)]
    [InlineData(-20.05, 3, 0)]
    [InlineData(-20.5, -1, 0)]
    [InlineData(-19.95, -3, 1)]
    public void A_ball_that_lies_on_the_line_is_kicked_in_and_one_that_lies_behind_is_not(double z, double speed, int expected)
    {
        var ball = new Ball(s_scene);
        ball.Place(new Vector3d(1, 0.11, z));
        int reported = 0;
        for (int kick = 0; kick < 2; kick++)
        {
            ball.Kick(new Vector3d(0, 0, speed), Vector3d.Zero);
            for (int i = 0; i < 120; i++)
            {
                ball.Step(1.0 / 60);
                reported += ball.Events.Span.ToArray().Count(item => item.Kind == BallEventKind.Goal);
            }
        }

        Assert.Equal(expected, reported);
    }

    [Fact]
    public void Between_mouth_and_line_bytes_and_copies_know_what_was()
    {
        var simulator = new Simulator(s_scene);
        BallState state = simulator.Launch(new Vector3d(3.02, 0.8, -19), new Vector3d(8, 1, -16), Vector3d.Zero);
        var log = new StepLog();
        while (state.Position.Z > -20.01)
        {
            simulator.Step(ref state, 0.001, log);
        }

        Assert.InRange(state.Position.Z, -20.1, -20);
        byte[] bytes = new byte[Snapshot.Size];
        Snapshot.Write(in state, bytes);
        BallState read = Snapshot.Read(bytes);
        simulator.Run(ref read, 0.01, 0.2, StopAt.Time, log);
        Assert.Single(log.Events.Span.ToArray(), item => item.Kind == BallEventKind.Goal);
    }

    [Fact]
    public void A_ball_that_lies_still_and_is_pushed_over_the_line_is_in()
    {
        var bodies = new KinematicBodies();
        KinematicBody foot = bodies.Add("foot", new SphereShape(Vector3d.Zero, 0.2));
        var ball = new Ball(s_scene with { Bodies = bodies });
        ball.Place(new Vector3d(1, 0.11, -19.9));

        // Put over the ball without a speed of its own, nearer in each frame.
        int reported = 0;
        for (int i = 0; i < 60; i++)
        {
            foot.MoveTo(new Vector3d(1, 0.15, -19.5 - (0.01 * i)), Vector3d.Zero, ball.Time);
            ball.Step(1.0 / 60);
            reported += ball.Events.Span.ToArray().Count(item => item.Kind == BallEventKind.Goal);
        }

        Assert.InRange(ball.Position.Z, -20.6, -20.18);
        Assert.Equal(1, reported);
    }

    [Fact]
    public void Queries_ask_for_the_same_opening()
    {
        var scatter = new GoalChance(Scene.Measured);
        var none = new KickSpread { SpeedPercent = 1e-6, ElevationDegrees = 1e-6, AzimuthDegrees = 1e-6, SpinPercent = 1e-6 };
        double OnTarget(double aside, double height) =>
            scatter.FindByFlights(new Vector3d(0, 1, 0), Towards(aside, height), Vector3d.Zero, none, s_goal, null, 16).OnTarget;

        // The chance is of what goes in: clear of the frame. A save is asked of the centre.
        Assert.Equal(1, OnTarget(3.5, 1.5));
        Assert.Equal(0, OnTarget(3.7, 1.5));
        Assert.Equal(1, OnTarget(0, 2.3));
        Assert.Equal(0, OnTarget(0, 2.5));
        bool IsOnTarget(double aside, double height)
        {
            var path = new Trajectory();
            var simulator = new Simulator(Scene.Measured);
            BallState ball = simulator.Launch(new Vector3d(0, 1, 0), Towards(aside, height), Vector3d.Zero);
            simulator.LookAhead(in ball, new LookAheadRequest(), path);
            return new FootballPhysics.Prediction.Interception().FindSave(path, new Player { Position = new Vector3d(9, 0, 9) }, s_goal).IsOnTarget;
        }

        Assert.True(IsOnTarget(3.6, 1.5) && IsOnTarget(0, 2.4));
        Assert.False(IsOnTarget(3.7, 1.5) || IsOnTarget(0, 2.5));
    }

    private static Vector3d Towards(double aside, double height)
    {
        AimResult found = new Aimer(Scene.Measured).Find(new AimRequest { From = new Vector3d(0, 1, 0), Target = new Vector3d(aside, height, -20), Speed = 28 });
        Assert.Equal(AimStatus.Hit, found.Status);
        return found.Velocity;
    }

    private static BallEvent[] Goals(Vector3d from, Vector3d velocity)
    {
        var simulator = new Simulator(s_scene);
        BallState state = simulator.Launch(from, velocity, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, 1.0 / 60, 2, StopAt.Time, log);
        return [.. log.Events.Span.ToArray().Where(item => item.Kind == BallEventKind.Goal)];
    }
}
