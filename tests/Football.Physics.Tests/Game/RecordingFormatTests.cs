using FootballPhysics.Game;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tests.Game;

/// <summary>The bytes of kicks and recordings: each field comes back, and bytes with a wrong field, although well formed, are refused.</summary>
public sealed class RecordingFormatTests
{
    private const double TimeStep = 1.0 / 60;

    [Fact]
    public void Every_field_of_a_recording_comes_back()
    {
        Recording segment = Segment(balls: 2);
        segment.QuantizationInterval = 7;
        segment.SceneHash = 0x0123_4567_89AB_CDEF;
        segment.Version = new string('9', 64);
        segment.MovesEngine();
        segment.Kicks.Add(new KickInput(4, Vector3d.Up, default, 2, 1));
        segment.Kicks.Add(new KickInput(9, Vector3d.Up, default));
        segment.Kicks.Add(new KickInput(10, Vector3d.Up, default));
        var read = Recording.FromBytes(segment.ToBytes());
        Assert.Equal((7, 0x0123_4567_89AB_CDEFUL, true, new string('9', 64)), (read.QuantizationInterval, read.SceneHash, read.HasMovingColliders, read.Version));
        Assert.Equal((TimeStep, 5L, 10L, 2), (read.TimeStep, read.StartTick, read.EndTick, read.Balls));
        Assert.True(Snapshot.Same(segment.Start, read.Start));
        Assert.Equal(Enumerable.Range(5, 6).Select(tick => segment.HashAt(tick)), Enumerable.Range(5, 6).Select(tick => read.HashAt(tick)));

        // Kicks before the first tick, and from the last tick on, are no part of the segment.
        Assert.Equal(1, read.Kicks.Count);
        Assert.Equal(new KickInput(9, Vector3d.Up, default), read.Kicks[0]);
        Assert.False(Recording.FromBytes(Segment(balls: 1).ToBytes()).HasMovingColliders);
    }

    [Fact]
    public void Fields_that_contradict_each_other_are_refused()
    {
        Recording segment = Segment(balls: 2);
        segment.Kicks.Add(new KickInput(6, Vector3d.Up, default, 0, 2));
        Refused("a ball is kicked that there is not", segment.ToBytes());

        Refused("a body is moved that is none of those at the start", Segment(balls: 1, movers: 1, body: 1).ToBytes());
        Assert.Equal(5, Recording.FromBytes(Segment(balls: 1, movers: 1, body: 0).ToBytes()).StartTick);

        segment = Segment(balls: 1);
        segment.QuantizationInterval = FixedStepRunner.MostWireTicks + 1;
        Refused("wireTicks is ", segment.ToBytes());

        segment = Segment(balls: 3);
        segment.StartStates[1].Time += 1;
        Refused("time of a ball is ", segment.ToBytes());

        segment = Segment(balls: 1);
        segment.Version = new string('9', 65);
        Refused("the name of the library's version is too long", segment.ToBytes());
        segment.Version = "1\t2";
        Refused("the name of the library's version is no plain text", segment.ToBytes());
    }

    /// <summary>The bytes cannot know how many of the moved objects are bodies, so the replay compares that with the scene.</summary>
    [Fact]
    public void A_recording_that_moves_an_obstacle_as_if_it_were_a_body_is_refused_before_the_replay()
    {
        Scene Pushable() => new()
        {
            Bodies = Bodies(1),
            Obstacles = [new Obstacle { Name = "dummy", Shape = new SphereShape(new Vector3d(9, 0.5, 0), 0.5), Mass = 20 }],
        };
        var match = new FixedStepRunner(new Simulator(Pushable()), TimeStep);
        Recording segment = match.Record();
        match.Step();
        Assert.Null(Recording.FromBytes(segment.ToBytes()).FirstDivergence(new Simulator(Pushable())));
        segment.Bodies.Record(0, Told(2));
        var read = Recording.FromBytes(segment.ToBytes());
        Assert.Throws<ArgumentException>(() => read.Replay(new Simulator(Pushable())));
    }

    [Fact]
    public void Bytes_after_the_end_are_refused_also_under_a_correct_checksum()
    {
        var log = new KickLog();
        log.Add(new KickInput(3, Vector3d.Up, default, 1));
        foreach (byte[] bytes in new[] { log.ToBytes(), Segment(balls: 1).ToBytes() })
        {
            byte[] longer = [.. bytes[..^Crc32.Size], 0, .. new byte[Crc32.Size]];
            Crc32.Seal(longer);
            Assert.Throws<FormatException>(() => KickLog.FromBytes(longer));
            Assert.Throws<FormatException>(() => Recording.FromBytes(longer));
        }
    }

    [Fact]
    public void Two_kicks_of_one_player_and_ball_at_one_tick_are_refused()
    {
        byte[] bytes = Two(0);
        Assert.Contains("not in order", Assert.Throws<FormatException>(() => KickLog.FromBytes(bytes)).Message, StringComparison.Ordinal);
        Assert.Equal(2, KickLog.FromBytes(Two(1)).Count);

        static byte[] Two(int secondBall)
        {
            var writer = new ByteWriter();
            writer.Integer(2);
            foreach ((ulong ticks, int ball) in new[] { (5UL, 0), (0UL, secondBall) })
            {
                writer.Integer(ticks);
                writer.Integer(3);
                KickBytes.Write(new KickInput(5, Vector3d.Up, default, 3, ball), ref writer);
            }

            return writer.ToArray();
        }
    }

    [Fact]
    public void A_kick_is_of_a_ball_that_a_match_can_have_and_its_text_is_short()
    {
        foreach (int ball in new[] { -1, 10_000 })
        {
            Assert.StartsWith($"kick.ball is {ball}", Assert.Throws<ArgumentOutOfRangeException>(() => new KickInput(0, default, default, 0, ball)).Message, StringComparison.Ordinal);
        }

        var kick = new KickInput(7, new Vector3d(1.23456, 0, 0), new Vector3d(0, 2.5, 0), 4, 9_999);
        Assert.Equal("tick 7: (1.235, 0, 0) m/s, (0, 2.5, 0) rad/s, player 4", kick.ToString());
        Assert.Contains("1.23456", kick.ToString("R"), StringComparison.Ordinal);
    }

    /// <summary>Only the kicks of the placed ball that are still to come are discarded.</summary>
    [Fact]
    public void A_placed_ball_of_several_loses_its_own_pending_kicks_only()
    {
        var random = new Random(91);
        for (int i = 0; i < 50; i++)
        {
            var runner = new FixedStepRunner(new BallGroup(new Simulator(), 3), TimeStep);
            var kicks = new List<KickInput>();
            for (int k = 0; k < 40; k++)
            {
                var kick = new KickInput(random.Next(8), Vector3d.Up, default, k, random.Next(3));
                kicks.Add(kick);
                runner.Kicks.Add(in kick);
            }

            for (int tick = 0; tick < 3; tick++)
            {
                runner.Step();
            }

            int ball = i % 3;
            runner.Place(new Vector3d(20, 0, 0), ball);
            KickInput[] left = [.. kicks.Where(kick => kick.Ball != ball || kick.Tick < 3).OrderBy(kick => kick.Tick).ThenBy(kick => kick.Player)];
            Assert.Equal(left, Enumerable.Range(0, runner.Kicks.Count).Select(k => runner.Kicks[k]));
        }
    }

    private static void Refused(string reason, byte[] bytes) =>
        Assert.StartsWith($"The bytes are broken: {reason}", Assert.Throws<FormatException>(() => Recording.FromBytes(bytes)).Message, StringComparison.Ordinal);

    /// <summary>Five steps from tick 5, with any kicks and moved objects.</summary>
    private static Recording Segment(int balls, int movers = 0, int body = -1)
    {
        BallState state = new Simulator().Launch(new Vector3d(1, 2, 3), Vector3d.Up, default);
        var log = new PlacementLog();
        if (body >= 0)
        {
            log.Record(6, Told(body + 1));
        }

        RigidMotion still = default;
        still.Orientation = Quaterniond.Identity;
        var segment = new Recording(TimeStep, 5, [.. Enumerable.Repeat(state, balls)], new KickLog(), log, [.. Enumerable.Repeat(still, movers)], 1);
        for (ulong i = 1; i <= 5; i++)
        {
            segment.Add(i * 0x9E37_79B9_7F4A_7C15UL);
        }

        return segment;
    }

    /// <summary>Bodies of which the game has moved the last.</summary>
    private static KinematicBodies Told(int count)
    {
        KinematicBodies bodies = Bodies(count);
        bodies.ForgetTimes();
        RigidMotion motion = bodies[count - 1].Motion;
        bodies.Repeat(count - 1, in motion);
        return bodies;
    }

    private static KinematicBodies Bodies(int count)
    {
        var bodies = new KinematicBodies();
        for (int i = 0; i < count; i++)
        {
            bodies.Add("body", new SphereShape(Vector3d.Zero, 0.2), SurfaceMaterial.Board);
        }

        return bodies;
    }
}
