using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Game;

/// <summary>Bytes that the version before restarts wrote (commit 35f708c9) load as they did.</summary>
public sealed class EarlierFormatTests
{
    [Fact]
    public void A_kick_log_loads_and_keeps_its_bytes()
    {
        byte[] bytes = Read("kicks");
        var log = KickLog.FromBytes(bytes);
        Assert.Equal((3, 0), (log.Count, log.PlaceCount));
        Assert.Equal(new KickInput(3, new Vector3d(1, 6, -20), new Vector3d(0, 30, 0), 1), log[0]);
        Assert.Equal(new KickInput(3, new Vector3d(0.1, 2.5, 7), default, 4, 2), log[1]);
        Assert.Equal(new KickInput(90, new Vector3d(-3, 0, 12.25), new Vector3d(0, -12, 0.3)), log[2]);
        Assert.Equal(bytes, log.ToBytes());
        Assert.Equal(0, KickLog.FromBytes(Read("no-kicks")).Count);
    }

    [Fact]
    public void A_recording_loads_and_is_replayed()
    {
        var recording = Recording.FromBytes(Read("recording"));
        Assert.Equal((5L, 75L, 1, 0), (recording.StartTick, recording.EndTick, recording.Kicks.Count, recording.Kicks.PlaceCount));
        Assert.Null(recording.FirstDivergence(new Simulator()));
        var again = Recording.FromBytes(recording.ToBytes());
        Assert.Equal((75L, 1, recording.HashAt(75)), (again.EndTick, again.Kicks.Count, again.HashAt(75)));
    }

    [Fact]
    public void A_recording_of_two_balls_and_a_body_loads()
    {
        var recording = Recording.FromBytes(Read("recording-group"));
        Assert.Equal((12L, 2, 3), (recording.EndTick, recording.Balls, recording.QuantizationInterval));
        var bodies = new KinematicBodies();
        bodies.Add("leg", BodyKind.Boot);
        FixedStepRunner replay = recording.Replay(new BallGroup(new Simulator(new Scene { Bodies = bodies }), 2));
        Assert.Equal(12, recording.Seek(replay, 12));
        Assert.Equal(1.1, bodies[0].Position.X, 1e-12);
    }

    [Fact]
    public void States_load_in_both_forms()
    {
        Assert.Equal(0xba9cf33305bdd0a5, Snapshot.Hash(Snapshot.Read(Read("state"))));
        var runner = new FixedStepRunner(new Simulator(Pitch.Standard.On()), 1.0 / 60) { QuantizationInterval = 6 };
        Assert.Equal(0x48e52802d9f5cd29UL, Snapshot.Hash(runner.ReadQuantized(Read("state-24"))));
    }

    /// <summary>After a touch by a moving object, that version stored limits of the next one: they are gone, and every other field is the same.</summary>
    [Fact]
    public void A_state_just_after_a_touch_loads_without_its_limits()
    {
        byte[] bytes = Read("state-touched");
        Assert.DoesNotContain(0.0, new[] { BitConverter.ToDouble(bytes, 26 * 8), BitConverter.ToDouble(bytes, 27 * 8) });
        BallState state = Snapshot.Read(bytes);
        var again = new byte[Snapshot.Size];
        Snapshot.Write(in state, again);
        Assert.Equal(bytes.Take(26 * 8).Concat(new byte[16]), again.Take(28 * 8));
        var simulator = new Simulator();
        simulator.Validate(in state);
        simulator.Step(ref state, 1.0 / 60, new StepLog());
        Assert.InRange(state.Velocity.Y, 3, 3.6);
    }

    /// <summary>That version named its format FBSG4; a format of a later version is refused by its name.</summary>
    [Fact]
    public void A_recording_of_a_later_format_is_refused_by_its_name()
    {
        byte[] bytes = Read("recording");
        bytes[4] = (byte)'6';
        FootballPhysics.Game.Crc32.Seal(bytes);
        Assert.Equal(
            "The bytes are broken: they are a recording in the format FBSG6, but this version of the library reads FBSG4 and FBSG5.",
            Assert.Throws<FormatException>(() => Recording.FromBytes(bytes)).Message);
    }

    /// <summary>Peers of that version sent this hash for the default match; another one makes them refuse one another at once.</summary>
    [Fact]
    public void The_session_hash_is_another_one()
    {
        Assert.NotEqual(0x59214556e7429bfaUL, new FixedStepRunner(timeStep: 1.0 / 60).SessionHash);
    }

    private static byte[] Read(string name) => File.ReadAllBytes(Path.Combine(RepositoryFiles.Root, "tests/Football.Physics.Tests/Game/Earlier", name + ".bin"));
}
