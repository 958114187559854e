namespace FootballPhysics.Tests.Game;

/// <summary>What a <see cref="Rollback"/> corrects is what would have happened, to the last bit.</summary>
public sealed class RollbackRingTests
{
    private static readonly KickInput s_first = new(3, new Vector3d(2, 6, -18), new Vector3d(0, 25, 0));
    private static readonly KickInput s_late = new(40, new Vector3d(-9, 4, 3), Vector3d.Zero, player: 1);

    [Fact]
    public void A_kick_that_arrives_late_ends_where_it_would_have()
    {
        var simulator = new Simulator();
        FixedStepRunner expected = Runner(simulator, s_first, s_late);
        FixedStepRunner runner = Runner(simulator, s_first);
        var rollback = new Rollback(runner, ticks: 30);
        while (runner.Tick < 60)
        {
            runner.Step();
            expected.Step();
        }

        Assert.Equal(30, rollback.OldestTick);
        Assert.Equal(41, rollback.ApplyKick(in s_late));
        Assert.True(Snapshot.Same(expected.State, runner.State));
        Assert.Equal(60, runner.Tick);
        Assert.Equal(Snapshot.Hash(runner.State), rollback.HashAt(60));

        // Again the same kick changes nothing, and taking it back brings the old match back.
        Assert.Null(rollback.ApplyKick(in s_late));
        Assert.Equal(41, rollback.Remove(40, player: 1));
        FixedStepRunner without = Runner(simulator, s_first);
        while (without.Tick < 60)
        {
            without.Step();
        }

        Assert.True(Snapshot.Same(without.State, runner.State));
        Assert.Null(rollback.Remove(40, player: 1));
    }

    [Fact]
    public void A_state_of_the_server_is_played_to_the_present()
    {
        var simulator = new Simulator();
        FixedStepRunner server = Runner(simulator, s_first, s_late);
        FixedStepRunner client = Runner(simulator, s_first);
        var rollback = new Rollback(client);
        BallState known = default;
        while (server.Tick < 50)
        {
            server.Step();
            client.Step();
            known = server.Tick == 45 ? server.State : known;
        }

        Assert.Equal(45, rollback.ApplyServerState(45, in known));
        Assert.True(Snapshot.Same(server.State, client.State));
        Assert.Null(rollback.ApplyServerState(45, in known));
    }

    [Fact]
    public void Frames_are_followed_and_a_state_from_outside_begins_a_new_history()
    {
        var runner = new FixedStepRunner();
        var rollback = new Rollback(runner, ticks: 8);
        runner.QueueKick(new Vector3d(0, 5, -10), default);
        runner.Advance(0.205);
        Assert.Equal(12, rollback.OldestTick);
        Assert.Equal(runner.State.Position, rollback.StateAt(20).Position);
        Assert.Throws<ArgumentOutOfRangeException>(() => rollback.StateAt(11));
        Assert.Throws<ArgumentOutOfRangeException>(() => rollback.ApplyKick(new KickInput(11, default, default)));
        Assert.Null(rollback.ApplyKick(new KickInput(30, new Vector3d(1, 0, 0), default)));
        runner.Restore(20, runner.State);
        Assert.Equal(20, rollback.OldestTick);
        string message = Assert.Throws<ArgumentOutOfRangeException>(() => rollback.ApplyKick(new KickInput(19, default, default))).Message;
        Assert.StartsWith("kick.tick is 19; allowed: 20 or later, because the history begins there", message, StringComparison.Ordinal);
    }

    [Fact]
    public void Events_of_what_is_played_again_are_told()
    {
        FixedStepRunner runner = Runner(new Simulator());
        var rollback = new Rollback(runner, ticks: 200);
        while (runner.Tick < 180)
        {
            runner.Step();
        }

        Assert.Equal(4, rollback.ApplyKick(in s_first));
        Assert.Contains(rollback.Events.Span.ToArray(), happened => happened.Kind == BallEventKind.Impact);
    }

    private static FixedStepRunner Runner(Simulator simulator, params KickInput[] kicks)
    {
        var runner = new FixedStepRunner(simulator);
        foreach (KickInput kick in kicks)
        {
            runner.Kicks.Add(in kick);
        }

        return runner;
    }
}
