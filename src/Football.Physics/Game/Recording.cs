using System.Globalization;
using System.IO.Compression;
using System.Reflection;
using System.Runtime.InteropServices;

namespace FootballPhysics.Netcode;

/// <summary>
/// A stretch of a match that can be sent, stored and played again: its start, its kicks, where the game put its bodies, and a hash of the balls after every step.
/// </summary>
/// <remarks>
/// It grows by 8 bytes a step, by a whole state every <see cref="KeyframeTicks"/> of them, from which <see cref="Seek"/> goes on, and where bodies are moved by some 30 to 100 each
/// time. The scene is not part of it, but a hash of it: whoever plays it again must have the same one, and is told so where it is another. Nor are an engine's colliders, which whoever
/// plays it again puts where they were.
/// </remarks>
public sealed class Recording
{
    /// <summary>Ticks from one whole state in a segment to the next: a jump to any tick plays fewer than these.</summary>
    public const int KeyframeTicks = 64;

    private const ulong Format = 0x34_47_53_42_46; // "FBSG4"
    private const ulong AnyFormat = 0x47_53_42_46; // "FBSG"
    private const int LongestVersion = 64;
    private const long LastTick = 1L << 52;
    private const int MostBalls = 10_000;
    private readonly BallState[] _start;
    private readonly RigidMotion[] _motions;
    private readonly Keyframes _keyframes;
    private ulong[] _hashes;
    private int _count;

    /// <summary>Begins at a runner's present tick.</summary>
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

    /// <summary>Length of a step, s.</summary>
    public double TimeStep { get; }

    /// <summary>The tick at which it starts.</summary>
    public long StartTick { get; }

    /// <summary>The tick after its last step.</summary>
    public long EndTick => StartTick + _count;

    /// <summary>The state at its start, of the first of several balls.</summary>
    public BallState Start => _start[0];

    /// <summary>How many balls there are.</summary>
    public int Balls => _start.Length;

    /// <summary>The hash of its scene, with those of all balls.</summary>
    public ulong SceneHash { get; private set; }

    /// <summary>The version of the library that recorded it: bits are those of a version.</summary>
    public string Version { get; private set; } = LibraryVersion;

    /// <summary><see cref="FixedStepRunner.QuantizationInterval"/> of the match.</summary>
    public int QuantizationInterval { get; private set; }

    /// <summary>True when an engine's colliders moved in it: they are not part of it.</summary>
    public bool HasMovingColliders { get; private set; }

    /// <summary>The kicks; those before <see cref="StartTick"/> and from <see cref="EndTick"/> on do not count.</summary>
    public KickLog Kicks { get; }

    /// <summary>Where the game put its bodies.</summary>
    internal PlacementLog Bodies { get; }

    /// <summary>The hash of the states at a tick.</summary>
    /// <param name="tick">From <see cref="StartTick"/> to <see cref="EndTick"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not part of the segment.</exception>
    public ulong HashAt(long tick)
    {
        Check.Within(nameof(tick), tick, StartTick, EndTick);
        return tick == StartTick ? Snapshot.Hash(_start) : _hashes[(int)(tick - StartTick) - 1];
    }

    /// <summary>Plays the segment again and compares.</summary>
    /// <inheritdoc cref="Replay(Simulator, Action{double})"/>
    /// <returns>The first tick whose states are not the recorded ones to the last bit; null when all are.</returns>
    public long? FirstDivergence(Simulator simulator, Action<double>? bodiesAt = null) => FirstDivergence(Replay(simulator, bodiesAt));

    /// <summary>Plays the segment of several balls again and compares.</summary>
    /// <inheritdoc cref="Replay(BallGroup, Action{double})"/>
    /// <returns>The first tick whose states are not the recorded ones to the last bit; null when all are.</returns>
    public long? FirstDivergence(BallGroup group, Action<double>? bodiesAt = null) => FirstDivergence(Replay(group, bodiesAt));

    /// <summary>A runner at the start of the segment, with its kicks, and the bodies where they were: stepping it plays the segment again.</summary>
    /// <param name="simulator">The scene of the match, with its settings.</param>
    /// <param name="bodiesAt">Puts bodies, and an engine's colliders, to where they were at a time, s; default none: bodies are put where the segment says.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentException">The scene, or its settings, are not those of the segment.</exception>
    /// <exception cref="InvalidOperationException">An engine's colliders moved, and nothing says where they were.</exception>
    public FixedStepRunner Replay(Simulator simulator, Action<double>? bodiesAt = null) =>
        Replay(new FixedStepRunner(simulator ?? throw new ArgumentNullException(nameof(simulator)), TimeStep, LongestFrame), bodiesAt);

    /// <summary>A runner of several balls at the start of the segment, with its kicks, and the bodies where they were: stepping it plays the segment again.</summary>
    /// <param name="group">The balls of the match, in its scene, with its settings.</param>
    /// <param name="bodiesAt">Puts bodies, and an engine's colliders, to where they were at a time, s; default none: bodies are put where the segment says.</param>
    /// <exception cref="ArgumentNullException"><paramref name="group"/> is null.</exception>
    /// <exception cref="ArgumentException">The scene, the balls, or the settings are not those of the segment.</exception>
    /// <exception cref="InvalidOperationException">An engine's colliders moved, and nothing says where they were.</exception>
    public FixedStepRunner Replay(BallGroup group, Action<double>? bodiesAt = null) =>
        Replay(new FixedStepRunner(group ?? throw new ArgumentNullException(nameof(group)), TimeStep, LongestFrame), bodiesAt);

    /// <summary>Goes to any tick of the segment, forwards or back: at most <see cref="KeyframeTicks"/> − 1 steps are played again.</summary>
    /// <param name="replay">A runner of this segment, from <see cref="Replay(Simulator, Action{double})"/>.</param>
    /// <param name="tick">From <see cref="StartTick"/> to <see cref="EndTick"/>.</param>
    /// <returns>How many steps were played again.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="replay"/> is null.</exception>
    /// <exception cref="ArgumentException">The runner plays no segment, or another one; nothing has changed.</exception>
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

        // Played on from where the runner is, if that lies between and is a state of the segment.
        if (replay.Tick < from || replay.Tick > tick || Snapshot.Hash(replay.States) != HashAt(replay.Tick))
        {
            // Else from the last keyframe before. Bodies first: a rollback that follows the runner begins anew with what is there.
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

    /// <summary>The segment as bytes, the same on every machine.</summary>
    public byte[] ToBytes()
    {
        // The runner may have kicks from before and after: only those of the segment are written.
        var kicks = new KickLog();
        for (int i = Kicks.FirstAt(StartTick); i < Kicks.Count && Kicks[i].Tick < EndTick; i++)
        {
            kicks.Add(in Kicks[i]);
        }

        var writer = new ByteWriter();

        // Head: format, library version, hash of the scene, length of a step, first tick, rounding, whether an engine moved its colliders.
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

        // The start: the balls, then all that is moved.
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

        // What happened: kicks, then where the game put its bodies.
        kicks.Write(ref writer);
        Bodies.Write(StartTick, EndTick, ref writer);

        // What came of it: a hash after every step, and keyframes. ToArray adds the checksum of all.
        writer.Integer((ulong)_count);
        for (int i = 0; i < _count; i++)
        {
            writer.Bits(_hashes[i], 8);
        }

        _keyframes.Write(ref writer);
        return writer.ToArray();
    }

    /// <summary>
    /// A zip file to attach to an issue: <c>match.json</c> with the scene and the versions of library, runtime and system, and <c>match.segment</c>, the bytes of <see cref="ToBytes"/>.
    /// <c>football bundle FILE</c> plays it again.
    /// </summary>
    /// <param name="simulator">The scene of the match, with its settings.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentException">The scene, or its settings, are not those of the segment.</exception>
    /// <exception cref="InvalidOperationException">There are several balls, or the scene has something that is code: a force, a wind, a shape of the game's own, an engine's colliders.</exception>
    public byte[] ToBundle(Simulator simulator)
    {
        if (Balls > 1)
        {
            throw new InvalidOperationException($"The recording has {Balls} balls, but a bundle holds one. Save it with ToBytes instead.");
        }

        Replay(simulator, HasMovingColliders ? static _ => { }
        : null);

        // A text for people, which a scenario can be made of; what is played again is the segment beside it.
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

    /// <summary>Reads what <see cref="ToBytes"/> wrote.</summary>
    /// <param name="bytes">The bytes; all of them are used.</param>
    /// <exception cref="FormatException">The bytes are no match segment, or were changed on their way; the message says why.</exception>
    public static Recording FromBytes(ReadOnlySpan<byte> bytes)
    {
        var reader = new ByteReader(bytes);

        // In the order of ToBytes; each number is checked as it is read, for the bytes may come from anywhere.
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

        // A count is checked against the bytes that are left, so that a broken one asks for no memory.
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
            // What a runner would refuse is refused here, as broken bytes.
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

        var motions = new RigidMotion[reader.Count(5)];
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

        // An index that no body has would only be met in the middle of a replay.
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

        // The hashes are known by now, so that the keyframes can be compared with them.
        segment._keyframes.Read(ref reader);
        segment.CheckKeyframes();
        reader.End();
        return segment;
    }

    /// <summary>Adds the states after a step.</summary>
    internal void Add(BallState[] states, World world)
    {
        Add(Snapshot.Hash(states));

        // Keyframe i is of tick StartTick + 64 (i + 1): the start itself is kept apart.
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

    /// <summary>An engine's colliders moved.</summary>
    internal void MovesEngine() => HasMovingColliders = true;

    /// <summary>Forgets what came after a tick; false when the states at that tick are not the recorded ones.</summary>
    internal bool TryRewind(long tick, ulong hash)
    {
        if (tick < StartTick || tick > EndTick || HashAt(tick) != hash)
        {
            return false;
        }

        // Hashes, keyframes and bodies from there on are of a way that was not gone.
        _count = (int)(tick - StartTick);
        _keyframes.Keep(_count / KeyframeTicks);
        Bodies.RemoveFrom(tick);
        return true;
    }

    /// <summary>The version of this library, without what a build adds.</summary>
    private static string LibraryVersion { get; } =
        (typeof(Recording).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()?.InformationalVersion ?? "").Split('+')[0];

    private double LongestFrame => Math.Max(TimeStep, Math.Min(0.25, TimeStep * (FixedStepRunner.MostSteps / 2)));

    private static void Write(ZipArchive zip, string name, byte[] bytes)
    {
        ZipArchiveEntry entry = zip.CreateEntry(name);

        // One date for all, so that the same match gives the same bytes.
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

    /// <summary>A keyframe is the state of its tick, and there are as many as the ticks have.</summary>
    private void CheckKeyframes()
    {
        if (_keyframes.Count != _count / KeyframeTicks)
        {
            throw ByteReader.Broken("there are not as many keyframes as the ticks have");
        }

        for (int i = 0; i < _keyframes.Count; i++)
        {
            // A keyframe with a valid checksum of its own may still be of another match: Seek would land beside the recording.
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

        // All that a step depends on besides state, kicks and bodies: two peers with the same hash make the same bits.
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
            // Mixed in order, so that two balls that are exchanged give another hash; one ball has its own.
            ulong own = runner.SimulatorOf(i).SceneHash;
            hash = i == 0 ? own : ((hash ^ own) * 0x9FB21C651E98DF25UL) ^ (hash >> 32);
        }

        return runner.Group is null ? hash : hash ^ FootballPhysics.SceneHash.Of(runner.Group.Contact);
    }

    /// <summary>How many bodies and obstacles that have a mass the scene has.</summary>
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

    private FixedStepRunner Replay(FixedStepRunner runner, Action<double>? bodiesAt)
    {
        // Another scene, or other settings, would only end in a divergence that nobody could explain.
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

        // All that is moved, then the balls, as they were at the start.
        if (world.Movers > 0)
        {
            world.WriteMotions(_motions);
        }

        // No kick is forgotten: Seek goes back to any tick.
        runner.KickTicks = Limits.Tick;
        runner.QuantizationInterval = QuantizationInterval;
        runner.MoveBodies = bodiesAt;
        runner.Script = Bodies;
        runner.RestoreAll(StartTick, _start);
        return runner;
    }
}
