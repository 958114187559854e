using FootballPhysics.Contacts;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tests.Game;

/// <summary>A jump within a recording restores everything: the balls, the bodies, and the obstacles that a ball has pushed.</summary>
public sealed class SeekTests
{
    private const double TimeStep = 1.0 / 60;

    /// <summary>A recording that starts late, with a body that the game moves now and then, and dummies that the ball pushes.</summary>
    [Theory]
    [InlineData(0, false)]
    [InlineData(0, true)]
    [InlineData(37, true)]
    [InlineData(1000, false)]
    public void Every_tick_is_restored_with_all_that_moves(int start, bool fromBytes)
    {
        const int Steps = 260;
        FixedStepRunner match = Match(out KinematicBody player);
        match.Restore(start, match.State);
        Recording segment = match.Record();
        var states = new List<(BallState State, RigidMotion[] Motions)>();
        for (int i = 0; i <= Steps; i++)
        {
            states.Add((match.State, Motions(match)));
            if (i % 40 == 0)
            {
                match.QueueKick(new Vector3d(0.1, 1, -9 + (i / 40)), new Vector3d(i, 0, 0));
            }

            if (i % 25 == 3)
            {
                player.MoveTo(new Vector3d(1, 0, -1 - (0.01 * i)), new Vector3d(0.1, 0, -0.5), match.Time);
            }

            if (i < Steps)
            {
                match.Step();
            }
        }

        Assert.NotEqual(states[0].Motions[^1].Origin, states[^1].Motions[^1].Origin);
        segment = fromBytes ? Recording.FromBytes(segment.ToBytes()) : segment;
        Assert.Equal((start, start + Steps), (segment.StartTick, segment.EndTick));
        FixedStepRunner replay = segment.Replay(Match(out _).Simulator);
        var random = new Random(start + 1);
        for (int jump = 0; jump < 120; jump++)
        {
            int step = jump < 6 ? jump % 2 * Steps : random.Next(Steps + 1);
            int from = (int)replay.Tick - start;
            int taken = segment.Seek(replay, start + step);
            Assert.Equal(start + step, replay.Tick);
            Assert.Equal(segment.HashAt(start + step), Snapshot.Hash(replay.State));
            Assert.True(Snapshot.Same(states[step].State, replay.State));

            // A jump forwards within a keyframe continues; any other starts at the keyframe before.
            Assert.Equal(from <= step && from >= step / 64 * 64 ? step - from : step % 64, taken);

            // The obstacle has its motion, too: compare where it is at the ball's time.
            Vector3d expected = At(states[step].Motions[^1], states[step].State.Time);
            Assert.InRange(Vector3d.Distance(expected, At(Motions(replay)[^1], replay.Time)), 0, 1e-12);
        }
    }

    [Fact]
    public void A_replay_restores_what_was_pushed_before_it()
    {
        FixedStepRunner match = Match(out _);
        Recording segment = match.Record();
        match.QueueKick(new Vector3d(0, 1, -9), default);
        Play(match, 60);
        Simulator used = match.Simulator;
        RigidMotion[] pushed = Motions(match);
        FixedStepRunner replay = segment.Replay(used);
        Assert.NotEqual(pushed[^1].Velocity, Motions(replay)[^1].Velocity);
        Play(replay, 60);
        Assert.Equal(segment.HashAt(60), Snapshot.Hash(replay.State));
        Assert.Equal(pushed[^1].Origin, Motions(replay)[^1].Origin);
        Assert.Equal(pushed[^1].Velocity, Motions(replay)[^1].Velocity);
    }

    [Fact]
    public void A_kick_after_the_end_of_a_recording_is_no_part_of_it()
    {
        FixedStepRunner match = Match(out _);
        match.Kicks.Add(new KickInput(2, new Vector3d(0, 1, -2), default));
        Play(match, 5);
        Recording segment = match.Record();
        foreach (int tick in new[] { 5, 8, 9, 10, 11 })
        {
            match.Kicks.Add(new KickInput(tick, new Vector3d(0, tick, -1), default));
        }

        Play(match, 10);
        FixedStepRunner replay = segment.Replay(Match(out _).Simulator);
        Assert.Equal([5L, 8, 9], Enumerable.Range(0, replay.Kicks.Count).Select(i => replay.Kicks[i].Tick));
        Assert.Null(segment.FirstDivergence(Match(out _).Simulator));
    }

    [Fact]
    public void A_recording_goes_on_from_its_last_tick_and_ends_at_any_state_that_is_not_recorded()
    {
        FixedStepRunner match = Match(out _);
        Play(match, 5);
        BallState early = match.State;
        match.QueueKick(new Vector3d(0, 3, -2), default);
        Recording segment = match.Record();
        Play(match, 80);
        match.Restore(80, match.State);
        Assert.Same(segment, match.Recording);
        match.Restore(5, in early);
        Assert.Same(segment, match.Recording);
        Assert.Equal(5, segment.EndTick);
        Play(match, 90);
        Assert.Null(Recording.FromBytes(segment.ToBytes()).FirstDivergence(Match(out _).Simulator));
        match.Restore(91, match.State);
        Assert.Null(match.Recording);
        segment = match.Record();
        match.Restore(90, match.State);
        Assert.Null(match.Recording);
        Assert.Equal((91, 91), (segment.StartTick, segment.EndTick));
        foreach (long tick in new long[] { 90, 92 })
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => segment.HashAt(tick));
        }
    }

    [Fact]
    public void A_replay_is_rounded_and_stepped_as_the_match()
    {
        var simulator = new Simulator();
        var match = new FixedStepRunner(simulator, 1.0 / 50, 1) { QuantizationInterval = 3 };
        match.QueueKick(new Vector3d(1, 5, -9), new Vector3d(0, 30, 0));
        Recording segment = match.Record();
        Play(match, 100);
        FixedStepRunner replay = segment.Replay(simulator);
        Assert.Equal((3, 1.0 / 50), (replay.QuantizationInterval, replay.TimeStep));
        Assert.Null(segment.FirstDivergence(simulator));
        Assert.Equal(match.SessionHash, replay.SessionHash);
        Assert.NotEqual(match.SessionHash, new FixedStepRunner(simulator, 1.0 / 50).SessionHash);
        Assert.NotEqual(match.SessionHash, new FixedStepRunner(simulator, 1.0 / 60) { QuantizationInterval = 3 }.SessionHash);
        Assert.NotEqual(match.SessionHash, new FixedStepRunner(new Simulator(new Scene { Gravity = 9.8 }), 1.0 / 50) { QuantizationInterval = 3 }.SessionHash);
        Assert.NotEqual(match.SessionHash, new FixedStepRunner(new BallGroup(simulator, 2), 1.0 / 50) { QuantizationInterval = 3 }.SessionHash);
    }

    /// <summary>Each ball of a group, its place in the group, and the material of their contacts count.</summary>
    [Fact]
    public void Groups_that_differ_in_one_ball_or_their_order_have_other_hashes()
    {
        BallProperties first = BallProperties.Futsal;
        BallProperties second = BallProperties.Tunnel;
        BallGroup[] groups =
        [
            new(new Scene(), [first, second]), new(new Scene(), [second, first]), new(new Scene(), [first, first]), new(new Scene(), [second, second]),
            new(new Scene(), [first, second, first]), new(new Scene(), [first]), new(new Scene(), [first, second], contact: SurfaceMaterial.Board),
            new(new Scene { Gravity = 9.8 }, [first, second]),
        ];
        ulong[] hashes = [.. groups.Select(group => new FixedStepRunner(group).SessionHash)];
        Assert.Equal(groups.Length, hashes.Distinct().Count());
        Assert.Equal(hashes[0], new FixedStepRunner(new BallGroup(new Scene(), [first, second])).SessionHash);
        foreach (BallGroup other in groups[1..])
        {
            Assert.Throws<ArgumentException>(() => new FixedStepRunner(groups[0]).Record().Replay(other));
        }
    }

    /// <summary>A zip file with the scene as text, and with the bytes of the recording.</summary>
    [Fact]
    public void A_bundle_contains_the_recording_and_names_the_scene()
    {
        var match = new FixedStepRunner(new Simulator(new Scene { Gravity = 9.7 }));
        match.QueueKick(new Vector3d(1, 5, -9), default);
        Recording segment = match.Record();
        Play(match, 40);
        byte[] bundle = segment.ToBundle(new Simulator(new Scene { Gravity = 9.7 }));
        using var zip = new System.IO.Compression.ZipArchive(new MemoryStream(bundle));
        Assert.Equal(["match.json", "match.segment"], zip.Entries.Select(entry => entry.FullName));
        Assert.All(zip.Entries, entry => Assert.Equal(new DateTime(2000, 1, 1), entry.LastWriteTime.DateTime));
        using var bytes = new MemoryStream();
        using (Stream stream = zip.Entries[1].Open())
        {
            stream.CopyTo(bytes);
        }

        Assert.Equal(segment.ToBytes(), bytes.ToArray());
        using var reader = new StreamReader(zip.Entries[0].Open());
        string text = reader.ReadToEnd();
        Assert.Contains($"{segment.SceneHash:x16}", text, StringComparison.Ordinal);
        Assert.Contains("9.7", text, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => segment.ToBundle(new Simulator()));
        Assert.Throws<ArgumentNullException>(() => segment.ToBundle(null!));
        var group = new FixedStepRunner(new BallGroup(new Simulator(), 2));
        Assert.Contains("2 balls", Assert.Throws<InvalidOperationException>(() => group.Record().ToBundle(new Simulator())).Message, StringComparison.Ordinal);
    }

    private static Vector3d At(RigidMotion motion, double time) => motion.Origin + ((time - motion.Time) * motion.Velocity);

    private static RigidMotion[] Motions(FixedStepRunner runner)
    {
        World world = runner.Simulator.World;
        var motions = new RigidMotion[world.Movers];
        world.ReadMotions(motions);
        return motions;
    }

    private static void Play(FixedStepRunner runner, long to)
    {
        while (runner.Tick < to)
        {
            runner.Step();
        }
    }

    private static FixedStepRunner Match(out KinematicBody player)
    {
        var bodies = new KinematicBodies();
        player = bodies.Add("player", BodyKind.Player);
        player.MoveTo(new Vector3d(3, 0, 3), Vector3d.Zero, 0);
        return new FixedStepRunner(
            new Simulator(new Scene
            {
                Bodies = bodies,
                Obstacles = [new Obstacle { Name = "dummy", Shape = new BoxShape(new Vector3d(0, 0.9, -3), new Vector3d(1.5, 0.9, 0.2)), Mass = 20 }],
            }),
            TimeStep);
    }
}
