namespace FootballPhysics.Tests.Game;

/// <summary>What a runner and a ball accept, and what they refuse.</summary>
public sealed class RunnerInputTests
{
    [Fact]
    public void One_state_does_not_restore_several_balls()
    {
        var group = new BallGroup(new Simulator(), 2);
        var runner = new FixedStepRunner(group, 0.01);
        BallState[] before = [.. runner.States];
        ArgumentException refused = Assert.Throws<ArgumentException>(() => runner.Restore(3, group.SimulatorOf(0).Launch(Vector3d.Up, Vector3d.Up, Vector3d.Up)));
        Assert.Contains("RestoreAll", refused.Message, StringComparison.Ordinal);
        Assert.Equal(0, runner.Tick);
        Assert.True(Snapshot.Same(before[0], runner.States[0]));
    }

    [Theory]
    [InlineData(-1)]
    [InlineData(1)]
    public void A_ball_that_does_not_exist_has_no_pose(int ball) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new FixedStepRunner(new Simulator(), 0.01).PoseAt(0.5, ball));

    [Fact]
    public void Without_a_rollback_a_scene_with_bodies_may_follow()
    {
        var runner = new FixedStepRunner(new Simulator(), 0.01);
        var bodies = new KinematicBodies();
        bodies.Add("keeper", BodyKind.Player);
        var next = new Simulator(new Scene { Bodies = bodies });
        runner.Simulator = next;
        Assert.Same(next, runner.Simulator);
    }

    [Fact]
    public void Another_scene_ends_the_recording_of_a_ball_that_does_not_change()
    {
        var runner = new FixedStepRunner(new Simulator(), 0.01);
        Recording recording = runner.Record();
        runner.Step();
        runner.Simulator = new Simulator(new Scene { Gravity = 3.7 });
        runner.Step();
        Assert.Equal(1, recording.EndTick);
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
}
