using System.Reflection;

namespace FootballPhysics.Tests.Api;

/// <summary>What a first afternoon with the library gets wrong: whole numbers of seconds, names of events, positions beyond the end of a path.</summary>
public sealed class CommonSlipTests
{
    /// <summary>The compiler prefers this overload for <c>1 / 60</c>, and reports its message as an error.</summary>
    [Fact]
    public void A_step_of_a_whole_number_is_an_error_that_explains_integer_division()
    {
        MethodInfo whole = typeof(Ball).GetMethod(nameof(Ball.Step), [typeof(int)])!;
        ObsoleteAttribute error = whole.GetCustomAttribute<ObsoleteAttribute>()!;
        Assert.True(error.IsError);
        Assert.Contains("integer division", error.Message, StringComparison.Ordinal);
        Assert.Contains("1.0 / 60", error.Message, StringComparison.Ordinal);
        var ball = new Ball();
        whole.Invoke(ball, [2]);
        Assert.Equal(2, ball.Time);
    }

    [Fact]
    public void A_ball_a_runner_and_a_simulator_name_the_object_of_an_event()
    {
        var wall = new Obstacle { Name = "wall", Shape = new BoxShape(new Vector3d(0, 1, -4), new Vector3d(3, 1, 0.1)) };
        var runner = new FixedStepRunner(new Simulator(new Scene { Obstacles = [wall] }));
        var ball = new Ball(runner.Simulator);
        runner.QueueKick(new Vector3d(0, 1, -20), Vector3d.Zero);
        ball.Kick(new Vector3d(0, 1, -20), Vector3d.Zero);
        BallEvent? hit = null;
        for (int i = 0; i < 100 && hit is null; i++)
        {
            runner.Step();
            ball.Step(runner.TimeStep);
            hit = runner.Events.Span.ToArray().Cast<BallEvent?>().FirstOrDefault(happened => happened!.Value.ColliderIndex > 0);
        }

        Assert.Equal("wall", runner.NameOf(hit!.Value));
        Assert.Equal("wall", runner.Simulator.NameOf(hit.Value));
        Assert.Equal("wall", ball.NameOf(ball.Events[ball.Events.Count - 1]));
        BallEvent rest = new(BallEventKind.Rest, -1, default, 0, default, default, default, default, default);
        Assert.Null(runner.NameOf(rest));
        Assert.Null(runner.Simulator.NameOf(rest));
    }

    [Fact]
    public void A_path_tells_its_end_from_a_position()
    {
        var ball = new Ball();
        ball.Kick(new Vector3d(0, 6, -18), Vector3d.Zero);
        ball.Step(0.3);
        var path = new Trajectory();
        ball.LookAhead(new LookAheadRequest { Duration = 1.5 }, path);
        foreach (double time in new[] { path.StartTime, 0.9, path.EndTime })
        {
            Assert.True(path.TryPositionAt(time, out Vector3d there));
            Assert.Equal(path.PositionAt(time), there);
        }

        Assert.False(path.TryPositionAt(path.EndTime + 1e-9, out Vector3d after));
        Assert.Equal(path.Final.Position, after);
        Assert.False(path.TryPositionAt(path.StartTime - 1e-9, out Vector3d before));
        Assert.Equal(ball.Position, before);
        Assert.Throws<ArgumentOutOfRangeException>(() => path.TryPositionAt(double.NaN, out _));

        // A path that was cut short ends early.
        var small = new Trajectory(new PathSegment[4]);
        ball.LookAhead(new LookAheadRequest { Duration = 1.5 }, small);
        Assert.False(small.IsComplete || small.TryPositionAt(1.7, out _));
    }
}
