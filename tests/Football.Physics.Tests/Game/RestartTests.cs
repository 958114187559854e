using FootballPhysics.Game;

namespace FootballPhysics.Tests.Game;

/// <summary>Restarts that belong to a tick: they arrive late, twice and in any order, and are part of logs, recordings and rollbacks.</summary>
public sealed class RestartTests
{
    private const double TimeStep = 1.0 / 60;

    private static readonly Vector3d s_spot = new(3, 0, 4);

    [Fact]
    public void A_restart_sets_the_ball_at_its_tick_and_the_clock_goes_on()
    {
        FixedStepRunner runner = New();
        runner.QueueKick(new Vector3d(0, 5, -20), default);
        runner.Kicks.Add(new PlaceInput(10, 2, 0, s_spot));
        Play(runner, 11);
        Assert.Equal((3.0, runner.Simulator.ContactHeight, 4.0), (runner.State.Position.X, runner.State.Position.Y, runner.State.Position.Z));
        Assert.Equal((MotionState.Rest, Quaterniond.Identity), (runner.Motion, runner.State.Orientation));
        Assert.Equal(11 * TimeStep, runner.Time, 1e-12);

        // It has the bits of a ball that was placed there, except for its clock.
        var placed = new FixedStepRunner(timeStep: TimeStep);
        placed.Place(s_spot);
        BallState expected = placed.State;
        expected.Time = runner.Time;
        Assert.True(Snapshot.Same(in expected, runner.State));
    }

    [Fact]
    public void A_restart_has_any_motion_and_a_kick_of_its_tick_follows_it()
    {
        var turned = new Quaterniond(0, 2, 0, 2);
        var thrown = new PlaceInput(4, 0, 0, new Vector3d(30, 2, 5), new Vector3d(-8, 3, 1), new Vector3d(0, 6, 0), turned);
        FixedStepRunner runner = New();
        runner.Kicks.Add(in thrown);
        Play(runner, 4);
        BallState start = runner.Simulator.Launch(thrown.Position, thrown.Velocity, thrown.Spin, turned);
        start.Time = runner.Time;
        var log = new StepLog();
        runner.Simulator.Step(ref start, TimeStep, log);
        runner.Step();
        Assert.True(Snapshot.Same(in start, runner.State));

        Assert.Throws<ArgumentException>(() =>
        {
            BallState never = default;
            thrown.Apply(runner.Simulator, ref never);
        });
        Assert.Throws<ArgumentNullException>(() =>
        {
            BallState state = runner.State;
            thrown.Apply(null!, ref state);
        });

        FixedStepRunner kicked = New();
        kicked.Kicks.Add(new KickInput(4, new Vector3d(0, 0, -10), default, 1));
        kicked.Kicks.Add(new PlaceInput(4, 9, 0, s_spot));
        Play(kicked, 5);
        Assert.InRange(kicked.State.Position.Z, 4 - (10 * TimeStep), 4 - (9.9 * TimeStep));
    }

    [Fact]
    public void The_highest_player_places_the_ball_and_each_ball_has_its_own()
    {
        foreach (int[] order in new[] { new[] { 1, 7, 4 }, [7, 4, 1], [4, 1, 7] })
        {
            var runner = new FixedStepRunner(new BallGroup(new Simulator(), 2), TimeStep);
            foreach (int player in order)
            {
                runner.Kicks.Add(new PlaceInput(2, player, 1, new Vector3d(player, 0, 0)));
                runner.Kicks.Add(new PlaceInput(2, 10 - player, 0, new Vector3d(0, 0, 20 - player)));
            }

            Play(runner, 3);
            Assert.Equal((7.0, 19.0), (runner.StateOf(1).Position.X, runner.StateOf(0).Position.Z));
        }
    }

    [Fact]
    public void A_late_restart_ends_in_the_bits_of_one_in_time_and_a_later_resimulation_keeps_it()
    {
        KickInput[] kicks = [new(10, new Vector3d(3, 6, -20), default, 1), new(35, new Vector3d(-4, 2, 9), new Vector3d(0, 30, 0), 2)];
        var place = new PlaceInput(30, 3, 0, s_spot);
        FixedStepRunner inTime = New();
        FixedStepRunner late = New();
        var rollback = new Rollback(late, 60);
        foreach (KickInput kick in kicks)
        {
            inTime.Kicks.Add(in kick);
        }

        inTime.Kicks.Add(in place);
        Play(inTime, 50);
        Play(late, 50);
        rollback.ApplyKick(in kicks[1]);
        Assert.Equal(31, rollback.ApplyPlace(in place));
        Assert.Equal(11, rollback.ApplyKick(in kicks[0]));
        Assert.True(Snapshot.Same(inTime.State, late.State));
        Assert.Equal((2, 1), (late.Kicks.Count, late.Kicks.PlaceCount));

        // It is removed like a kick.
        Assert.Equal(31, rollback.RemovePlace(30, 3));
        Assert.Null(rollback.RemovePlace(30, 3));
        Assert.False(Snapshot.Same(inTime.State, late.State));
    }

    [Fact]
    public void An_input_that_arrives_twice_changes_nothing_and_raises_no_event_again()
    {
        FixedStepRunner runner = New();
        var rollback = new Rollback(runner, 60);
        Play(runner, 40);
        var kick = new KickInput(5, new Vector3d(0, 1, -9), default, 1);
        var place = new PlaceInput(30, 1, 0, new Vector3d(0, 1, 0));
        Assert.NotNull(rollback.ApplyPlace(in place));
        Assert.NotNull(rollback.ApplyKick(in kick));
        Assert.True(rollback.Events.Count > 0);
        ulong hash = rollback.HashAt(40);
        Assert.Null(rollback.ApplyKick(in kick));
        Assert.Equal(0, rollback.Events.Count);
        Assert.Null(rollback.ApplyPlace(in place));
        Assert.Equal((hash, 0, 1, 1), (rollback.HashAt(40), rollback.Events.Count, runner.Kicks.Count, runner.Kicks.PlaceCount));

        // An input that is in the log, but was not simulated yet, is no duplicate.
        var other = new KickInput(20, new Vector3d(2, 0, 0), default, 1);
        runner.Kicks.Add(in other);
        Assert.Equal(21, rollback.ApplyKick(in other));
        Assert.Null(rollback.ApplyKick(in other));

        // A kick of the future waits, twice or once.
        var future = new KickInput(50, new Vector3d(2, 0, 0), default, 1);
        Assert.Null(rollback.ApplyKick(in future));
        Assert.Null(rollback.ApplyKick(in future));
        Play(runner, 51);
        Assert.Null(rollback.ApplyKick(in future));
        Assert.Equal(2.0, rollback.StateAt(51).Velocity.X, 0.1);
    }

    [Fact]
    public void Place_is_refused_while_a_rollback_is_attached()
    {
        FixedStepRunner runner = New();
        var rollback = new Rollback(runner);
        Assert.Same(rollback, runner.Rollback);
        runner.QueueKick(new Vector3d(0, 5, -20), default);
        Play(runner, 5);
        ulong hash = rollback.HashAt(5);
        Assert.Contains("PlaceInput", Assert.Throws<InvalidOperationException>(() => runner.Place(default)).Message, StringComparison.Ordinal);
        Assert.Equal((hash, 0L, 1), (rollback.HashAt(5), rollback.OldestTick, runner.Kicks.Count));
        runner.QueuePlace(s_spot);
        runner.Step();
        Assert.Equal((0L, 4.0), (rollback.OldestTick, runner.State.Position.Z));

        // Without a rollback, it discards the inputs of its ball that wait.
        FixedStepRunner alone = New();
        alone.QueuePlace(s_spot);
        alone.Place(new Vector3d(1, 0, 1));
        Assert.Equal(0, alone.Kicks.PlaceCount);
    }

    /// <summary>The state of the server is that of its tick; a late kick from before it changes only the ticks before.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void A_late_kick_does_not_erase_the_state_of_the_server(int balls)
    {
        FixedStepRunner runner = balls == 1 ? New() : new FixedStepRunner(new BallGroup(new Simulator(), balls), TimeStep);
        var rollback = new Rollback(runner, 40);
        Play(runner, 55);
        BallState kickOff = runner.SimulatorOf(0).Launch(new Vector3d(0, 0.11, 30), default, default);
        kickOff.Time = rollback.StateAt(50).Time;
        Assert.Equal(50, rollback.ApplyServerState(50, in kickOff));
        Assert.Equal(46, rollback.ApplyKick(new KickInput(45, new Vector3d(0, 3, -20), default, 3)));
        Assert.True(Snapshot.Same(in kickOff, rollback.StateAt(50)));
        Assert.Equal(30, runner.State.Position.Z);
        Assert.Null(rollback.SyncTest(15));

        // Inputs at its tick or later continue from it.
        Assert.Equal(51, rollback.ApplyKick(new KickInput(50, new Vector3d(0, 0, -6), default, 3)));
        Assert.InRange(runner.State.Position.Z, 29, 29.9);

        // Its own state, confirmed by the server, holds too.
        Play(runner, 70);
        BallState own = rollback.StateAt(60);
        Assert.Null(rollback.ApplyServerState(60, in own));
        rollback.ApplyKick(new KickInput(58, new Vector3d(9, 3, 0), default, 5));
        Assert.True(Snapshot.Same(in own, rollback.StateAt(60)));
        if (balls > 1)
        {
            // The other ball was not given: it is resimulated.
            Assert.NotNull(rollback.ApplyKick(new KickInput(58, new Vector3d(9, 3, 0), default, 5, 1)));
            Assert.NotEqual(0, runner.StateOf(1).Position.X, 0.5);
        }
    }

    [Fact]
    public void A_log_has_the_restarts_in_its_bytes()
    {
        var log = new KickLog();
        log.Add(new KickInput(3, Vector3d.Up, default, 1));
        byte[] kicksOnly = log.ToBytes();
        log.Add(new PlaceInput(9, 4, 2, new Vector3d(0.1, 2, -0.0), new Vector3d(1, 0, 0.3), new Vector3d(0, 1e-3, 0), new Quaterniond(0.1, -0.2, 0.3, 0.4)));
        log.Add(new PlaceInput(9, 4, 1, s_spot));
        log.Add(new PlaceInput(2, 7, 0, s_spot));
        byte[] bytes = log.ToBytes();
        var again = KickLog.FromBytes(bytes);
        Assert.Equal((1, 3), (again.Count, again.PlaceCount));
        Assert.Equal([2L, 9, 9], Enumerable.Range(0, 3).Select(i => again.PlaceAt(i).Tick));
        Assert.Equal(Enumerable.Range(0, 3).Select(i => log.PlaceAt(i)), Enumerable.Range(0, 3).Select(i => again.PlaceAt(i)));
        Assert.Equal(bytes, again.ToBytes());
        Assert.Equal(1, again.FirstPlaceAt(3));

        // From rest, in single precision, it takes 22 bytes.
        log.RemoveFrom(0);
        log.Add(new PlaceInput(100, 1, 0, new System.Numerics.Vector3(1.1f, 2.2f, -20.3f)));
        Assert.Equal((0, 5 + 1 + 22), (log.Count, log.ToBytes().Length));
        log.Clear();
        Assert.Equal((0, 5), (log.PlaceCount, log.ToBytes().Length));

        // Every log has one encoding: an empty list of restarts, and a wrong order, are refused.
        Refused("something follows their end", [.. kicksOnly[..^4], 0]);
        Refused("two restarts are not in order", [.. kicksOnly[..^4], 2, .. Body(9, 4), .. Body(0, 4)]);
        Refused("an unknown form of a restart", [.. kicksOnly[..^4], 1, 9, 4, 0, 0, 0, 8, .. new byte[4]]);
        Refused("place.orientation is", [.. kicksOnly[..^4], 1, 9, 4, 0, 0, 0, 0]);

        static byte[] Body(byte ticks, byte player) => [ticks, player, 0, 0, 0, 1, 0, 0, 0x80, 0x3F];
    }

    [Fact]
    public void A_restart_is_refused_by_the_field_that_is_out_of_range()
    {
        foreach ((string field, Action make) in new (string, Action)[]
        {
            ("place.tick is -1", () => _ = new PlaceInput(-1, 0, 0, default)),
            ("place.player is -1", () => _ = new PlaceInput(0, -1, 0, default)),
            ("place.ball is 10000", () => _ = new PlaceInput(0, 0, 10_000, default)),
            ("place.position is ", () => _ = new PlaceInput(0, 0, 0, new Vector3d(1e7, 0, 0))),
            ("place.velocity is ", () => _ = new PlaceInput(0, 0, 0, default, new Vector3d(0, double.NaN, 0))),
            ("place.spin is ", () => _ = new PlaceInput(0, 0, 0, default, default, new Vector3d(0, 10_001, 0))),
            ("place.orientation is ", () => _ = new PlaceInput(0, 0, 0, default, default, default, default(Quaterniond))),
        })
        {
            Assert.StartsWith(field, Assert.Throws<ArgumentOutOfRangeException>(make).Message, StringComparison.Ordinal);
        }

        FixedStepRunner runner = New();
        Assert.StartsWith("place.ball is 1", Assert.Throws<ArgumentOutOfRangeException>(() => runner.Kicks.Add(new PlaceInput(0, 0, 1, default))).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.QueuePlace(default, ball: 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.Kicks.PlaceAt(0));
        Assert.Equal("tick 7: ball 2 at (1.235, 0, 0) m, (0, 0, 0) m/s, (0, 2.5, 0) rad/s, player 4", new PlaceInput(7, 4, 2, new Vector3d(1.23456, 0, 0), default, new Vector3d(0, 2.5, 0)).ToString());
    }

    [Fact]
    public void A_recording_has_the_restarts_and_goes_on_through_them()
    {
        FixedStepRunner runner = New();
        var rollback = new Rollback(runner, 40);
        Recording segment = runner.Record();
        runner.QueueKick(new Vector3d(0, 5, -20), default);
        runner.Kicks.Add(new PlaceInput(20, 1, 0, s_spot, new Vector3d(0, 0, 2)));
        Play(runner, 100);
        rollback.ApplyPlace(new PlaceInput(80, 1, 0, new Vector3d(0, 3, 0)));
        Assert.Same(segment, runner.Recording);
        runner.Kicks.Add(new PlaceInput(100, 1, 0, s_spot));
        var read = Recording.FromBytes(segment.ToBytes());
        Assert.Equal((1, 2, 100L), (read.Kicks.Count, read.Kicks.PlaceCount, read.EndTick));
        Assert.Null(read.FirstDivergence(new Simulator()));
        FixedStepRunner replay = read.Replay(new Simulator());
        read.Seek(replay, 90);
        read.Seek(replay, 70);
        Assert.Equal(read.HashAt(70), Snapshot.Hash(replay.State));

        // A restart of a ball that the segment does not have is refused.
        segment.Kicks.RemoveFrom(0);
        var group = new FixedStepRunner(new BallGroup(new Simulator(), 2), TimeStep);
        Recording two = group.Record();
        group.Kicks.Add(new PlaceInput(0, 0, 1, s_spot));
        Play(group, 2);
        byte[] bytes = two.ToBytes();
        int at = bytes.AsSpan().IndexOf((ReadOnlySpan<byte>)[1, 0, 0, 0x11, 0, 0, 5, 1]);
        Assert.True(at > 0);
        bytes[at + 7] = 2;
        Crc32.Seal(bytes);
        Assert.Contains("a ball is placed that there is not", Assert.Throws<FormatException>(() => Recording.FromBytes(bytes)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Old_restarts_are_forgotten_with_old_kicks()
    {
        FixedStepRunner runner = New();
        runner.KickTicks = 10;
        runner.Kicks.Add(new PlaceInput(0, 0, 0, s_spot));
        runner.Kicks.Add(new PlaceInput(15, 0, 0, s_spot));
        Play(runner, 20);
        Assert.Equal((1, 15L), (runner.Kicks.PlaceCount, runner.Kicks.PlaceAt(0).Tick));
    }

    [Fact]
    public void A_restart_is_rounded_with_the_ticks_that_are()
    {
        var runner = new FixedStepRunner(timeStep: TimeStep) { QuantizationInterval = 3 };
        runner.Kicks.Add(new PlaceInput(5, 0, 0, new Vector3d(0.12345, 1.5, 7), new Vector3d(1, 2, 3), new Vector3d(4, 5, 6)));
        Play(runner, 6);
        Assert.True(runner.TryWriteQuantized(runner.State, new byte[Snapshot.QuantizedSize]));
    }

    [Fact]
    public void Steps_with_restarts_allocate_nothing()
    {
        FixedStepRunner runner = New();
        var rollback = new Rollback(runner, 20);
        long least = long.MaxValue;
        for (int run = 0; run < 4; run++)
        {
            long before = GC.GetAllocatedBytesForCurrentThread();
            for (int i = 0; i < 30; i++)
            {
                runner.QueuePlace(new Vector3d(i, 1, 0), new Vector3d(1, 1, 1));
                runner.Step();
            }

            rollback.ApplyPlace(new PlaceInput(runner.Tick - 10, 1, 0, s_spot));
            runner.Kicks.Clear();
            least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
        }

        Assert.Equal(0, least);
    }

    private static FixedStepRunner New() => new(timeStep: TimeStep);

    private static void Play(FixedStepRunner runner, long to)
    {
        while (runner.Tick < to)
        {
            runner.Step();
        }
    }

    private static void Refused(string reason, byte[] bytes)
    {
        byte[] sealedBytes = [.. bytes, .. new byte[Crc32.Size]];
        Crc32.Seal(sealedBytes);
        Assert.StartsWith($"The bytes are broken: {reason}", Assert.Throws<FormatException>(() => KickLog.FromBytes(sealedBytes)).Message, StringComparison.Ordinal);
    }
}
