using FootballPhysics.Game;

namespace FootballPhysics.Tests.Game;

/// <summary>A segment is gone to at any tick, in few steps, with the recorded bits.</summary>
public sealed class KeyframeTests
{
    [Fact]
    public void A_replay_of_ninety_minutes_jumps_anywhere_in_fewer_steps_than_a_keyframe_has()
    {
        FixedStepRunner match = Match(players: 0);
        Recording segment = match.Record();
        const int Ticks = 90 * 60 * 60;
        Play(match, Ticks);
        segment = Recording.FromBytes(segment.ToBytes());
        Assert.Equal(Ticks, segment.EndTick);

        FixedStepRunner replay = segment.Replay(Match(players: 0).Simulator);
        var random = new Random(1);
        int most = 0;
        for (int jump = 0; jump < 500; jump++)
        {
            long tick = random.Next(Ticks + 1);
            most = Math.Max(most, segment.Seek(replay, tick));
            Assert.Equal(tick, replay.Tick);
            Assert.Equal(segment.HashAt(tick), Snapshot.Hash(replay.State));
        }

        Assert.InRange(most, Recording.KeyframeTicks / 2, Recording.KeyframeTicks - 1);
        Assert.Equal(0, segment.Seek(replay, 0));
        Assert.Equal(1, segment.Seek(replay, 1));
        Assert.Equal(1, segment.Seek(replay, 2));
        Assert.Equal(Ticks % Recording.KeyframeTicks, segment.Seek(replay, Ticks));
        Assert.Equal(0, segment.Seek(replay, Ticks));
    }

    /// <summary>Players and what they push are where they were, too.</summary>
    [Fact]
    public void A_jump_has_players_and_obstacles_with_a_mass_where_they_were()
    {
        FixedStepRunner match = Match(players: 6);
        Recording segment = match.Record();
        Play(match, 1000);
        Assert.NotEqual(0, Recording.FromBytes(segment.ToBytes()).Replay(Match(6).Simulator).Simulator.World.Obstacles.Count);
        segment = Recording.FromBytes(segment.ToBytes());
        Assert.Null(segment.FirstDivergence(Match(6).Simulator));
        FixedStepRunner replay = segment.Replay(Match(6).Simulator);
        var random = new Random(2);
        for (int jump = 0; jump < 200; jump++)
        {
            long tick = random.Next(1001);
            segment.Seek(replay, tick);
            Assert.Equal(segment.HashAt(tick), Snapshot.Hash(replay.State));
        }

        // And whoever plays on from there has the rest of the match.
        segment.Seek(replay, 500);
        while (replay.Tick < 1000)
        {
            replay.Step();
            Assert.Equal(segment.HashAt(replay.Tick), Snapshot.Hash(replay.State));
        }
    }

    [Fact]
    public void A_rollback_takes_keyframes_back_too()
    {
        FixedStepRunner match = Match(players: 0);
        var rollback = new Rollback(match, 100);
        Recording segment = match.Record();
        Play(match, 200);
        Assert.NotNull(rollback.ApplyKick(new KickInput(110, new Vector3d(2, 3, -9), Vector3d.Zero, 9)));
        Play(match, 300);
        Recording received = Recording.FromBytes(segment.ToBytes());
        FixedStepRunner replay = received.Replay(match.Simulator);
        foreach (long tick in new long[] { 128, 300, 192, 127, 255 })
        {
            received.Seek(replay, tick);
            Assert.Equal(received.HashAt(tick), Snapshot.Hash(replay.State));
        }
    }

    [Fact]
    public void What_is_no_runner_of_the_segment_or_no_tick_of_it_is_refused()
    {
        FixedStepRunner match = Match(players: 0);
        Recording segment = match.Record();
        Play(match, 10);
        FixedStepRunner replay = segment.Replay(match.Simulator);
        Assert.Throws<ArgumentException>(() => segment.Seek(match, 3));
        Assert.Throws<ArgumentOutOfRangeException>(() => segment.Seek(replay, 11));
        Assert.Throws<ArgumentNullException>(() => segment.Seek(null!, 1));
    }

    [Fact]
    public void A_segment_of_another_format_or_with_another_keyframe_is_refused_by_name()
    {
        FixedStepRunner match = Match(players: 0);
        Recording segment = match.Record();
        Play(match, 70);
        byte[] bytes = segment.ToBytes();
        byte[] older = [.. bytes];
        older[4] = (byte)'3';
        Crc32.Seal(older);
        Assert.Contains("format FBSG3, but this version of the library reads FBSG4", Assert.Throws<FormatException>(() => Recording.FromBytes(older)).Message);

        // The place of the one keyframe: the last of the bytes but the checksum.
        byte[] other = [.. bytes];
        int at = bytes.Length - Crc32.Size - Snapshot.Size;
        BallState state = Snapshot.Read(bytes.AsSpan(at));
        state.Position += new Vector3d(1, 0, 0);
        Snapshot.Write(in state, other.AsSpan(at));
        Crc32.Seal(other);
        Assert.Contains("a keyframe is not the state of its tick", Assert.Throws<FormatException>(() => Recording.FromBytes(other)).Message);
        Assert.Matches(@"^\d+\.\d+\.\d+", Recording.FromBytes(bytes).Version);
    }

    private static void Play(FixedStepRunner match, long to)
    {
        while (match.Tick < to)
        {
            if (match.Tick % 240 == 0)
            {
                double side = (match.Tick / 240 % 7) - 3;
                Vector3d home = -0.1 * match.State.Position.Horizontal;
                match.QueueKick(home + new Vector3d(side, 3 + side, 2 * side), new Vector3d(5 * side, 20, 0));
            }

            match.Step();
        }
    }

    private static FixedStepRunner Match(int players)
    {
        if (players == 0)
        {
            return new FixedStepRunner(timeStep: 1.0 / 60);
        }

        var bodies = new KinematicBodies();
        KinematicBody[] all = [.. Enumerable.Range(0, players).Select(_ => bodies.Add("player", BodyKind.Player))];
        Scene scene = Pitch.Standard.On() with
        {
            Bodies = bodies,
            Obstacles = [new Obstacle { Name = "dummy", Shape = new BoxShape(new Vector3d(1, 0.9, -3), new Vector3d(0.3, 0.9, 0.2)), Mass = 20 }],
        };
        return new FixedStepRunner(new Simulator(scene), 1.0 / 60)
        {
            MoveBodies = time =>
            {
                for (int i = 0; i < all.Length; i++)
                {
                    double angle = i + (0.9 * time);
                    all[i].MoveTo(new Vector3d(3 * Math.Cos(angle), 0, 3 * Math.Sin(angle)), new Vector3d(-2.7 * Math.Sin(angle), 0, 2.7 * Math.Cos(angle)), time);
                }
            },
        };
    }
}
