using System.Runtime.InteropServices;
using System.Text;
using FootballPhysics.Package.Tests;
using static FootballPhysics.Native.Tests.SceneCalls;

namespace FootballPhysics.Native.Tests;

/// <summary>The exports of a match, called by their addresses as C calls them.</summary>
public sealed unsafe class MatchTests
{
    private const string Json = """
        {"bodies": [{"name": "leg", "shape": "capsule", "from": [0, -0.4, 0], "to": [0, 0.4, 0], "radius": 0.1, "mass": 2},
                    {"name": "head", "shape": "sphere", "center": [0, 0, 0], "radius": 0.1}],
         "obstacles": [{"name": "bag", "shape": "sphere", "center": [0, 0.3, -3], "radius": 0.3, "mass": 4}]}
        """;

    private static readonly delegate* unmanaged<byte*, long, int, double, NativeMatch**, NativeStatus> s_create = &Exports.MatchCreate;
    private static readonly delegate* unmanaged<NativeMatch*, NativeStatus> s_free = &Exports.MatchFree;
    private static readonly delegate* unmanaged<NativeMatch*, int, byte*, int, NativeStatus> s_name = &Exports.MatchName;
    private static readonly delegate* unmanaged<NativeMatch*, int, double*, NativeStatus> s_place = &Exports.MatchPlace;
    private static readonly delegate* unmanaged<NativeMatch*, int, double*, double*, double*, double*, NativeStatus> s_queuePlace = &Exports.MatchQueuePlace;
    private static readonly delegate* unmanaged<NativeMatch*, int, double*, double*, NativeStatus> s_kick = &Exports.MatchKick;
    private static readonly delegate* unmanaged<NativeMatch*, int, int, NativeBody*, NativeStatus> s_move = &Exports.MatchMoveBodies;
    private static readonly delegate* unmanaged<NativeMatch*, NativeMatchEvent*, int, int*, NativeStatus> s_step = &Exports.MatchStep;
    private static readonly delegate* unmanaged<NativeMatch*, int, int, NativeBall*, NativeStatus> s_balls = &Exports.MatchReadBalls;
    private static readonly delegate* unmanaged<NativeMatch*, int, int, NativeBody*, NativeStatus> s_bodies = &Exports.MatchReadBodies;
    private static readonly delegate* unmanaged<NativeMatch*, int, NativeScene*, NativeState*, NativeStatus> s_state = &Exports.MatchState;
    private static readonly delegate* unmanaged<NativeMatch*, ulong> s_hash = &Exports.MatchHash;
    private static readonly delegate* unmanaged<NativeMatch*, long> s_tick = &Exports.MatchTick;
    private static readonly delegate* unmanaged<NativeMatch*, CByte*, long, long*, NativeStatus> s_save = &Exports.MatchSave;
    private static readonly delegate* unmanaged<NativeMatch*, CByte*, long, NativeStatus> s_restore = &Exports.MatchRestore;
    private static readonly delegate* unmanaged<NativeMatch*, NativeStatus> s_record = &Exports.MatchRecord;
    private static readonly delegate* unmanaged<NativeMatch*, CByte*, long, long*, NativeStatus> s_recording = &Exports.MatchRecording;
    private static readonly delegate* unmanaged<byte*, long, CByte*, long, NativeMatch**, NativeStatus> s_replay = &Exports.MatchReplay;
    private static readonly delegate* unmanaged<NativeMatch*, long, NativeStatus> s_seek = &Exports.MatchSeek;
    private static readonly delegate* unmanaged<NativeMatch*, long*, NativeStatus> s_verify = &Exports.MatchVerify;
    private static readonly delegate* unmanaged<NativeScene*, NativeStatus> s_freeScene = &Exports.SceneFree;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, NativeBall*, NativeStatus> s_read = &Exports.Read;

    /// <summary>Writes the checksum of the library.</summary>
    private static readonly Sealer s_seal = typeof(Scene).Assembly.GetType("FootballPhysics.Game.Crc32", throwOnError: true)!.GetMethod("Seal")!.CreateDelegate<Sealer>();

    private delegate void Sealer(Span<byte> bytes);

    [Fact]
    public void A_hit_leg_receives_the_impulse_that_the_ball_loses()
    {
        NativeMatch* match = Create(Json, 1);
        Shoot(match);
        NativeMatchEvent* events = stackalloc NativeMatchEvent[8];
        byte* name = stackalloc byte[8];
        NativeBody leg;
        int hits = 0;
        for (int tick = 0; tick < 60 && hits == 0; tick++)
        {
            int count;
            Assert.Equal(NativeStatus.Ok, s_step(match, events, 8, &count));
            for (int i = 0; i < count; i++)
            {
                if (events[i].Body != 0)
                {
                    Assert.Equal(-1, events[i].Body);
                    continue;
                }

                hits++;
                Assert.Equal(NativeStatus.Ok, s_name(match, events[i].Event.Thing, name, 8));
                Assert.Equal("leg", Marshal.PtrToStringUTF8((nint)name));
                Assert.Equal(NativeStatus.Ok, s_bodies(match, 0, 1, &leg));
                for (int k = 0; k < 3; k++)
                {
                    // The leg weighs 2 kg, and moved with (0, 0, 3) m/s.
                    double before = k == 2 ? 3 : 0;
                    Assert.Equal(-events[i].Impulse[k], leg.Impulse[k]);
                    Assert.Equal(leg.Impulse[k], 2 * (leg.Velocity[k] - before), 1e-12);
                    Assert.Equal(events[i].Impulse[k], new Scene().Ball.Mass * (events[i].Event.Velocity[k] - events[i].Event.VelocityBefore[k]), 1e-15);
                }
            }
        }

        Assert.Equal(1, hits);
        Assert.Equal(NativeStatus.Ok, s_step(match, null, 0, null));
        Assert.Equal(NativeStatus.Ok, s_bodies(match, 0, 1, &leg));
        Assert.Equal(0, leg.Impulse[2]);
        Assert.Equal(NativeStatus.Ok, s_free(match));
    }

    [Fact]
    public void What_is_out_of_range_is_rejected_by_name_and_changes_nothing()
    {
        NativeMatch* match = Create(Json, 2);
        NativeMatch* none;
        NativeBody* bodies = stackalloc NativeBody[2];
        NativeBall* balls = stackalloc NativeBall[2];
        double* odd = stackalloc double[3] { 0, double.NaN, 0 };
        double* fine = stackalloc double[3] { 0, 1, 0 };
        Shoot(match);
        byte[] before = Saved(match);
        Assert.Equal(NativeStatus.Ok, s_bodies(match, 0, 2, bodies));
        Refused("ball is 2; allowed: 0 … 1.", s_place(match, 2, fine));
        Refused("launch.position is (0, NaN, 0)", s_place(match, 0, odd));
        Refused("position is null", s_place(match, 0, null));
        Refused("ball is -1", s_kick(match, -1, fine, fine));
        Refused("kick.velocity is (0, NaN, 0)", s_kick(match, 0, odd, fine));
        Refused("spin is null", s_kick(match, 0, fine, null));
        Refused("first is -1; allowed: 0 … 2.", s_move(match, -1, 1, bodies));
        Refused("n is 2; allowed: 0 … 1.", s_move(match, 1, 2, bodies));
        Refused("bodies is null", s_move(match, 0, 2, null));
        bodies[0].Position[0] = 17;
        bodies[1].Velocity[1] = 2000;
        Refused("bodies[1].velocity is (0, 2000, 0)", s_move(match, 0, 2, bodies));
        bodies[1].Velocity[1] = 0;
        bodies[1].InPlay = 2;
        Refused("bodies[1].in_play is 2; allowed: 0 or 1.", s_move(match, 0, 2, bodies));
        bodies[1].InPlay = 1;
        bodies[1].Orientation[3] = 0;
        Refused("bodies[1].orientation is", s_move(match, 0, 2, bodies));
        Refused("events is null", s_step(match, null, 4, null));
        Refused("capacity is -1", s_step(match, (NativeMatchEvent*)bodies, -1, null));
        Refused("n is 3; allowed: 0 … 2.", s_balls(match, 0, 3, balls));
        Refused("bodies is null", s_bodies(match, 0, 1, null));
        Refused("n is 3; allowed: " + before.Length, s_restore(match, (CByte*)bodies, 3));
        Refused("balls is 0", Make(Json, 0, 0.01, &none));
        Refused("dt is NaN", Make(Json, 1, double.NaN, &none));
        Assert.Equal(NativeStatus.Scene, Make("""{"bodies": [{"shape": "sphere", "center": [0, 0, 0], "radius": -1}]}""", 1, 0.01, &none));
        Assert.StartsWith("bodies[0].radius is -1; allowed: ", Error());
        Assert.True(none is null);
        Assert.Equal(before, Saved(match));

        // A time that differs from that of the balls is found in the step.
        bodies[1].Orientation[3] = 1;
        bodies[1].Time = 4;
        Assert.Equal(NativeStatus.Ok, s_move(match, 1, 1, bodies + 1));
        Refused("bodies[1].time is 4; allowed: the ball's time before the step, 0 s, ± 0.25 s.", s_step(match, null, 0, null));
        Assert.Equal(0, s_tick(match));
        Assert.Equal(NativeStatus.Ok, s_free(match));
        Assert.Equal(NativeStatus.Handle, s_step(match, null, 0, null));
        Assert.StartsWith("match is not a valid handle, or was freed. Pass a match from fp_match_create.", Error());
    }

    [Fact]
    public void A_restored_match_repeats_its_bits_in_another_match_too()
    {
        NativeMatch* match = Create(Json, 2);
        NativeMatch* other = Create(Json, 2);
        Shoot(match);
        double* aim = stackalloc double[6] { 1, 4, -9, 20, 0, 0 };
        for (int tick = 0; tick < 40; tick++)
        {
            // A kick and moved bodies wait for the next step, and are saved too.
            byte[] saved = Saved(match);
            Assert.Equal(NativeStatus.Ok, Restore(other, saved));
            Assert.Equal(saved, Saved(other));
            Assert.Equal(NativeStatus.Ok, s_step(match, null, 0, null));
            Assert.Equal(NativeStatus.Ok, s_step(other, null, 0, null));
            byte[] after = Saved(match);
            Assert.Equal(after, Saved(other));
            Assert.Equal(NativeStatus.Ok, Restore(match, saved));
            Assert.Equal(NativeStatus.Ok, s_step(match, null, 0, null));
            Assert.Equal(after, Saved(match));
            Assert.Equal(s_hash(match), s_hash(other));
            if (tick % 7 == 3)
            {
                Assert.Equal(NativeStatus.Ok, s_kick(match, 1, aim, aim + 3));
                Move(match, 0.3);
            }
        }

        Assert.Equal(NativeStatus.Ok, s_free(match));
        Assert.Equal(NativeStatus.Ok, s_free(other));
    }

    [Fact]
    public void Changed_bytes_and_those_of_another_match_are_rejected_and_change_nothing()
    {
        NativeMatch* match = Create(Json, 2);
        NativeMatch* other = Create(Json.Replace("\"mass\": 2", "\"mass\": 3"), 2);
        Shoot(match);
        byte[] saved = Saved(match);
        byte[] untouched = Saved(other);
        Assert.Equal(NativeStatus.Argument, Restore(other, saved));
        Assert.StartsWith("bytes belong to another match.", Error());
        Assert.Equal(untouched, Saved(other));
        var random = new Random(3);
        for (int i = 0; i < 2000; i++)
        {
            // Every second time with a valid checksum, so that the values themselves are checked.
            byte[] changed = [.. saved];
            changed[random.Next(changed.Length)] ^= (byte)(1 << random.Next(8));
            if (i % 2 == 0)
            {
                s_seal(changed);
            }

            if (Restore(match, changed) == NativeStatus.Ok)
            {
                // The changed time of a body is found by the step.
                Assert.InRange((int)s_step(match, null, 0, null), (int)NativeStatus.Ok, (int)NativeStatus.Argument);
                Assert.Equal(NativeStatus.Ok, Restore(match, saved));
            }

            Assert.Equal(saved, Saved(match));
        }

        Assert.Equal(NativeStatus.Ok, s_free(match));
        Assert.Equal(NativeStatus.Ok, s_free(other));
    }

    [Fact]
    public void Steps_moves_saves_and_restores_allocate_nothing()
    {
        NativeMatch* match = Create(Json, 2);
        Shoot(match);
        byte[] bytes = Saved(match);
        NativeMatchEvent* events = stackalloc NativeMatchEvent[64];
        NativeBody* bodies = stackalloc NativeBody[2];
        long allocated = 0;
        fixed (byte* at = bytes)
        {
            for (int tick = 0; tick < 400; tick++)
            {
                // The first steps create what is needed later.
                allocated = tick == 200 ? GC.GetAllocatedBytesForCurrentThread() : allocated;
                int count;
                bool done = s_bodies(match, 0, 2, bodies) == NativeStatus.Ok;
                bodies[0].Time = bodies[1].Time = tick / 100.0;
                done &= s_move(match, 0, 2, bodies) == NativeStatus.Ok;
                done &= s_step(match, events, 64, &count) == NativeStatus.Ok;
                done &= s_save(match, (CByte*)at, bytes.Length, null) == NativeStatus.Ok;
                done &= s_restore(match, (CByte*)at, bytes.Length) == NativeStatus.Ok;
                if (!done)
                {
                    Assert.Fail(Error());
                }
            }
        }

        Assert.Equal(allocated, GC.GetAllocatedBytesForCurrentThread());
        Assert.Equal(NativeStatus.Ok, s_free(match));
    }

    [Fact]
    public void A_ball_continues_in_a_scene_without_the_bodies()
    {
        NativeMatch* match = Create(Json, 1);
        NativeScene* scene = Scene("{}");
        Shoot(match);
        NativeState state;
        NativeBall ball;
        NativeBall its;
        for (int tick = 0; tick < 10; tick++)
        {
            Assert.Equal(NativeStatus.Ok, s_step(match, null, 0, null));
        }

        Assert.Equal(NativeStatus.Ok, s_state(match, 0, scene, &state));
        Assert.Equal(NativeStatus.Ok, s_read(scene, &state, &its));
        Assert.Equal(NativeStatus.Ok, s_balls(match, 0, 1, &ball));
        Assert.Equal((ball.Time, ball.Position[2], ball.Velocity[2], ball.Motion), (its.Time, its.Position[2], its.Velocity[2], its.Motion));
        Refused("ball is 1", s_state(match, 1, scene, &state));
        Assert.Equal(NativeStatus.Ok, s_freeScene(scene));
        Assert.Equal(NativeStatus.Handle, s_state(match, 0, scene, &state));
        Assert.StartsWith("scene is not a valid handle", Error());
        Assert.Equal(NativeStatus.Handle, s_state((NativeMatch*)scene, 0, scene, &state));
        Assert.Equal(NativeStatus.Ok, s_free(match));
    }

    [Fact]
    public void A_recording_replays_in_CSharp_and_in_C_and_a_replay_cannot_be_changed()
    {
        NativeMatch* match = Create(Json, 2);
        Refused("match has no recording", Recorded(match, out _));
        Assert.Equal(NativeStatus.Ok, s_record(match));
        Shoot(match);
        for (int tick = 0; tick < 150; tick++)
        {
            Assert.Equal(NativeStatus.Ok, s_step(match, null, 0, null));
        }

        Assert.Equal(NativeStatus.Ok, Recorded(match, out byte[] bytes));
        ulong end = s_hash(match);
        var recording = Recording.FromBytes(bytes);
        Assert.Equal((150, 2), (recording.EndTick, recording.Balls));
        Assert.Null(recording.FirstDivergence(new BallGroup(Requests.Match(Encoding.UTF8.GetBytes(Json), 2, 0.01).Runner.Simulator, 2)));

        NativeMatch* replay;
        long differs;
        double* fine = stackalloc double[3] { 0, 1, 0 };
        Assert.Equal(NativeStatus.Ok, Replay(Json, bytes, &replay));
        Assert.Equal(NativeStatus.Ok, s_verify(replay, &differs));
        Assert.Equal((-1, 150, end), (differs, s_tick(replay), s_hash(replay)));
        Assert.Equal(NativeStatus.Ok, s_seek(replay, 30));
        Assert.Equal(recording.HashAt(30), s_hash(replay));
        Refused("tick is 151; allowed: 0 … 150.", s_seek(replay, 151));
        Refused("match replays a recording", s_place(replay, 0, fine));
        Refused("match replays a recording", s_queuePlace(replay, 0, fine, null, null, null));
        Refused("match replays a recording", s_kick(replay, 0, fine, fine));
        Refused("match replays a recording", s_record(replay));
        Refused("match replays no recording", s_seek(match, 0));
        Refused("match replays no recording", s_verify(match, &differs));
        Assert.Equal(NativeStatus.Ok, s_free(replay));

        Assert.Equal(NativeStatus.Argument, Replay("{}", bytes, &replay));
        Assert.StartsWith("The scene differs from the recorded one", Error());
        bytes[bytes.Length / 2] ^= 1;
        Assert.Equal(NativeStatus.Argument, Replay(Json, bytes, &replay));
        Assert.True(replay is null);
        Assert.Equal(NativeStatus.Ok, s_free(match));
    }

    /// <summary>The restart and the bits of C#: before the kick, the clock and a recording go on, and saved bytes have it.</summary>
    [Fact]
    public void A_restart_is_an_input_of_the_next_step()
    {
        NativeMatch* match = Create("{}", 2);
        var runner = new FixedStepRunner(new BallGroup(new Simulator(), 2), 0.01);
        double* numbers = stackalloc double[13] { 3, 0.5, 4, -8, 3, 1, 0, 6, 0, 0, 2, 0, 2 };
        double* kick = stackalloc double[6] { 0, 1, -20, 0, 10, 0 };
        Assert.Equal(NativeStatus.Ok, s_record(match));
        Assert.Equal(NativeStatus.Ok, s_step(match, null, 0, null));
        Assert.Equal(NativeStatus.Ok, s_kick(match, 0, kick, kick + 3));
        Assert.Equal(NativeStatus.Ok, s_queuePlace(match, 0, numbers + 3, null, null, null));
        Assert.Equal(NativeStatus.Ok, s_queuePlace(match, 0, numbers, null, null, null));
        Assert.Equal(NativeStatus.Ok, s_queuePlace(match, 1, numbers, numbers + 3, numbers + 6, numbers + 9));
        byte[] waiting = Saved(match);
        runner.Step();
        runner.QueueKick(new Vector3d(0, 1, -20), new Vector3d(0, 10, 0), 0);
        runner.QueuePlace(new Vector3d(3, 0.5, 4));
        runner.QueuePlace(new Vector3d(3, 0.5, 4), new Vector3d(-8, 3, 1), new Vector3d(0, 6, 0), new Quaterniond(0, 2, 0, 2), 1);
        ulong[] hashes = new ulong[20];
        for (int i = 0; i < hashes.Length; i++)
        {
            Assert.Equal(NativeStatus.Ok, s_step(match, null, 0, null));
            runner.Step();
            hashes[i] = s_hash(match);
            Assert.Equal(Snapshot.Hash([runner.StateOf(0), runner.StateOf(1)]), hashes[i]);
        }

        Assert.Equal(NativeStatus.Ok, Recorded(match, out byte[] recorded));
        Assert.Equal(2, Recording.FromBytes(recorded).Kicks.PlaceCount);
        Assert.Null(Recording.FromBytes(recorded).FirstDivergence(new BallGroup(new Simulator(), 2)));
        NativeMatch* other = Create("{}", 2);
        Assert.Equal(NativeStatus.Ok, Restore(other, waiting));
        foreach (ulong hash in hashes)
        {
            Assert.Equal(NativeStatus.Ok, s_step(other, null, 0, null));
            Assert.Equal(hash, s_hash(other));
        }

        numbers[12] = double.NaN;
        Refused("place.orientation is ", s_queuePlace(match, 0, numbers, null, null, numbers + 9));
        Refused("ball is 2", s_queuePlace(match, 2, numbers, null, null, null));
        Refused("position is null", s_queuePlace(match, 0, null, null, null, null));
        Assert.Equal(NativeStatus.Ok, s_free(match));
        Assert.Equal(NativeStatus.Ok, s_free(other));
    }

    /// <summary>The bytes of the version before restarts (commit 35f708c9): their format is named, and nothing changes.</summary>
    [Fact]
    public void The_bytes_of_the_earlier_version_are_refused_by_their_format()
    {
        byte[] earlier = File.ReadAllBytes(Path.Combine(Repository.Root, "tests/Football.Physics.Tests/Game/Earlier/match.bin"));
        NativeMatch* match;
        Assert.Equal(NativeStatus.Ok, Make("{}", 1, 1.0 / 60, &match));
        byte[] before = Saved(match);
        Refused("bytes are in the format FPMATCH1 of an earlier version of the library, but this version reads FPMATCH2. Save the match with this version.", Restore(match, earlier));
        Refused("n is 7; allowed: ", Restore(match, earlier[..7]));
        Assert.Equal(before, Saved(match));
        Assert.Equal(NativeStatus.Ok, s_free(match));
    }

    /// <summary>A kick along -z at a leg that comes towards the ball.</summary>
    private static void Shoot(NativeMatch* match)
    {
        double* kick = stackalloc double[6] { 0, 1, -20, 0, 10, 0 };
        Assert.Equal(NativeStatus.Ok, s_kick(match, 0, kick, kick + 3));
        Move(match, 0);
    }

    private static void Move(NativeMatch* match, double aside)
    {
        NativeBody leg;
        NativeBall ball;
        Assert.Equal(NativeStatus.Ok, s_bodies(match, 0, 1, &leg));
        Assert.Equal(NativeStatus.Ok, s_balls(match, 0, 1, &ball));
        leg.Position[0] = aside;
        leg.Position[1] = 0.5;
        leg.Position[2] = -2;
        leg.Velocity[0] = 0;
        leg.Velocity[1] = 0;
        leg.Velocity[2] = 3;
        leg.Time = ball.Time;
        Assert.Equal(NativeStatus.Ok, s_move(match, 0, 1, &leg));
    }

    private static byte[] Saved(NativeMatch* match)
    {
        long size;
        Assert.Equal(NativeStatus.Buffer, s_save(match, null, 0, &size));
        byte[] bytes = new byte[size];
        fixed (byte* at = bytes)
        {
            Assert.Equal(NativeStatus.Ok, s_save(match, (CByte*)at, size, null));
        }

        return bytes;
    }

    private static NativeStatus Restore(NativeMatch* match, byte[] bytes)
    {
        fixed (byte* at = bytes)
        {
            return s_restore(match, (CByte*)at, bytes.Length);
        }
    }

    private static NativeStatus Recorded(NativeMatch* match, out byte[] bytes)
    {
        long size = 0;
        NativeStatus status = s_recording(match, null, 0, &size);
        bytes = new byte[size];
        if (status != NativeStatus.Buffer)
        {
            return status;
        }

        fixed (byte* at = bytes)
        {
            return s_recording(match, (CByte*)at, size, null);
        }
    }

    private static NativeStatus Replay(string json, byte[] recording, NativeMatch** match)
    {
        byte[] text = Encoding.UTF8.GetBytes(json);
        fixed (byte* at = text, bytes = recording)
        {
            return s_replay(at, text.Length, (CByte*)bytes, recording.Length, match);
        }
    }

    private static NativeStatus Make(string json, int balls, double dt, NativeMatch** match)
    {
        byte[] text = Encoding.UTF8.GetBytes(json);
        fixed (byte* at = text)
        {
            return s_create(at, text.Length, balls, dt, match);
        }
    }

    private static NativeMatch* Create(string json, int balls)
    {
        NativeMatch* match;
        Assert.True(Make(json, balls, 0.01, &match) == NativeStatus.Ok, Error());
        return match;
    }

    private static void Refused(string sentence, NativeStatus status) =>
        Assert.Equal((NativeStatus.Argument, sentence), (status, Error()[..Math.Min(sentence.Length, Error().Length)]));
}
