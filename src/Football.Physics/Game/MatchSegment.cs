namespace Football.Physics.Netcode;

/// <summary>
/// A stretch of a match that can be sent, stored and played again: its start, its kicks, where the game put its bodies, and a hash of the balls after every step.
/// </summary>
/// <remarks>
/// It grows by 8 bytes a step, and where bodies are moved by some 30 to 100 each time. The scene is not part of it, but a hash of it: whoever plays it again must have the same
/// one, and is told so where it is another. Nor are an engine's colliders, which whoever plays it again puts where they were.
/// </remarks>
public sealed class MatchSegment
{
    private const ulong Format = 0x33_47_53_42_46; // "FBSG3"
    private const long LastTick = 1L << 52;
    private const int MostBalls = 10_000;
    private readonly BallState[] _start;
    private readonly RigidMotion[] _motions;
    private ulong[] _hashes;
    private int _count;

    /// <summary>Begins at a runner's present tick.</summary>
    internal MatchSegment(FixedStepRunner runner)
        : this(runner.TimeStep, runner.Tick, [.. runner.States], runner.Kicks, new PlacementLog(), new RigidMotion[runner.Simulator.World.Movers], 1024)
    {
        runner.Simulator.World.ReadMotions(_motions);
        SceneHash = HashOf(runner);
    }

    private MatchSegment(double timeStep, long startTick, BallState[] start, KickLog kicks, PlacementLog bodies, RigidMotion[] motions, int capacity)
    {
        TimeStep = timeStep;
        StartTick = startTick;
        Kicks = kicks;
        Bodies = bodies;
        _start = start;
        _motions = motions;
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

    /// <summary>True when an engine's colliders moved in it: they are not part of it.</summary>
    public bool EngineMoves { get; private set; }

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

    /// <summary>The segment as bytes, the same on every machine.</summary>
    public byte[] ToBytes()
    {
        var kicks = new KickLog();
        for (int i = Kicks.FirstAt(StartTick); i < Kicks.Count && Kicks[i].Tick < EndTick; i++)
        {
            kicks.Add(in Kicks[i]);
        }

        var writer = new ByteWriter();
        writer.Bits(Format, 5);
        writer.Bits(SceneHash, 8);
        writer.Bits((ulong)BitConverter.DoubleToInt64Bits(TimeStep), 8);
        writer.Integer((ulong)StartTick);
        writer.Bits(EngineMoves ? 1UL : 0, 1);
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

        kicks.Write(ref writer);
        Bodies.Write(StartTick, EndTick, ref writer);
        writer.Integer((ulong)_count);
        for (int i = 0; i < _count; i++)
        {
            writer.Bits(_hashes[i], 8);
        }

        return writer.ToArray();
    }

    /// <summary>Reads what <see cref="ToBytes"/> wrote.</summary>
    /// <param name="bytes">The bytes; all of them are used.</param>
    /// <exception cref="FormatException">The bytes are no match segment, or were changed on their way; the message says why.</exception>
    public static MatchSegment FromBytes(ReadOnlySpan<byte> bytes)
    {
        var reader = new ByteReader(bytes);
        if (reader.Bits(5) != Format)
        {
            throw ByteReader.Broken("no match segment starts like this");
        }

        ulong sceneHash = reader.Bits(8);
        double timeStep = BitConverter.Int64BitsToDouble((long)reader.Bits(8));
        long startTick = reader.Long();
        if (startTick > LastTick)
        {
            throw ByteReader.Broken("the first tick is too large");
        }

        bool engineMoves = reader.Bits(1) != 0;
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
        PlacementLog bodies = PlacementLog.Read(ref reader);
        if (bodies.HighestBody() >= motions.Length)
        {
            throw ByteReader.Broken("a body is moved that is none of those at the start");
        }

        int count = reader.Count(sizeof(ulong));
        var segment = new MatchSegment(timeStep, startTick, start, kicks, bodies, motions, count) { SceneHash = sceneHash, EngineMoves = engineMoves };
        for (int i = 0; i < count; i++)
        {
            segment.Add(reader.Bits(8));
        }

        reader.End();
        return segment;
    }

    internal void Add(ulong hash)
    {
        if (_count == _hashes.Length)
        {
            Array.Resize(ref _hashes, _count * 2);
        }

        _hashes[_count++] = hash;
    }

    /// <summary>An engine's colliders moved.</summary>
    internal void MovesEngine() => EngineMoves = true;

    /// <summary>Forgets what came after a tick; false when the states at that tick are not the recorded ones.</summary>
    internal bool TryRewind(long tick, ulong hash)
    {
        if (tick < StartTick || tick > EndTick || HashAt(tick) != hash)
        {
            return false;
        }

        _count = (int)(tick - StartTick);
        Bodies.RemoveFrom(tick);
        return true;
    }

    private double LongestFrame => Math.Max(TimeStep, Math.Min(0.25, TimeStep * (FixedStepRunner.MostSteps / 2)));

    private static ulong HashOf(FixedStepRunner runner)
    {
        ulong hash = 0;
        for (int i = 0; i < runner.Balls; i++)
        {
            ulong own = runner.SimulatorOf(i).SceneHash;
            hash = i == 0 ? own : ((hash ^ own) * 0x9FB21C651E98DF25UL) ^ (hash >> 32);
        }

        return runner.Group is null ? hash : hash ^ Physics.SceneHash.Of(runner.Group.Contact);
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

    private FixedStepRunner Replay(FixedStepRunner runner, Action<double>? bodiesAt)
    {
        ulong hash = HashOf(runner);
        World world = runner.Simulator.World;
        if (runner.Balls != Balls || hash != SceneHash || world.Movers != _motions.Length)
        {
            throw new ArgumentException(
                $"scene has {runner.Balls} balls and the hash {hash:x16}; allowed: that of the segment, {Balls} balls and {SceneHash:x16}: the same scene, with the same settings.");
        }

        if (EngineMoves && bodiesAt is null)
        {
            throw new InvalidOperationException(
                "engineColliders: they moved in the segment, which does not hold them; allowed: bodiesAt, which puts them where they were.");
        }

        for (int i = Kicks.FirstAt(StartTick); i < Kicks.Count && Kicks[i].Tick < EndTick; i++)
        {
            runner.Kicks.Add(in Kicks[i]);
        }

        if (world.Movers > 0)
        {
            world.WriteMotions(_motions);
        }

        runner.KickTicks = Limits.Tick;
        runner.BodiesAt = bodiesAt;
        runner.Script = Bodies;
        runner.RestoreAll(StartTick, _start);
        return runner;
    }
}
