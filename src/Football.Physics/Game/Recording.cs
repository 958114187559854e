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
/// A recording contains the start state, the kicks, the positions of the game's bodies, and a hash of the balls after every step. It grows by 8 bytes per step,
/// and by about 30 to 100 bytes for each moved body. Every <see cref="KeyframeTicks"/> ticks, it stores a complete state, from which <see cref="Seek"/>
/// continues. The scene is not included, only its hash: replay it with the same scene; a different scene throws <see cref="ArgumentException"/>. Engine
/// colliders are not included either, so you must position them in a replay.
/// </remarks>
public sealed class Recording
{
    /// <summary>The number of ticks between two keyframes; a seek simulates fewer ticks than this.</summary>
    public const int KeyframeTicks = 64;

    private const ulong Format = 0x34_47_53_42_46; // "FBSG4"
    private const ulong AnyFormat = 0x47_53_42_46; // "FBSG"
    private const int LongestVersion = 64;
    private const long LastTick = 1L << 52;
    private const int MostBalls = 10_000;
    private const int MostMovers = 100_000;
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

    private Recording(double timeStep, long startTick, BallState[] start, KickLog kicks, PlacementLog bodies, RigidMotion[] motions, int capacity)
    {
        TimeStep = timeStep;
        StartTick = startTick;
        Kicks = kicks;
        Bodies = bodies;
        _start = start;
        _motions = motions;
        _keyframes = new Keyframes(start.Length, motions.Length);
        _hashes = new ulong[Math.Max(capacity, 1)];
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
    public ulong SceneHash { get; private set; }

    /// <summary>The version of the library that made the recording.</summary>
    /// <remarks>A replay is bit-identical only with the same version of the library.</remarks>
    public string Version { get; private set; } = LibraryVersion;

    /// <summary>The <see cref="FixedStepRunner.QuantizationInterval"/> of the match.</summary>
    public int QuantizationInterval { get; private set; }

    /// <summary>True if an engine's colliders moved during the recording.</summary>
    /// <remarks>The positions of these colliders are not recorded.</remarks>
    public bool HasMovingColliders { get; private set; }

    /// <summary>The kicks; those before <see cref="StartTick"/>, or from <see cref="EndTick"/> on, are ignored.</summary>
    public KickLog Kicks { get; }

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
    /// <remarks>The runner has the recorded kicks and body positions.</remarks>
    /// <param name="simulator">The scene of the match, with the same settings.</param>
    /// <param name="bodiesAt">Positions the bodies and an engine's colliders for a given time, in s. Default null: bodies follow the recording.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentException">The scene or its settings differ from those of the recording.</exception>
    /// <exception cref="InvalidOperationException">An engine's colliders moved, and <paramref name="bodiesAt"/> is null.</exception>
    public FixedStepRunner Replay(Simulator simulator, Action<double>? bodiesAt = null) =>
        Replay(new FixedStepRunner(simulator ?? throw new ArgumentNullException(nameof(simulator)), TimeStep, LongestFrame), bodiesAt);

    /// <summary>Creates a runner of several balls at the start of the segment; stepping the runner replays the segment.</summary>
    /// <remarks>The runner has the recorded kicks and body positions.</remarks>
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
            if (world.Movers > 0)
            {
                world.WriteMotions(keyframe == 0 ? _motions : _keyframes.MotionsOf(keyframe - 1));
            }

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
    public byte[] ToBytes()
    {
        // The runner may have kicks outside the segment: write only kicks inside it.
        var kicks = new KickLog();
        for (int i = Kicks.FirstAt(StartTick); i < Kicks.Count && Kicks[i].Tick < EndTick; i++)
        {
            kicks.Add(in Kicks[i]);
        }

        var writer = new ByteWriter();

        // The header: format, library version, scene hash, time step, first tick, quantisation, and whether an engine moved colliders.
        writer.Bits(Format, 5);
        writer.Integer((ulong)Version.Length);
        foreach (char letter in Version)
        {
            writer.Bits(letter, 1);
        }

        writer.Bits(SceneHash, 8);
        writer.Bits((ulong)BitConverter.DoubleToInt64Bits(TimeStep), 8);
        writer.Integer((ulong)StartTick);
        writer.Integer((ulong)QuantizationInterval);
        writer.Bits(HasMovingColliders ? 1UL : 0, 1);

        // The initial state: the balls, then the bodies and movable obstacles.
        writer.Integer((ulong)_start.Length);
        for (int i = 0; i < _start.Length; i++)
        {
            writer.State(in _start[i]);
        }

        writer.Integer((ulong)_motions.Length);
        for (int i = 0; i < _motions.Length; i++)
        {
            PlacementLog.Write(in _motions[i], ref writer);
        }

        // The inputs: kicks, then body positions.
        kicks.Write(ref writer);
        Bodies.Write(StartTick, EndTick, ref writer);

        // The results: a hash per step, and the keyframes. ToArray appends the checksum.
        writer.Integer((ulong)_count);
        for (int i = 0; i < _count; i++)
        {
            writer.Bits(_hashes[i], 8);
        }

        _keyframes.Write(ref writer);
        return writer.ToArray();
    }

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
    public static Recording FromBytes(ReadOnlySpan<byte> bytes)
    {
        var reader = new ByteReader(bytes);

        // Read in the same order as ToBytes writes. Check each number at once, because the bytes are untrusted.
        ReadFormat(ref reader);
        string version = ReadVersion(ref reader);
        ulong sceneHash = reader.Bits(8);
        double timeStep = BitConverter.Int64BitsToDouble((long)reader.Bits(8));
        long startTick = reader.Long();
        if (startTick > LastTick)
        {
            throw ByteReader.Broken("the first tick is too large");
        }

        int wireTicks = reader.Int();
        bool engineMoves = reader.Bits(1) != 0;

        // Check each count against the number of bytes left, so that a corrupt count does not allocate memory.
        int balls = reader.Count(Snapshot.Size);
        if (balls is 0 or > MostBalls)
        {
            throw ByteReader.Broken("there is no ball, or more than 10 000");
        }

        var start = new BallState[balls];
        for (int i = 0; i < balls; i++)
        {
            start[i] = reader.State();
        }

        try
        {
            // If a runner would reject a value, report the bytes as corrupt.
            Check.Within("wireTicks", wireTicks, 0, FixedStepRunner.MostWireTicks);
            Check.Within("timeStep", timeStep, 0, Limits.Time, exclusiveLow: true);
            Check.Advances("timeStep", timeStep, start[0].Time);
            for (int i = 1; i < balls; i++)
            {
                Check.Within("time of a ball", start[i].Time, start[0].Time, start[0].Time);
            }
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }

        // A motion takes many times more memory than bytes: limit their number too.
        int movers = reader.Count(5);
        if (movers > MostMovers)
        {
            throw ByteReader.Broken("there are more than 100 000 bodies");
        }

        var motions = new RigidMotion[movers];
        for (int i = 0; i < motions.Length; i++)
        {
            motions[i] = PlacementLog.ReadMotion(ref reader);
        }

        KickLog kicks = KickLog.Read(ref reader);
        for (int i = 0; i < kicks.Count; i++)
        {
            if (kicks[i].Ball >= balls)
            {
                throw ByteReader.Broken("a ball is kicked that there is not");
            }
        }

        PlacementLog bodies = PlacementLog.Read(ref reader);

        // Check this now: otherwise, an unknown body index would fail in the middle of a replay.
        if (bodies.HighestBody() >= motions.Length)
        {
            throw ByteReader.Broken("a body is moved that is none of those at the start");
        }

        int count = reader.Count(sizeof(ulong));
        var segment = new Recording(timeStep, startTick, start, kicks, bodies, motions, count) { SceneHash = sceneHash, HasMovingColliders = engineMoves, Version = version, QuantizationInterval = wireTicks };
        for (int i = 0; i < count; i++)
        {
            segment.Add(reader.Bits(8));
        }

        // All hashes are known now: compare the keyframes with them.
        segment._keyframes.Read(ref reader);
        segment.CheckKeyframes();
        reader.End();
        return segment;
    }

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

    private void Add(ulong hash)
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

    private static void ReadFormat(ref ByteReader reader)
    {
        ulong format = reader.Bits(5);
        if (format != Format)
        {
            throw ByteReader.Broken((format & uint.MaxValue) == AnyFormat
                ? $"they are a recording in the format FBSG{(char)(format >> 32)}, but this version of the library reads FBSG4"
                : "a recording does not start like this");
        }
    }

    private static string ReadVersion(ref ByteReader reader)
    {
        int length = reader.Count(1);
        if (length > LongestVersion)
        {
            throw ByteReader.Broken("the name of the library's version is too long");
        }

        var letters = new char[length];
        for (int i = 0; i < length; i++)
        {
            letters[i] = (char)reader.Bits(1);
            if (letters[i] is < ' ' or > '~')
            {
                throw ByteReader.Broken("the name of the library's version is no plain text");
            }
        }

        return new string(letters);
    }

    /// <summary>Checks the number of keyframes, and each keyframe against the hash of its tick.</summary>
    private void CheckKeyframes()
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

        // Hash everything that affects a step besides state, kicks and bodies: peers with equal hashes produce bit-identical results.
        key.Add(runner.TimeStep);
        key.Add(runner.QuantizationInterval);
        key.Add(runner.Balls);
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
            // Mix the hashes in order, so that swapping two balls changes the result. For a single ball, the result is the ball's own hash.
            ulong own = runner.SimulatorOf(i).SceneHash;
            hash = i == 0 ? own : ((hash ^ own) * 0x9FB21C651E98DF25UL) ^ (hash >> 32);
        }

        return runner.Group is null ? hash : hash ^ Simulation.SceneHash.Of(runner.Group.Contact);
    }

    /// <summary>The number of bodies and movable obstacles in the scene.</summary>
    internal int Movers => _motions.Length;

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

    /// <summary>Sets a runner to the start of the segment, with its kicks and body positions, after checking its scene.</summary>
    private FixedStepRunner Replay(FixedStepRunner runner, Action<double>? bodiesAt)
    {
        // Reject a different scene or different settings now; otherwise, the replay would diverge later without explanation.
        ulong hash = HashOf(runner);
        World world = runner.Simulator.World;
        if (runner.Balls != Balls || hash != SceneHash || world.Movers != _motions.Length)
        {
            throw new ArgumentException(
                $"The scene differs from the recorded one (balls {runner.Balls}, hash {hash:x16}; recorded: balls {Balls}, hash {SceneHash:x16}). Use the same scene and settings.");
        }

        if (HasMovingColliders && bodiesAt is null)
        {
            throw new InvalidOperationException(
                "The recording does not store engine colliders, and some moved. Pass bodiesAt to position them.");
        }

        for (int i = Kicks.FirstAt(StartTick); i < Kicks.Count && Kicks[i].Tick < EndTick; i++)
        {
            runner.Kicks.Add(in Kicks[i]);
        }

        // Restore the initial state: bodies and movable obstacles first, then the balls.
        if (world.Movers > 0)
        {
            world.WriteMotions(_motions);
        }

        // Keep all kicks, because Seek can return to any tick.
        runner.KickTicks = Limits.Tick;
        runner.QuantizationInterval = QuantizationInterval;
        runner.MoveBodies = bodiesAt;
        runner.Script = Bodies;
        runner.RestoreAll(StartTick, _start);
        return runner;
    }
}
