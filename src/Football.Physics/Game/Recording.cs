using System.Globalization;
using System.IO.Compression;
using System.Reflection;
using System.Runtime.InteropServices;
using FootballPhysics.Contacts;
using FootballPhysics.Game;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;
using FootballPhysics.Simulation;

namespace FootballPhysics.Netcode;

/// <summary>A recorded segment of a match that can be stored, sent and replayed.</summary>
/// <remarks>
/// A recording contains the start state, the kicks, the restarts, the positions of the game's bodies, and a hash of the balls after every step. It grows by 8 bytes per step,
/// and by about 30 to 100 bytes for each moved body. Every <see cref="KeyframeTicks"/> ticks, it stores a complete state, from which <see cref="Seek"/>
/// continues. The scene is not included, only its hash: replay it with the same scene; a different scene throws <see cref="ArgumentException"/>. Engine
/// colliders are not included either, so you must position them in a replay.
/// </remarks>
public sealed class Recording
{
    /// <summary>The number of ticks between two keyframes; a seek simulates fewer ticks than this.</summary>
    public const int KeyframeTicks = 64;

    /// <summary>The version of the inputs that peers exchange. Version 2 has restarts.</summary>
    private const int InputFormat = 2;

    private readonly BallState[] _start;
    private readonly RigidMotion[] _motions;
    private readonly Keyframes _keyframes;
    private ulong[] _hashes;
    private int _count;

    /// <summary>Starts a recording at a runner's current tick.</summary>
    internal Recording(FixedStepRunner runner)
        : this(runner.TimeStep, runner.Tick, [.. runner.States], runner.Kicks, new PlacementLog(), new RigidMotion[runner.Simulator.World.Movers], 1024)
    {
        runner.Simulator.World.ReadMotions(_motions);
        SceneHash = HashOf(runner);
        QuantizationInterval = runner.QuantizationInterval;
    }

    internal Recording(double timeStep, long startTick, BallState[] start, KickLog kicks, PlacementLog bodies, RigidMotion[] motions, int capacity)
    {
        TimeStep = timeStep;
        StartTick = startTick;
        Kicks = kicks;
        Bodies = bodies;
        _start = start;
        _motions = motions;
        _keyframes = new Keyframes(start.Length, motions.Length);
        _hashes = new ulong[capacity];
    }

    /// <summary>The length of a step, in s.</summary>
    public double TimeStep { get; }

    /// <summary>The first tick.</summary>
    public long StartTick { get; }

    /// <summary>The end tick: the tick after the last step.</summary>
    public long EndTick => StartTick + _count;

    /// <summary>The state of the first ball at the start.</summary>
    public BallState Start => _start[0];

    /// <summary>The number of balls.</summary>
    public int Balls => _start.Length;

    /// <summary>The combined scene hash of all balls.</summary>
    public ulong SceneHash { get; internal set; }

    /// <summary>The version of the library that made the recording.</summary>
    /// <remarks>A replay is bit-identical only with the same version of the library.</remarks>
    public string Version { get; internal set; } = LibraryVersion;

    /// <summary>The <see cref="FixedStepRunner.QuantizationInterval"/> of the match.</summary>
    public int QuantizationInterval { get; internal set; }

    /// <summary>True if an engine's colliders moved during the recording.</summary>
    /// <remarks>The positions of these colliders are not recorded.</remarks>
    public bool HasMovingColliders { get; internal set; }

    /// <summary>The kicks and restarts; those before <see cref="StartTick"/>, or from <see cref="EndTick"/> on, are ignored.</summary>
    public KickLog Kicks { get; }

    /// <summary>The states and the motions at the start, the hashes of the steps, and the keyframes.</summary>
    internal Span<BallState> StartStates => _start;

    internal Span<RigidMotion> StartMotions => _motions;

    internal Span<ulong> Hashes => _hashes.AsSpan(0, _count);

    internal Keyframes Keyframes => _keyframes;

    /// <summary>The recorded positions of the game's bodies.</summary>
    internal PlacementLog Bodies { get; }

    /// <summary>Returns the hash of the states at a tick.</summary>
    /// <param name="tick">From <see cref="StartTick"/> to <see cref="EndTick"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not part of the segment.</exception>
    public ulong HashAt(long tick)
    {
        Check.Within(nameof(tick), tick, StartTick, EndTick);
        return tick == StartTick ? Snapshot.Hash(_start) : _hashes[(int)(tick - StartTick) - 1];
    }

    /// <summary>Replays the segment and compares every state hash with the recorded one.</summary>
    /// <inheritdoc cref="Replay(Simulator, Action{double})"/>
    /// <returns>The first tick whose states differ from the recording; null if all are bit-identical.</returns>
    public long? FirstDivergence(Simulator simulator, Action<double>? bodiesAt = null) => FirstDivergence(Replay(simulator, bodiesAt));

    /// <summary>Replays a segment with several balls and compares every state hash with the recorded one.</summary>
    /// <inheritdoc cref="Replay(BallGroup, Action{double})"/>
    /// <returns>The first tick whose states differ from the recording; null if all are bit-identical.</returns>
    public long? FirstDivergence(BallGroup group, Action<double>? bodiesAt = null) => FirstDivergence(Replay(group, bodiesAt));

    /// <summary>Creates a runner at the start of the segment; stepping the runner replays the segment.</summary>
    /// <remarks>The runner has the recorded kicks, restarts and body positions.</remarks>
    /// <param name="simulator">The scene of the match, with the same settings.</param>
    /// <param name="bodiesAt">Positions the bodies and an engine's colliders for a given time, in s. Default null: bodies follow the recording.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentException">The scene or its settings differ from those of the recording.</exception>
    /// <exception cref="InvalidOperationException">An engine's colliders moved, and <paramref name="bodiesAt"/> is null.</exception>
    public FixedStepRunner Replay(Simulator simulator, Action<double>? bodiesAt = null) =>
        Replay(new FixedStepRunner(simulator ?? throw new ArgumentNullException(nameof(simulator)), TimeStep, LongestFrame), bodiesAt);

    /// <summary>Creates a runner of several balls at the start of the segment; stepping the runner replays the segment.</summary>
    /// <remarks>The runner has the recorded kicks, restarts and body positions.</remarks>
    /// <param name="group">The balls of the match, with the same scene and settings.</param>
    /// <param name="bodiesAt">Positions the bodies and an engine's colliders for a given time, in s. Default null: bodies follow the recording.</param>
    /// <exception cref="ArgumentNullException"><paramref name="group"/> is null.</exception>
    /// <exception cref="ArgumentException">The scene, the balls or the settings differ from those of the recording.</exception>
    /// <exception cref="InvalidOperationException">An engine's colliders moved, and <paramref name="bodiesAt"/> is null.</exception>
    public FixedStepRunner Replay(BallGroup group, Action<double>? bodiesAt = null) =>
        Replay(new FixedStepRunner(group ?? throw new ArgumentNullException(nameof(group)), TimeStep, LongestFrame), bodiesAt);

    /// <summary>Moves a replay to any tick of the segment, forwards or backwards.</summary>
    /// <remarks>Simulates at most <see cref="KeyframeTicks"/> − 1 steps.</remarks>
    /// <param name="replay">A runner for this segment, from <see cref="Replay(Simulator, Action{double})"/>.</param>
    /// <param name="tick">From <see cref="StartTick"/> to <see cref="EndTick"/>.</param>
    /// <returns>The number of steps simulated.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="replay"/> is null.</exception>
    /// <exception cref="ArgumentException">The runner does not replay this segment; nothing has changed.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not part of the segment; nothing has changed.</exception>
    public int Seek(FixedStepRunner replay, long tick)
    {
        Check.Given(nameof(replay), replay);
        Check.Within(nameof(tick), tick, StartTick, EndTick);
        if (!ReferenceEquals(replay.Script, Bodies))
        {
            throw new ArgumentException("The runner does not belong to this recording. Pass a runner that this recording's Replay returned.", nameof(replay));
        }

        int keyframe = Math.Min((int)((tick - StartTick) / KeyframeTicks), _keyframes.Count);
        long from = StartTick + ((long)keyframe * KeyframeTicks);

        // Continue from the runner's current tick if this tick is in between and its state is the recorded one.
        if (replay.Tick < from || replay.Tick > tick || Snapshot.Hash(replay.States) != HashAt(replay.Tick))
        {
            // Otherwise, start at the last keyframe before the tick. Set the bodies first, because the runner's rollback then restarts from them.
            World world = replay.Simulator.World;
            world.Bodies?.ForgetTimes();
            world.WriteMotions(keyframe == 0 ? _motions : _keyframes.MotionsOf(keyframe - 1));
            replay.RestoreAll(from, keyframe == 0 ? _start : _keyframes.StatesOf(keyframe - 1).ToArray());
        }

        int steps = 0;
        for (; replay.Tick < tick; steps++)
        {
            replay.Step();
        }

        return steps;
    }

    /// <summary>Serialises the segment; the bytes are the same on every machine.</summary>
    public byte[] ToBytes() => RecordingBytes.Write(this);

    /// <summary>Creates a zip file to attach to a bug report.</summary>
    /// <remarks>
    /// The zip file contains <c>match.json</c> (the scene, and the versions of the library, the runtime and the system) and <c>match.segment</c> (the bytes of
    /// <see cref="ToBytes"/>). The command <c>football bundle FILE</c> replays it.
    /// </remarks>
    /// <param name="simulator">The scene of the match, with the same settings.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentException">The scene or its settings differ from those of the recording.</exception>
    /// <exception cref="InvalidOperationException">There are several balls, or a part of the scene is code: a custom force, wind or shape, or an
    /// engine's colliders.</exception>
    public byte[] ToBundle(Simulator simulator)
    {
        if (Balls > 1)
        {
            throw new InvalidOperationException($"The recording has {Balls} balls, but a bundle holds one. Save it with ToBytes instead.");
        }

        Replay(simulator, HasMovingColliders ? static _ => { }
        : null);

        // Write a readable text that can serve as a scenario; the replay uses the segment.
        string about = new SceneText().Begin()
            .Text("library", Version)
            .Text("runtime", RuntimeInformation.FrameworkDescription)
            .Text("system", $"{RuntimeInformation.OSDescription}, {RuntimeInformation.ProcessArchitecture}")
            .Text("sceneHash", SceneHash.ToString("x16", CultureInfo.InvariantCulture))
            .Add(simulator).End().ToString();
        using var memory = new MemoryStream();
        using (var zip = new ZipArchive(memory, ZipArchiveMode.Create, leaveOpen: true))
        {
            Write(zip, "match.json", System.Text.Encoding.UTF8.GetBytes(about));
            Write(zip, "match.segment", ToBytes());
        }

        return memory.ToArray();
    }

    /// <summary>Reads a recording written by <see cref="ToBytes"/>.</summary>
    /// <param name="bytes">The bytes; all of them are used.</param>
    /// <exception cref="FormatException">The bytes are not a recording, or are corrupt; the message states the reason.</exception>
    public static Recording FromBytes(ReadOnlySpan<byte> bytes) => RecordingBytes.Read(bytes);

    /// <summary>Adds the states after a step.</summary>
    internal void Add(BallState[] states, World world)
    {
        Add(Snapshot.Hash(states));

        // Keyframe i contains tick StartTick + 64 (i + 1); the initial state is stored separately.
        if (_count % KeyframeTicks == 0)
        {
            _keyframes.Add(states, world);
        }
    }

    /// <summary>Adds the hash of the next step.</summary>
    internal void Add(ulong hash)
    {
        if (_count == _hashes.Length)
        {
            Array.Resize(ref _hashes, _count * 2);
        }

        _hashes[_count++] = hash;
    }

    /// <summary>Records that an engine's colliders moved.</summary>
    internal void MovesEngine() => HasMovingColliders = true;

    /// <summary>Removes the steps after a tick; returns false if the states at that tick differ from the recorded ones.</summary>
    internal bool TryRewind(long tick, ulong hash)
    {
        if (tick < StartTick || tick > EndTick || HashAt(tick) != hash)
        {
            return false;
        }

        // Discard the later hashes, keyframes and body positions, which belong to the old timeline.
        _count = (int)(tick - StartTick);
        _keyframes.Keep(_count / KeyframeTicks);
        Bodies.RemoveFrom(tick);
        return true;
    }

    /// <summary>The version of this library, without build metadata.</summary>
    private static string LibraryVersion { get; } =
        (typeof(Recording).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion ?? "").Split('+')[0];

    private double LongestFrame => Math.Max(TimeStep, Math.Min(0.25, TimeStep * (FixedStepRunner.MostSteps / 2)));

    private static void Write(ZipArchive zip, string name, byte[] bytes)
    {
        ZipArchiveEntry entry = zip.CreateEntry(name);

        // Use a fixed date, so that the same match yields the same bytes.
        entry.LastWriteTime = new DateTimeOffset(2000, 1, 1, 0, 0, 0, TimeSpan.Zero);
        using Stream file = entry.Open();
        file.Write(bytes);
    }

    /// <summary>Checks the number of keyframes, and each keyframe against the hash of its tick.</summary>
    internal void CheckKeyframes()
    {
        if (_keyframes.Count != _count / KeyframeTicks)
        {
            throw ByteReader.Broken("there are not as many keyframes as the ticks have");
        }

        for (int i = 0; i < _keyframes.Count; i++)
        {
            // A valid keyframe may come from another match, in which case Seek would deviate from the recording.
            if (Snapshot.Hash(_keyframes.StatesOf(i).ToArray()) != _hashes[((i + 1) * KeyframeTicks) - 1])
            {
                throw ByteReader.Broken("a keyframe is not the state of its tick");
            }
        }
    }

    /// <inheritdoc cref="FixedStepRunner.SessionHash"/>
    internal static ulong MatchHash(FixedStepRunner runner)
    {
        var key = new SceneKey();

        // Hash everything that affects a step besides state, inputs and bodies: peers with equal hashes produce bit-identical results.
        key.Add(runner.TimeStep);
        key.Add(runner.QuantizationInterval);
        key.Add(runner.Balls);
        key.Add(InputFormat);
        foreach (char letter in LibraryVersion)
        {
            key.Add(letter);
        }

        return (key.Value ^ HashOf(runner)) * 0x9FB21C651E98DF25UL;
    }

    private static ulong HashOf(FixedStepRunner runner)
    {
        ulong hash = 0;
        for (int i = 0; i < runner.Balls; i++)
        {
            hash = Snapshot.Hash(i, hash, runner.SimulatorOf(i).SceneHash);
        }

        return runner.Group is null ? hash : hash ^ Simulation.SceneHash.Of(runner.Group.Contact);
    }

    private long? FirstDivergence(FixedStepRunner runner)
    {
        while (runner.Tick < EndTick)
        {
            runner.Step();
            if (Snapshot.Hash(runner.States) != HashAt(runner.Tick))
            {
                return runner.Tick;
            }
        }

        return null;
    }

    /// <summary>Sets a runner to the start of the segment, with its inputs and body positions, after checking its scene.</summary>
    private FixedStepRunner Replay(FixedStepRunner runner, Action<double>? bodiesAt)
    {
        // Reject a different scene or different settings now; otherwise, the replay would diverge later without explanation.
        ulong hash = HashOf(runner);
        World world = runner.Simulator.World;
        if (runner.Balls != Balls || hash != SceneHash || world.Movers != _motions.Length || Bodies.HighestBody() >= (world.Bodies?.Count ?? 0))
        {
            throw new ArgumentException(
                $"The scene differs from the recorded one (balls {runner.Balls}, hash {hash:x16}; recorded: balls {Balls}, hash {SceneHash:x16}). Use the same scene and settings.");
        }

        if (HasMovingColliders && bodiesAt is null)
        {
            throw new InvalidOperationException(
                "The recording does not store engine colliders, and some moved. Pass bodiesAt to position them.");
        }

        runner.Kicks.Add(Kicks, StartTick, EndTick);

        // Restore the initial state: bodies and movable obstacles first, then the balls.
        world.WriteMotions(_motions);

        // Keep all kicks, because Seek can return to any tick.
        runner.KickTicks = Limits.Tick;
        runner.QuantizationInterval = QuantizationInterval;
        runner.MoveBodies = bodiesAt;
        runner.Script = Bodies;
        runner.RestoreAll(StartTick, _start);
        return runner;
    }
}
