using System.Runtime.InteropServices;
using System.Text;
using static FootballPhysics.Native.Tests.SceneCalls;

namespace FootballPhysics.Native.Tests;

/// <summary>The exports, called by their addresses as C calls them.</summary>
public sealed unsafe class CallTests
{
    private static readonly delegate* unmanaged<byte*, long, NativeScene**, NativeStatus> s_create = &Exports.SceneCreate;
    private static readonly delegate* unmanaged<NativeScene*, NativeStatus> s_free = &Exports.SceneFree;
    private static readonly delegate* unmanaged<NativeScene*, double*, double*, double*, NativeState*, NativeStatus> s_launch = &Exports.Launch;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double*, double*, NativeStatus> s_kick = &Exports.Kick;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double*, double*, double*, double*, NativeStatus> s_place = &Exports.Place;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double, NativeEvent*, int, int*, NativeStatus> s_step = &Exports.Step;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, NativeBall*, NativeStatus> s_read = &Exports.Read;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, long, double, int, NativeStatus> s_stepMany = &Exports.StepMany;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, long, double*, double*, double*, int*, NativeStatus> s_readMany = &Exports.ReadMany;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, long, double, double, int, int*, NativeStatus> s_runMany = &Exports.RunMany;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double, double, double*, long, long*, NativeStatus> s_lookAhead = &Exports.LookAhead;
    private static readonly delegate* unmanaged<NativeScene*, byte*, long, double*, double*, double*, int*, NativeStatus> s_aim = &Exports.Aim;
    private static readonly delegate* unmanaged<NativeScene*, NativeState*, double, double, int, NativeDerivatives*, int*, NativeStatus> s_derivatives = &Exports.DerivativesRun;
    private static readonly delegate* unmanaged<NativeScene*, int, byte*, int, NativeStatus> s_name = &Exports.Name;
    private static readonly delegate* unmanaged<NativeState*, byte*, NativeStatus> s_write = &Exports.SnapshotWrite;
    private static readonly delegate* unmanaged<byte*, NativeState*, NativeStatus> s_readBytes = &Exports.SnapshotRead;
    private static readonly delegate* unmanaged<int, int, int, int, NativeStatus> s_check = &Exports.CheckAbi;
    private static readonly delegate* unmanaged<byte*> s_version = &Exports.Version;
    private static readonly delegate* unmanaged<NativeScene*, NativeEvent*, double> s_added = &Exports.AddedEnergy;
    private static readonly delegate* unmanaged<NativeState*, ulong> s_hash = &Exports.Hash;

    [Theory]
    [InlineData("{\"gravity\": -1}", "gravity is -1; allowed: ")]
    [InlineData("{\"ball\": {\"mas\": 1}}", "ball.mas is unknown")]
    [InlineData("{\"launch\": {}}", "launch is unknown")]
    [InlineData("{\"air\": {\"density\": \"thick\"}}", "air.density is \"thick\"; allowed: ")]
    [InlineData("[1]", "the scenario is [1]; allowed: an object")]
    [InlineData("{", "the input is")]
    [InlineData("", "the input is")]
    [InlineData("{\"solver\": {\"integrator\": \"rk9\"}}", "solver.integrator is \"rk9\"; allowed: ")]
    [InlineData("{\"obstacles\": [{\"shape\": \"sphere\", \"center\": [0, 0, 0], \"radius\": -1}]}", "obstacles[0].radius is -1; allowed: ")]
    [InlineData("{\"air\": {\"weather\": {\"temperature\": 100}}}", "air.weather.temperature is 100; allowed: ")]
    [InlineData("{\"obstacles\": [{\"shape\": \"sphere\", \"center\": [0, 1, -5], \"radius\": 0.1, \"mass\": 3}]}", "obstacles[0].mass is 3; allowed: no mass")]
    public void A_scene_that_is_refused_has_a_sentence_and_no_handle(string json, string sentence)
    {
        NativeScene* scene = (NativeScene*)1;
        Assert.Equal(NativeStatus.Scene, Create(json, &scene));
        Assert.True(scene is null);
        Assert.StartsWith(sentence, Error());
    }

    [Fact]
    public void A_handle_that_was_freed_or_never_was_one_is_refused()
    {
        NativeScene* scene = Scene("{}");
        NativeState state = Launched(scene);
        Assert.Equal(NativeStatus.Ok, s_free(scene));
        foreach (nuint handle in (nuint[])[0, 1, (nuint)scene, (nuint)scene + 1, nuint.MaxValue])
        {
            Assert.Equal(NativeStatus.Handle, s_free((NativeScene*)handle));
            Assert.Equal(NativeStatus.Handle, s_step((NativeScene*)handle, &state, 0.01, null, 0, null));
            Assert.StartsWith("scene is", Error());
        }

        NativeScene* next = Scene("{}");
        Assert.True(next != scene);
        Assert.Equal(NativeStatus.Handle, s_free(scene));
        Assert.Equal(NativeStatus.Ok, s_free(next));
    }

    /// <summary>A placed ball is that of C#, and its clock goes on.</summary>
    [Fact]
    public void A_ball_is_placed_with_any_motion_and_keeps_its_time()
    {
        NativeScene* scene = Scene("{}");
        NativeState state = Launched(scene);
        var simulator = new Simulator();
        Assert.Equal(NativeStatus.Ok, s_step(scene, &state, 0.25, null, 0, null));
        BallState expected = *(BallState*)&state;
        double* numbers = stackalloc double[13] { 3, 2, 4, -8, 3, 1, 0, 6, 0, 0, 2, 0, 2 };
        Assert.Equal(NativeStatus.Ok, s_place(scene, &state, numbers, numbers + 3, numbers + 6, numbers + 9));
        new PlaceInput(0, 0, 0, new Vector3d(3, 2, 4), new Vector3d(-8, 3, 1), new Vector3d(0, 6, 0), new Quaterniond(0, 2, 0, 2)).Apply(simulator, ref expected);
        Assert.Equal((Snapshot.Hash(expected), 0.25), (s_hash(&state), expected.Time));
        Assert.Equal(NativeStatus.Ok, s_place(scene, &state, numbers, null, null, null));
        new PlaceInput(0, 0, 0, new Vector3d(3, 2, 4)).Apply(simulator, ref expected);
        Assert.Equal(Snapshot.Hash(expected), s_hash(&state));
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    [Fact]
    public void Nulls_and_numbers_out_of_range_are_refused_by_name_and_change_nothing()
    {
        NativeScene* scene = Scene("{}");
        NativeState state = Launched(scene);
        NativeState before = state;
        NativeState* none = null;
        NativeBall ball;
        double* odd = stackalloc double[3] { double.NaN, 0, 0 };
        double* fine = stackalloc double[3] { 0, 1, 0 };
        int* numbers = stackalloc int[1];
        NativeEvent* events = stackalloc NativeEvent[1];
        Refused("position is null", s_launch(scene, null, fine, fine, &state));
        Refused("out is null", s_launch(scene, fine, fine, fine, null));
        Refused("launch.position is (NaN, 0, 0)", s_launch(scene, odd, fine, fine, &state));
        Refused("launch.velocity is (NaN, 0, 0)", s_kick(scene, &state, odd, fine));
        Refused("spin is null", s_kick(scene, &state, fine, null));
        Refused("position is null", s_place(scene, &state, null, fine, fine, null));
        Refused("place.spin is (NaN, 0, 0)", s_place(scene, &state, fine, null, odd, null));
        Refused("dt is NaN", s_step(scene, &state, double.NaN, null, 0, null));
        Refused("dt is -1", s_step(scene, &state, -1, null, 0, null));
        Refused("state is null", s_step(scene, null, 0.01, null, 0, null));
        Refused("capacity is -1", s_step(scene, &state, 0.01, events, -1, numbers));
        Refused("events is null", s_step(scene, &state, 0.01, null, 1, numbers));
        Refused("out is null", s_read(scene, &state, null));
        Refused("state is null", s_read(scene, null, &ball));
        Refused("n is -1", s_stepMany(scene, &state, -1, 0.01, 1));
        Refused("states is null", s_stepMany(scene, null, 1, 0.01, 1));
        Refused("steps is -1", s_stepMany(scene, &state, 1, 0.01, -1));
        Refused("dt is Infinity", s_stepMany(scene, &state, 1, double.PositiveInfinity, 1));
        Refused("n is 9223372036854775807", s_readMany(scene, &state, long.MaxValue, null, null, null, null));
        Refused("dt is 0", s_runMany(scene, &state, 1, 0, 1, 0, null));
        Refused("seconds is NaN", s_runMany(scene, &state, 1, 0.01, double.NaN, 0, null));
        Refused("stop_at is 3", s_runMany(scene, &state, 1, 0.01, 1, 3, null));
        Refused("every is 0", s_lookAhead(scene, &state, 1, 0, fine, 1, null));
        Refused("path is null", s_lookAhead(scene, &state, 1, 0.1, null, 1, null));
        Refused("out is null", s_derivatives(scene, &state, 0.01, 1, 0, null, null));
        Refused("bytes is null", s_write(&state, null));
        Refused("json is null", s_create(null, 2, &scene));
        Refused("scene is null", s_create((byte*)fine, 2, null));
        Refused("state is null", s_hash(none) == 0 ? NativeStatus.Argument : NativeStatus.Ok);
        Assert.True(Bytes(before).SequenceEqual(Bytes(state)));
    }

    [Fact]
    public void A_state_that_no_ball_can_have_is_refused_before_any_ball_moves()
    {
        NativeScene* scene = Scene("{}");
        NativeState* states = stackalloc NativeState[3];
        states[0] = states[2] = Launched(scene);
        states[1] = default;
        NativeState before = states[0];
        Assert.Equal(NativeStatus.Argument, s_stepMany(scene, states, 3, 0.01, 1));
        Assert.Equal("states[1] was never launched. Launch the ball first.", Error());
        Assert.True(Bytes(before).SequenceEqual(Bytes(states[0])));

        // A ball that lies on something that the scene does not have.
        NativeScene* other = Scene("{\"obstacles\": [{\"shape\": \"box\", \"center\": [0, 1, 0], \"halfSize\": [5, 1, 5]}]}");
        double* on = stackalloc double[3] { 0, 2.3, 0 };
        double* still = stackalloc double[3];
        Assert.Equal(NativeStatus.Ok, s_launch(other, on, still, still, states));
        Assert.Equal(NativeStatus.Ok, s_stepMany(other, states, 1, 0.05, 200));
        Refused("state.carrier is 1", s_step(scene, states, 0.01, null, 0, null));
        Assert.Equal(NativeStatus.Ok, s_step(other, states, 0.01, null, 0, null));
    }

    [Fact]
    public void Zones_are_told_and_layers_are_ignored()
    {
        NativeScene* scene = Scene(
            "{\"gravity\": [0, 0, 0], \"ball\": {\"ignores\": [3]}, \"obstacles\": [{\"shape\": \"box\", \"center\": [0, 1, -2], \"halfSize\": [3, 3, 0.1], \"layer\": 3}],"
            + "\"zones\": [{\"name\": \"area\", \"shape\": \"plane\", \"point\": [0, 0, -3], \"normal\": [0, 0, 1], \"of\": \"centre\"}]}");
        double* position = stackalloc double[3] { 0, 1, 0 };
        double* velocity = stackalloc double[3] { 0, 0, -20 };
        double* spin = stackalloc double[3];
        NativeState state;
        NativeEvent* events = stackalloc NativeEvent[8];
        int count;
        Assert.Equal(NativeStatus.Ok, s_launch(scene, position, velocity, spin, &state));
        Assert.Equal(NativeStatus.Ok, s_step(scene, &state, 0.5, events, 8, &count));
        Assert.Equal((1, (int)BallEventKind.EnterZone), (count, events[0].Kind));
        Assert.Equal(-3, events[0].Position[2], 1e-9);
    }

    /// <summary>What C computes from the event is what C# reports, at a bumper that moves and turns.</summary>
    [Fact]
    public void A_bumper_s_energy_is_that_of_the_event()
    {
        const string Json = "{\"gravity\": 0, \"obstacles\": [{\"name\": \"wall\", \"shape\": \"box\", \"center\": [0, 0, 9], \"halfSize\": [9, 9, 1]}, {\"name\": \"bumper\", \"shape\": \"box\", "
            + "\"center\": [0, 1, -4], \"halfSize\": [3, 3, 0.5], \"velocity\": [0, 0, 1], \"spin\": [0, 0.4, 0], \"pivot\": [0, 1, -4], \"surface\": {\"normalRestitution\": 1.4}}]}";
        NativeScene* scene = Scene(Json);
        double* position = stackalloc double[3] { 0.5, 1, 0 };
        double* velocity = stackalloc double[3] { 0, 1, -6 };
        double* spin = stackalloc double[3] { 0, 5, 0 };
        NativeState state;
        NativeEvent* events = stackalloc NativeEvent[8];
        int count;
        Assert.Equal(NativeStatus.Ok, s_launch(scene, position, velocity, spin, &state));
        Assert.Equal(NativeStatus.Ok, s_step(scene, &state, 1, events, 8, &count));

        var simulator = new Simulator(Requests.Scene(System.Text.Encoding.UTF8.GetBytes(Json)).Simulator.Scene);
        BallState same = simulator.Launch(new Vector3d(0.5, 1, 0), new Vector3d(0, 1, -6), new Vector3d(0, 5, 0));
        var log = new StepLog();
        simulator.Step(ref same, 1, log);
        Assert.Equal(1, count);
        Assert.True(log.Events[0].AddedEnergy > 5);
        Assert.Equal(log.Events[0].AddedEnergy, s_added(scene, events), 1e-9 * log.Events[0].AddedEnergy);
        events[0].Thing = 1;
        Assert.Equal(0, s_added(scene, events));
        events[0].Thing = 7;
        Assert.Equal(0, s_added(scene, events));
        Assert.Equal(0, s_added(scene, null));
        Assert.Equal("event is null; allowed: a pointer.", Error());
    }

    [Fact]
    public void More_events_than_there_is_room_for_are_counted_and_the_step_is_taken()
    {
        NativeScene* scene = Scene("{}");
        NativeState whole = Launched(scene);
        NativeState cut = whole;
        NativeState unheard = whole;
        NativeEvent* events = stackalloc NativeEvent[64];
        int count;
        int fits;
        Assert.Equal(NativeStatus.Ok, s_step(scene, &whole, 8, events, 64, &count));
        Assert.InRange(count, 3, 64);
        Assert.Equal((int)BallEventKind.Impact, events[0].Kind);
        Assert.True(events[0].VelocityBefore[1] < 0 && events[0].Velocity[1] > 0 && events[0].Normal[1] == 1);
        double first = events[0].Time;
        Assert.Equal(NativeStatus.Buffer, s_step(scene, &cut, 8, events, 1, &fits));
        Assert.StartsWith("capacity is 1; the step had ", Error());
        Assert.Equal(count, fits);
        Assert.Equal(first, events[0].Time);
        Assert.Equal(NativeStatus.Ok, s_step(scene, &unheard, 8, null, 0, null));
        Assert.True(Bytes(whole).SequenceEqual(Bytes(cut)));
        Assert.True(Bytes(whole).SequenceEqual(Bytes(unheard)));
    }

    [Fact]
    public void A_step_allocates_nothing_whatever_is_in_its_way()
    {
        NativeScene* scene = Scene("{\"goals\": [{\"center\": [0, 0, -20], \"facing\": [0, 0, 1]}], \"zones\": [{\"name\": \"area\", \"shape\": \"box\", \"center\": [0, 2, -12], \"halfSize\": [20, 4, 8]}]}");
        NativeState kick = Launched(scene);
        NativeState* states = stackalloc NativeState[4];
        NativeEvent* events = stackalloc NativeEvent[16];
        double* path = stackalloc double[64];
        NativeBall ball;
        int count;
        long before = 0;
        for (int round = 0; round < 3; round++)
        {
            before = GC.GetAllocatedBytesForCurrentThread();
            NativeState state = kick;
            for (int i = 0; i < 600; i++)
            {
                s_step(scene, &state, 1.0 / 60, events, 16, &count);
                s_read(scene, &state, &ball);
            }

            states[0] = states[1] = states[2] = states[3] = kick;
            s_stepMany(scene, states, 4, 1.0 / 60, 300);
            s_readMany(scene, states, 4, path, path + 12, path + 24, null);
            s_lookAhead(scene, &kick, 1, 0.1, path, 16, null);
            s_runMany(scene, states, 4, 1.0 / 60, 3, (int)StopAt.Rest, null);
        }

        Assert.Equal(before, GC.GetAllocatedBytesForCurrentThread());
    }

    [Fact]
    public void Look_ahead_at_the_step_of_the_game_is_the_future()
    {
        NativeScene* scene = Scene("{}");
        NativeState state = Launched(scene);
        double* path = stackalloc double[4 * 121];
        long written;
        Assert.Equal(NativeStatus.Ok, s_lookAhead(scene, &state, 2, 1.0 / 60, path, 121, &written));
        Assert.Equal(121, written);
        for (int i = 0; i < written; i++)
        {
            NativeBall ball;
            s_read(scene, &state, &ball);
            Assert.Equal((ball.Time, ball.Position[0], ball.Position[1], ball.Position[2]), (path[4 * i], path[(4 * i) + 1], path[(4 * i) + 2], path[(4 * i) + 3]));
            s_step(scene, &state, 1.0 / 60, null, 0, null);
        }

        Assert.Equal(NativeStatus.Buffer, s_lookAhead(scene, &state, 2, 0.1, path, 20, &written));
        Assert.Equal((20, "rows is 20; the look-ahead has 21."), (written, Error()));
    }

    [Fact]
    public void Aims_runs_and_derivatives_are_those_of_the_library()
    {
        NativeScene* scene = Scene("{}");
        double* velocity = stackalloc double[3];
        double* spin = stackalloc double[3];
        double miss;
        int verdict;
        byte[] request = Encoding.UTF8.GetBytes("{\"from\": [0, 0.11, 0], \"target\": [2, 1.5, -20], \"speed\": 25, \"spin\": {\"side\": 30}}");
        fixed (byte* json = request)
        {
            Assert.Equal(NativeStatus.Ok, s_aim(scene, json, request.Length, velocity, spin, &miss, &verdict));
            Assert.Equal(NativeStatus.Scene, s_aim(scene, json, request.Length - 1, velocity, spin, &miss, &verdict));
        }

        AimResult expected = new Aimer().Find(new AimRequest { From = new(0, 0.11, 0), Target = new(2, 1.5, -20), Speed = 25, SideSpin = 30 });
        Assert.Equal((expected.Velocity, expected.Spin, expected.Miss, (int)expected.Status), (new Vector3d(velocity[0], velocity[1], velocity[2]), new Vector3d(spin[0], spin[1], spin[2]), miss, verdict));

        var simulator = new Simulator();
        BallState ball = simulator.Launch(new(0, 1, 0), expected.Velocity, expected.Spin);
        BallState again = ball;
        NativeState state = *(NativeState*)&ball;
        NativeState run = state;
        NativeDerivatives derivatives;
        int ended;
        var here = new LaunchDerivatives(simulator);
        Assert.True(here.Run(ref ball, 0.01, 5, StopAt.Impact));
        Assert.Equal(NativeStatus.Ok, s_derivatives(scene, &state, 0.01, 5, (int)StopAt.Impact, &derivatives, &ended));
        Assert.Equal(1, ended);
        Assert.Equal(here.PositionByVelocity.X, new Vector3d(derivatives.PositionByVelocity[0], derivatives.PositionByVelocity[1], derivatives.PositionByVelocity[2]));
        Assert.Equal(here.PositionBySpin.Z, new Vector3d(derivatives.PositionBySpin[6], derivatives.PositionBySpin[7], derivatives.PositionBySpin[8]));
        Assert.Equal(here.TimeBySpin, new Vector3d(derivatives.TimeBySpin[0], derivatives.TimeBySpin[1], derivatives.TimeBySpin[2]));
        Assert.Equal(Snapshot.Hash(in ball), s_hash(&state));
        ended = -1;
        simulator.Run(ref again, 0.01, 5, StopAt.Impact, new StepLog());
        Assert.Equal(NativeStatus.Ok, s_runMany(scene, &run, 1, 0.01, 5, (int)StopAt.Impact, &ended));
        Assert.Equal((1, Snapshot.Hash(in again)), (ended, s_hash(&run)));
    }

    [Fact]
    public void Snapshots_are_those_of_the_library_and_a_changed_one_is_refused()
    {
        NativeScene* scene = Scene("{}");
        NativeState state = Launched(scene);
        NativeState read;
        byte[] mine = new byte[Snapshot.Size];
        byte[] theirs = new byte[Snapshot.Size];
        Snapshot.Write(in *(BallState*)&state, theirs);
        fixed (byte* bytes = mine)
        {
            Assert.Equal(NativeStatus.Ok, s_write(&state, bytes));
            Assert.Equal(NativeStatus.Ok, s_readBytes(bytes, &read));
            Assert.Equal(theirs, mine);
            Assert.True(Bytes(state).SequenceEqual(Bytes(read)));
            bytes[40] ^= 1;
            Assert.Equal(NativeStatus.Argument, s_readBytes(bytes, &read));
        }
    }

    [Fact]
    public void Names_are_cut_where_there_is_no_room()
    {
        NativeScene* scene = Scene("{\"obstacles\": [{\"name\": \"Törwart\", \"shape\": \"sphere\", \"center\": [0, 1, 0], \"radius\": 0.3}]}");
        byte* name = stackalloc byte[16];
        Assert.Equal((NativeStatus.Ok, "ground"), (s_name(scene, 0, name, 16), Marshal.PtrToStringUTF8((nint)name)));
        Assert.Equal((NativeStatus.Ok, "Törwart"), (s_name(scene, 1, name, 16), Marshal.PtrToStringUTF8((nint)name)));
        Assert.Equal((NativeStatus.Buffer, "T"), (s_name(scene, 1, name, 3), Marshal.PtrToStringUTF8((nint)name)));
        Assert.Equal((NativeStatus.Ok, ""), (s_name(scene, -1, name, 1), Marshal.PtrToStringUTF8((nint)name)));
        Refused("thing is 2", s_name(scene, 2, name, 16));
        Refused("capacity is 0", s_name(scene, 0, name, 0));
    }

    [Fact]
    public void Sizes_that_differ_are_told()
    {
        Assert.Equal(NativeStatus.Ok, s_check(Exports.AbiVersion, sizeof(NativeState), sizeof(NativeBall), sizeof(NativeEvent)));
        Assert.Equal(NativeStatus.Abi, s_check(Exports.AbiVersion, sizeof(NativeState) + 8, sizeof(NativeBall), sizeof(NativeEvent)));
        Assert.Contains("(2, 224, 120, 160); allowed: (2, 216, 120, 160)", Error());
        Assert.Matches(@"^\d+\.\d+\.\d+$", Marshal.PtrToStringUTF8((nint)s_version())!);
    }

    [Fact]
    public void An_error_belongs_to_its_thread()
    {
        Assert.Equal(NativeStatus.Handle, s_free(null));
        string? other = null;
        var thread = new Thread(() => other = Error());
        thread.Start();
        thread.Join();
        Assert.Equal("", other);
        Assert.StartsWith("scene is null", Error());
    }

    [Fact]
    public void Without_ground_a_ball_falls_from_the_origin()
    {
        NativeScene* scene = Scene("{\"ground\": {\"surface\": \"none\"}, \"air\": {\"density\": 0}, \"gravity\": 9.81}");
        NativeState state;
        NativeBall ball;
        double* none = stackalloc double[3] { 0, 0, 0 };
        Assert.Equal(NativeStatus.Ok, s_launch(scene, none, none, none, &state));
        Assert.Equal(NativeStatus.Ok, s_stepMany(scene, &state, 1, 0.01, 100));
        Assert.Equal(NativeStatus.Ok, s_read(scene, &state, &ball));
        Assert.Equal(-4.905, ball.Position[1], 1e-9);
        Assert.Equal(NativeStatus.Ok, s_free(scene));
    }

    private static void Refused(string sentence, NativeStatus status)
    {
        Assert.Equal((NativeStatus.Argument, sentence), (status, Error()[..Math.Min(sentence.Length, Error().Length)]));
        Assert.Contains("; allowed: ", Error());
        Assert.DoesNotContain("Parameter", Error());
    }

    private static NativeStatus Create(string json, NativeScene** scene)
    {
        byte[] text = Encoding.UTF8.GetBytes(json + " ");
        fixed (byte* bytes = text)
        {
            return s_create(bytes, text.Length - 1, scene);
        }
    }

    private static NativeState Launched(NativeScene* scene)
    {
        NativeState state;
        double* numbers = stackalloc double[9] { 0, 1, 0, 1, 6, -18, 0, 30, 10 };
        Assert.Equal(NativeStatus.Ok, s_launch(scene, numbers, numbers + 3, numbers + 6, &state));
        return state;
    }

    private static byte[] Bytes(NativeState state) => new ReadOnlySpan<byte>(&state, sizeof(NativeState)).ToArray();
}
