namespace FootballPhysics.Tests.Game;

/// <summary>Putting a ball somewhere, and states that are none.</summary>
public sealed class PlaceTests
{
    [Fact]
    public void A_new_ball_is_at_rest_and_nothing_happens_to_it()
    {
        var ball = new Ball();
        Assert.Equal(MotionState.Rest, ball.Motion);
        ball.Step(0.01);
        Assert.Equal((MotionState.Rest, 0), (ball.Motion, ball.Events.Count));
        var runner = new FixedStepRunner();
        runner.Step();
        Assert.Equal((MotionState.Rest, 0), (runner.Motion, runner.Events.Count));
        ball.Place(new Vector3d(0, 2, 0));
        Assert.Equal(MotionState.Airborne, ball.Motion);
    }

    [Fact]
    public void A_placed_ball_forgets_the_kick_that_waited()
    {
        var runner = new FixedStepRunner();
        runner.QueueKick(new Vector3d(0, 5, -20), default);
        runner.Place(new Vector3d(3, 0, 4));
        runner.Step();
        Assert.Equal(MotionState.Rest, runner.Motion);
        Assert.Equal((3.0, 4.0), (runner.State.Position.X, runner.State.Position.Z));
        Assert.Equal(0, runner.Kicks.Count);
    }

    [Fact]
    public void A_state_that_was_never_launched_is_refused()
    {
        var ball = new Ball();
        BallState before = ball.State;
        Assert.Contains("The state was never launched. Create it with Simulator.Launch", Assert.Throws<ArgumentException>(() => ball.State = default).Message, StringComparison.Ordinal);
        Assert.True(Snapshot.Same(before, ball.State));
        var runner = new FixedStepRunner();
        Assert.Throws<ArgumentException>(() => runner.Restore(5, default));
        Assert.Equal(0, runner.Tick);
        Assert.Throws<ArgumentException>(() => ball.Simulator.LookAhead(default, new LookAheadRequest(), new Trajectory()));
    }

    [Fact]
    public void A_force_that_is_not_finite_is_refused_by_name_and_nothing_has_changed()
    {
        var ball = new Ball(Scene.Published with { Forces = ForceSet.Published with { CustomForces = [new Broken()] } });
        ball.Place(new Vector3d(0, 2, 0));
        BallState before = ball.State;
        string message = Assert.Throws<InvalidOperationException>(() => ball.Step(0.01)).Message;
        Assert.Contains(nameof(Broken), message, StringComparison.Ordinal);
        Assert.True(Snapshot.Same(before, ball.State));
    }

    [Fact]
    public void A_scene_without_one_of_its_parts_is_refused_by_name()
    {
        Assert.Equal("ball", Assert.Throws<ArgumentNullException>(() => new Simulator(Scene.Published with { Ball = null! })).ParamName);
        Assert.Equal("air", Assert.Throws<ArgumentNullException>(() => new Simulator(Scene.Published with { Air = null! })).ParamName);
        Assert.Equal("forces", Assert.Throws<ArgumentNullException>(() => new Simulator(Scene.Published with { Forces = null! })).ParamName);
        Assert.Equal("ground", Assert.Throws<ArgumentNullException>(() => new Simulator(Scene.Published with { Ground = null! })).ParamName);
    }

    private sealed class Broken : IForce
    {
        public void Apply(in ForceContext ball, ref ForceAndTorque sum) => sum.AddForce(new Vector3d(0, Math.Sqrt(-ball.Position.Y), 0));
    }
}
