using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>Each change of a motion between two steps has its event.</summary>
public sealed class MotionEventTests
{
    /// <summary>A rolling ball hits a sphere that presses it onto the ground at the same instant: it hits both, and slides until it rolls again.</summary>
    [Theory]
    [ProfileData]
    public void A_roll_that_is_pressed_onto_the_ground_becomes_a_slide(Profile profile)
    {
        Obstacle sphere = new() { Name = "t", Shape = new SphereShape(new Vector3d(1.5, 0.2195, 0.02), 0.21), Surface = SurfaceMaterial.GoalFrame with { NormalRestitution = 0.622 } };
        var simulator = new Simulator(profile.Scene() with { Ground = profile.Ground() with { MinimumBounceSpeed = 0.4 }, Obstacles = [sphere] });
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(3.02, 0, 0.3), new Vector3d(2.727, 0, -27.4545));
        var log = new StepLog();
        for (int i = 0; i < 600; i++)
        {
            simulator.Step(ref ball, 2e-3, log);
        }

        BallEvent[] events = [.. log.Events.Span.ToArray().SkipWhile(e => e.Kind != BallEventKind.Impact).Take(4)];
        Assert.Equal([BallEventKind.Impact, BallEventKind.Impact, BallEventKind.Slide, BallEventKind.Roll], events.Select(e => e.Kind));
        Assert.Equal(["t", "ground"], events.Take(2).Select(e => simulator.NameOf(e.ColliderIndex)));
        Assert.Equal(events[0].Time, events[2].Time);
        Assert.InRange(events[2].Time, 0.4, 0.45);
        Assert.InRange(events[3].Time, 0.5, 0.6);
    }

    /// <summary>A ball that rests on a body wakes with an event: it slides or rolls if the body starts, and falls if the body is taken away.</summary>
    [Theory]
    [InlineData("start", BallEventKind.Slide)]
    [InlineData("tilt", BallEventKind.Roll)]
    [InlineData("take away", BallEventKind.ContactEnd)]
    public void A_ball_that_wakes_has_an_event(string how, BallEventKind kind)
    {
        var bodies = new KinematicBodies();
        KinematicBody table = bodies.Add("table", new BoxShape(default, new Vector3d(1, 0.2, 1)), SurfaceMaterial.Wood);
        table.MoveTo(new Vector3d(0, 1, 0), default, 0);
        var simulator = new Simulator(new Scene { Bodies = bodies });
        BallState ball = simulator.Launch(new Vector3d(0, 1.31, 0), default, default);
        var log = new StepLog();
        for (int i = 0; i < 30; i++)
        {
            simulator.Step(ref ball, 1.0 / 60, log);
        }

        Assert.Equal(MotionState.Rest, ball.Motion);
        switch (how)
        {
            case "start":
                table.MoveTo(new Vector3d(0, 1, 0), new Vector3d(4, 0, 0), ball.Time);
                break;
            case "tilt":
                table.MoveTo(new Vector3d(0, 1, 0), Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), 0.05), default, default, ball.Time);
                ball.Position = new Vector3d(0, 1 + ((0.2 + 0.11) * Math.Cos(0.05)), 0) + (((0.2 + 0.11) * Math.Sin(0.05)) * new Vector3d(-1, 0, 0));
                break;
            default:
                table.MoveTo(new Vector3d(0, -1, 0), default, ball.Time);
                break;
        }

        log.Clear();
        simulator.Step(ref ball, 1e-3, log);
        Assert.Equal(kind, log.Events[0].Kind);
        Assert.Equal(kind switch { BallEventKind.Slide => MotionState.Sliding, BallEventKind.Roll => MotionState.Rolling, _ => MotionState.Airborne }, ball.Motion);
    }

    /// <summary>In a pile, too, slow changes have their events.</summary>
    [Fact]
    public void A_pile_reports_each_change()
    {
        var group = new BallGroup(new Simulator(), 6);
        BallState[] balls = [.. Enumerable.Range(0, 6).Select(i => group.SimulatorOf(i).Launch(new Vector3d(0.09 * (i % 2), 0.12 + (0.23 * i), 0.01 * i), default, new Vector3d(0, 0, 3 * i)))];
        var log = new StepLog();
        int changes = 0;
        for (int step = 0; step < 240; step++)
        {
            BallState[] before = [.. balls];
            log.Clear();
            group.Step(balls, 1.0 / 60, log);
            for (int i = 0; i < 6; i++)
            {
                if (before[i].Motion != balls[i].Motion)
                {
                    changes++;
                    BallEventKind wanted = balls[i].Motion switch
                    {
                        MotionState.Sliding => BallEventKind.Slide,
                        MotionState.Rolling => BallEventKind.Roll,
                        MotionState.Rest => BallEventKind.Rest,
                        _ => BallEventKind.ContactEnd,
                    };
                    Assert.True(log.Events.Span.ToArray().Any(e => e.Ball == i && (e.Kind == wanted || (balls[i].Motion == MotionState.Airborne && e.Kind == BallEventKind.Impact))), $"step {step} ball {i}: {before[i].Motion} to {balls[i].Motion}");
                }
            }
        }

        Assert.True(changes > 10, $"{changes} changes");
    }
}
