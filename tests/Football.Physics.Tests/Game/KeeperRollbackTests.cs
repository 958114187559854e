using FootballPhysics.Game;

namespace FootballPhysics.Tests.Game;

/// <summary>A keeper who is moved in MoveBodies: late kicks and restarts end in the bits of a match in which all arrived in time.</summary>
public sealed class KeeperRollbackTests
{
    private const double TimeStep = 1.0 / 60;
    private const int Late = 20;
    private const int Ticks = 400;

    [Fact]
    public void A_late_kick_during_a_dive_ends_in_the_same_bits()
    {
        // The second shot arrives while he dives for the first, and the third after he is back.
        KickInput[] kicks =
        [
            new(10, new Vector3d(2.3, 3.4, -21), new Vector3d(0, 20, 0), 1),
            new(32, new Vector3d(-3, 2, -17), default, 2),
            new(260, new Vector3d(0, 3, -20), default, 1),
        ];
        (ulong inTime, int dives) = Play(kicks, [], 0, followsRestarts: true);
        Assert.InRange(dives, 2, 4);
        for (int late = 1; late <= Late; late += 1 + (late / 4))
        {
            Assert.Equal((inTime, dives), Play(kicks, [], late, followsRestarts: true));
        }
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_late_restart_ends_in_the_same_bits(bool followsRestarts)
    {
        KickInput[] kicks = [new(10, new Vector3d(2.3, 3.4, -21), default, 1), new(60, new Vector3d(-2, 3, -20), default, 2), new(201, new Vector3d(1, 3, -22), default, 1)];
        PlaceInput[] places = [new(30, 1, 0, new Vector3d(0, 0, 2)), new(64, 2, 0, new Vector3d(0, 1, 0), new Vector3d(3, 3, -18)), new(200, 1, 0, default)];
        (ulong inTime, int dives) = Play(kicks, places, 0, followsRestarts);
        for (int late = 1; late <= Late; late += 1 + (late / 4))
        {
            Assert.Equal((inTime, dives), Play(kicks, places, late, followsRestarts));
        }
    }

    [Fact]
    public void A_restart_sends_him_back_to_his_goal()
    {
        foreach (bool follows in new[] { true, false })
        {
            (FixedStepRunner runner, BallScene stage) = Match(follows);
            _ = new Rollback(runner);
            runner.QueueKick(new Vector3d(2.3, 3.4, -21), default);
            while (!stage.Keepers[0].Dives || runner.Tick < 35)
            {
                runner.Step();
            }

            Vector3d away = stage.Keepers[0].BodyPose.Position;
            runner.QueuePlace(default);
            runner.Step();
            Vector3d then = stage.Keepers[0].BodyPose.Position;
            Assert.Equal(follows, then == new Vector3d(0, 0.98, -10.4));
            Assert.True(away.X > 0.2, $"{away}");
            Assert.Equal(follows, !stage.Keepers[0].Dives);
        }
    }

    /// <summary>More decisions than he keeps at first: he forgets those that no rollback of ten seconds needs.</summary>
    [Fact]
    public void He_remembers_ten_seconds_however_often_he_decides()
    {
        (FixedStepRunner runner, BallScene stage) = Match(true);
        var rollback = new Rollback(runner, 500);
        for (int i = 0; i < 3000; i++)
        {
            if (i % 5 == 0)
            {
                runner.QueueKick(new Vector3d(i % 3, 2, -5 * Math.Sign(runner.State.Position.Z + 5)), default);
            }

            runner.Step();
        }

        Assert.Null(rollback.SyncTest(500));
        Assert.Null(rollback.SyncTest(1));
        Assert.Equal(0.98, stage.Keepers[0].BodyPose.Position.Y, 2);
    }

    /// <summary>A state of the ball does not contain his decisions: his own bytes do, also those of an earlier tick and those before his first decision.</summary>
    [Theory]
    [InlineData(0, 0)]
    [InlineData(5, 0)]
    [InlineData(26, 0)]
    [InlineData(26, 14)]
    [InlineData(45, 30)]
    [InlineData(120, 20)]
    public void A_peer_that_joins_restores_his_memory(int tick, int earlier)
    {
        (FixedStepRunner runner, BallScene stage) = Match(true);
        var rollback = new Rollback(runner, 40);
        runner.Kicks.Add(new KickInput(10, new Vector3d(2.3, 3.4, -21), new Vector3d(0, 20, 0), 1));
        while (runner.Tick < tick)
        {
            runner.Step();
        }

        long from = tick - earlier;
        BallState ball = rollback.StateAt(from);
        byte[] memory = stage.Keepers[0].ToBytes(ball.Time);
        (FixedStepRunner joined, BallScene other) = Match(true);
        joined.Kicks.Add(runner.Kicks, 0, long.MaxValue);
        other.Keepers[0].Restore(memory);
        joined.Restore(from, in ball);
        Assert.Equal(memory, other.Keepers[0].ToBytes(ball.Time));
        while (joined.Tick < 200)
        {
            joined.Step();
            while (runner.Tick < joined.Tick)
            {
                runner.Step();
            }

            if (joined.Tick >= runner.Tick)
            {
                Assert.Equal(stage.Keepers[0].BodyPose, other.Keepers[0].BodyPose);
                Assert.True(Snapshot.Same(runner.State, joined.State), $"{Snapshot.Difference(runner.State, joined.State)}");
            }
        }

        Assert.Equal(stage.Keepers[0].Count, other.Keepers[0].Count);
    }

    [Fact]
    public void Broken_bytes_of_a_memory_are_refused()
    {
        (FixedStepRunner runner, BallScene stage) = Match(true);
        KeeperDive keeper = stage.Keepers[0];
        runner.QueueKick(new Vector3d(2.3, 3.4, -21), default);
        while (runner.Tick < 20)
        {
            runner.Step();
        }

        byte[] bytes = keeper.ToBytes(runner.Time);
        foreach ((int at, byte value, string reason) in new[]
        {
            (0, (byte)'X', "they are not the memory of a keeper"),
            (7 + Snapshot.Size + 7, (byte)0x7F, "a position of a keeper is out of range"),
            (7 + Snapshot.Size + 55, (byte)0x41, "an orientation of a keeper is not of length 1"),
            (bytes.Length - Crc32.Size - 1, (byte)0x80, "they end too early"),
        })
        {
            byte[] broken = [.. bytes];
            broken[at] = value;
            Assert.Contains("checksum", Assert.Throws<FormatException>(() => keeper.Restore(broken)).Message, StringComparison.Ordinal);
            Crc32.Seal(broken);
            Assert.Contains(reason, Assert.Throws<FormatException>(() => keeper.Restore(broken)).Message, StringComparison.Ordinal);
        }

        Assert.Equal(bytes, keeper.ToBytes(runner.Time));
    }

    private static (ulong Hash, int Dives) Play(KickInput[] kicks, PlaceInput[] places, int late, bool followsRestarts)
    {
        (FixedStepRunner runner, BallScene stage) = Match(followsRestarts);
        var rollback = new Rollback(runner, Late + 2);
        ulong all = 0;
        for (int tick = 0; tick < Ticks; tick++)
        {
            foreach (PlaceInput place in places.Where(place => place.Tick + (late / 2) == tick))
            {
                rollback.ApplyPlace(in place);
            }

            foreach (KickInput kick in kicks.Where(kick => kick.Tick + late == tick))
            {
                rollback.ApplyKick(in kick);
            }

            runner.Step();

            // Every tick that no later input changes counts.
            all = tick >= Late ? (all * 31) ^ rollback.HashAt(tick - Late) : 0;
        }

        Assert.Null(rollback.SyncTest(Late));
        return ((all * 31) ^ rollback.HashAt(Ticks), stage.Keepers[0].Count);
    }

    private static (FixedStepRunner Runner, BallScene Stage) Match(bool followsRestarts)
    {
        var stage = new BallScene();
        stage.Add(new Goal { Center = new Vector3d(0, 0, -11), Facing = new Vector3d(0, 0, 1) });
        stage.AddKeeper(goal: 0, feet: new Vector3d(0, 0, -10.4));
        stage.Compile();
        var runner = new FixedStepRunner(stage.Game, TimeStep);
        runner.MoveBodies = followsRestarts ? _ => stage.BeforeStep(runner) : _ => stage.BeforeStep(runner.State);
        return (runner, stage);
    }
}
