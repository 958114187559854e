namespace FootballPhysics.Tests.Game;

/// <summary>Only one runner at a time can move the bodies of a scene: an earlier one is refused, and says what to do.</summary>
public sealed class TwoRunnersTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void Two_runners_do_not_share_bodies(int balls)
    {
        var simulator = new Simulator(Scene());
        FixedStepRunner first = Runner(simulator, balls);
        first.Step();
        FixedStepRunner second = Runner(simulator, balls);
        second.Step();
        ulong before = Snapshot.Hash(first.State);
        foreach (Action step in new Action[] { first.Step, () => first.Advance(0.02) })
        {
            InvalidOperationException refusal = Assert.Throws<InvalidOperationException>(step);
            Assert.Equal("A FixedStepRunner that was created later uses the bodies of this scene. Create a scene with bodies of its own for each runner.", refusal.Message);
        }

        Assert.Equal((1, before), (first.Tick, Snapshot.Hash(first.State)));
        second.Step();
        Assert.Equal(2, second.Tick);
    }

    /// <summary>Another simulator of the same bodies does not help, nor does a runner that changes to such a scene.</summary>
    [Fact]
    public void The_bodies_count_not_the_simulator()
    {
        Scene scene = Scene();
        var first = new FixedStepRunner(new Simulator(scene));
        _ = new FixedStepRunner(new Simulator(scene));
        Assert.Throws<InvalidOperationException>(first.Step);

        var free = new FixedStepRunner(new Simulator(Scene()));
        var other = new FixedStepRunner(new Simulator(scene));
        free.Simulator = new Simulator(scene);
        free.Step();
        Assert.Throws<InvalidOperationException>(other.Step);
    }

    /// <summary>Runners without bodies share a simulator.</summary>
    [Fact]
    public void Runners_without_bodies_share_a_scene()
    {
        var simulator = new Simulator();
        var first = new FixedStepRunner(simulator);
        var second = new FixedStepRunner(simulator);
        first.Step();
        second.Step();
        first.Step();
        Assert.Equal((2, 1), (first.Tick, second.Tick));
    }

    private static Scene Scene()
    {
        var bodies = new KinematicBodies();
        bodies.Add("player", BodyKind.Player);
        return new Scene { Bodies = bodies };
    }

    private static FixedStepRunner Runner(Simulator simulator, int balls) => balls == 1 ? new(simulator) : new(new BallGroup(simulator, balls));
}
