using FootballPhysics.Tests.Things;

namespace FootballPhysics.Tests.Game;

/// <summary>What a <see cref="Rollback"/> cannot do is refused before anything changes, and each ball of several has its own state.</summary>
public sealed class RollbackLimitTests
{
    private const double TimeStep = 1.0 / 60;

    [Fact]
    public void Ticks_and_balls_that_are_not_stored_are_refused()
    {
        FixedStepRunner runner = Group();
        Assert.Throws<ArgumentNullException>(() => new Rollback(null!));
        Refused("ticks is 0", () => _ = new Rollback(runner, 0));
        Refused("ticks is 1000001", () => _ = new Rollback(runner, 1_000_001));
        var rollback = new Rollback(runner, 10);
        Play(runner, 30);
        Assert.Equal((20, 10), (rollback.OldestTick, rollback.Ticks));
        ulong before = rollback.HashAt(30);
        foreach (long tick in new long[] { 19, 31 })
        {
            Refused($"tick is {tick}", () => rollback.HashAt(tick));
            Refused($"tick is {tick}", () => rollback.StateAt(tick));
            Refused($"tick is {tick}", () => rollback.ResimulateFrom(tick));
            Refused($"tick is {tick}", () => rollback.ApplyServerState(tick, runner.State));
        }

        foreach (int ball in new[] { -1, 3 })
        {
            Refused($"ball is {ball}", () => rollback.StateAt(25, ball));
            Refused($"ball is {ball}", () => rollback.ApplyServerState(25, runner.State, ball));
        }

        Refused("kick.tick is 19; allowed: 20 or later, because the Rollback stores 10 ticks; create it with more", () => rollback.ApplyKick(new KickInput(19, default, default)));
        Refused("place.tick is 19; allowed: 20 or later", () => rollback.ApplyPlace(new PlaceInput(19, 0, 0, default)));
        Refused("place.ball is 3", () => rollback.ApplyPlace(new PlaceInput(25, 0, 3, default)));
        Refused("kick.ball is 3", () => rollback.ApplyKick(new KickInput(25, default, default, ball: 3)));
        Refused("tick is 19", () => rollback.Remove(19));
        Refused("tick is 19", () => rollback.RemovePlace(19));
        Refused("ticks is 0", () => rollback.SyncTest(0));
        Refused("ticks is 11", () => rollback.SyncTest(11));
        Assert.Equal((3, before), (runner.Kicks.Count, Snapshot.Hash(runner.States)));
        Assert.Null(rollback.SyncTest(10));
    }

    /// <summary>A kick from before a restart is refused by its true cause: the history begins there.</summary>
    [Fact]
    public void A_kick_from_before_the_history_is_refused_by_its_cause()
    {
        FixedStepRunner runner = Group();
        Play(runner, 5);
        var rollback = new Rollback(runner, 32);
        Play(runner, 20);
        runner.RestoreAll(30, [.. Enumerable.Range(0, 3).Select(ball => runner.StateOf(ball))]);
        const string Cause = "; allowed: 30 or later, because the history begins there: the Rollback was created, or the runner's state was set, at that tick.";
        Refused("kick.tick is 25" + Cause, () => rollback.ApplyKick(new KickInput(25, default, default)));
        Refused("tick is 3" + Cause, () => rollback.Remove(3));
    }

    [Fact]
    public void A_state_of_another_time_is_named()
    {
        FixedStepRunner runner = Group();
        Play(runner, 9);
        BallState[] states = [.. Enumerable.Range(0, 3).Select(ball => runner.StateOf(ball))];
        states[2].Time = 3;
        string message = Assert.Throws<ArgumentException>(() => runner.RestoreAll(9, states)).Message;
        Assert.StartsWith($"states[2].time is 3; allowed: {states[0].Time.ToString("R", System.Globalization.CultureInfo.InvariantCulture)}, the time of the first ball.", message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_state_that_a_ball_of_the_scene_cannot_have_is_refused()
    {
        FixedStepRunner runner = Group();
        var rollback = new Rollback(runner, 10);
        Play(runner, 8);
        ulong before = rollback.HashAt(8);
        Assert.Throws<ArgumentException>(() => rollback.ApplyServerState(5, default));
        BallState wrong = rollback.StateAt(5, 1);
        wrong.Velocity = new Vector3d(double.NaN, 0, 0);
        Refused("state.velocity", () => rollback.ApplyServerState(5, in wrong, 1));
        BallState early = rollback.StateAt(4, 1);
        Assert.StartsWith("state.time is ", Assert.Throws<ArgumentException>(() => rollback.ApplyServerState(5, in early, 1)).Message, StringComparison.Ordinal);
        Assert.Equal(before, rollback.HashAt(8));
        Assert.Null(rollback.SyncTest(8));

        // A single ball may have the server's clock, which rounding moves, but not that of another tick.
        var alone = new FixedStepRunner(timeStep: TimeStep);
        var history = new Rollback(alone);
        alone.QueueKick(new Vector3d(0, 5, -5), default);
        Play(alone, 8);
        foreach (double off in new[] { TimeStep, -TimeStep, -history.StateAt(5).Time, 7, 1e-6, double.NaN })
        {
            BallState wrongClock = history.StateAt(5);
            wrongClock.Time += off;
            Assert.Contains("the time of tick 5", Assert.Throws<ArgumentException>(() => history.ApplyServerState(5, in wrongClock)).Message, StringComparison.Ordinal);
        }

        BallState rounded = history.StateAt(5);
        rounded.Time = Math.BitIncrement(rounded.Time);
        Assert.Equal(5, history.ApplyServerState(5, in rounded));
        Assert.Equal(8 * TimeStep, alone.Time, 1e-12);
    }

    /// <summary>At every depth and for every ball: the state of the server gives the bits of a match in which that ball had it from the start.</summary>
    [Fact]
    public void A_state_of_the_server_for_one_of_several_balls_is_played_to_the_present()
    {
        for (int ball = 0; ball < 3; ball++)
        {
            for (int depth = 0; depth <= 12; depth += 3)
            {
                FixedStepRunner server = Group();
                FixedStepRunner client = Group();
                var rollback = new Rollback(client, 12);
                server.Kicks.Add(new KickInput(5, new Vector3d(ball, 4, 6), new Vector3d(0, 9, 0), 7, ball));
                Play(client, 30);
                Play(server, 30 - depth);
                Assert.Equal(30 - depth, rollback.ApplyServerState(30 - depth, server.StateOf(ball), ball));
                Play(server, 30);
                for (int i = 0; i < 3; i++)
                {
                    Assert.True(Snapshot.Same(server.StateOf(i), client.StateOf(i)), $"ball {ball}, depth {depth}, state of {i}");
                    Assert.True(Snapshot.Same(server.StateOf(i), rollback.StateAt(30, i)));
                }

                Assert.True(depth == 0 || rollback.SyncTest(depth) is null);

                // The history goes on from there.
                Assert.Equal(18, rollback.OldestTick);
                Play(server, 35);
                Play(client, 35);
                Assert.Equal(23, rollback.OldestTick);
                Assert.Equal(Snapshot.Hash(server.States), rollback.HashAt(35));
                Assert.Null(rollback.SyncTest(5));
            }
        }
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Steps_in_which_an_object_moved_to_an_unknown_position_cannot_be_played_again(bool isEngine)
    {
        Scene scene = Scene.Default;
        PosedCollider posed = PosedCollider.In(ref scene, new SphereShape(Vector3d.Zero, 0.3), SurfaceMaterial.Board, isEngine);
        var runner = new FixedStepRunner(new Simulator(scene), TimeStep);
        var rollback = new Rollback(runner, keepsBodies: false);
        runner.QueueKick(new Vector3d(0, 5, -8), default);
        for (int tick = 0; tick < 20; tick++)
        {
            // It stops before tick 12.
            Vector3d velocity = tick < 12 ? new Vector3d(0, 0, 1) : Vector3d.Zero;
            if (tick <= 12)
            {
                posed.MoveTo(new Vector3d(9, 1, tick * TimeStep), Quaterniond.Identity, velocity, Vector3d.Zero, runner.Time);
            }

            runner.Step();
        }

        // A body that was placed counts as moved in that step; a collider of an engine counts while it has a velocity.
        int last = isEngine ? 11 : 12;
        BallState before = runner.State;
        BallState state = rollback.StateAt(last);
        state.Velocity += new Vector3d(1, 0, 0);
        string message = isEngine ? $"Engine colliders moved at tick {last}, " : $"Bodies moved at tick {last}, ";
        foreach (Action action in new Action[]
        {
            () => rollback.ApplyKick(new KickInput(last, default, default)),
            () => rollback.Remove(last),
            () => rollback.ApplyServerState(last, in state),
            () => rollback.ResimulateFrom(last),
            () => rollback.SyncTest(20 - last),
        })
        {
            Assert.StartsWith(message, Assert.Throws<InvalidOperationException>(action).Message, StringComparison.Ordinal);
        }

        Assert.True(Snapshot.Same(before, runner.State));
        Assert.Equal(1, runner.Kicks.Count);
        Assert.Null(rollback.SyncTest(19 - last));
        Assert.Equal(last + 2, rollback.ApplyKick(new KickInput(last + 1, new Vector3d(1, 1, 1), default)));

        // Back at an earlier tick, nothing has moved yet.
        runner.Restore(3, rollback.StateAt(last + 1));
        runner.Step();
        Assert.Equal(4, rollback.ApplyKick(new KickInput(3, new Vector3d(1, 1, 1), default)));
    }

    private static FixedStepRunner Group()
    {
        var runner = new FixedStepRunner(new BallGroup(new Simulator(), 3), TimeStep);
        for (int i = 0; i < 3; i++)
        {
            runner.Place(new Vector3d(2 * i, 0, 0), i);
            runner.QueueKick(new Vector3d(0.3 - (0.3 * i), 3 + i, -5), new Vector3d(10 * i, 5, 0), i);
        }

        return runner;
    }

    private static void Play(FixedStepRunner runner, long to)
    {
        while (runner.Tick < to)
        {
            runner.Step();
        }
    }

    private static void Refused(string message, Action action) => Assert.StartsWith(message, Assert.Throws<ArgumentOutOfRangeException>(action).Message, StringComparison.Ordinal);
}
