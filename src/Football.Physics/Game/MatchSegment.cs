namespace Football.Physics.Netcode;

/// <summary>A stretch of a match that can be sent, stored and played again: its start, its kicks, and a hash of the state after every step.</summary>
/// <remarks>It grows by 8 bytes a step. The scene is not part of it: whoever plays it again must have the same one.</remarks>
public sealed class MatchSegment
{
    private const ulong Format = 0x32_47_53_42_46; // "FBSG2"
    private const long LastTick = 1L << 52;
    private ulong[] _hashes;
    private int _count;
    private BallState _start;

    internal MatchSegment(double timeStep, long startTick, in BallState start, KickLog kicks, int capacity = 1024)
    {
        TimeStep = timeStep;
        StartTick = startTick;
        Kicks = kicks;
        _start = start;
        _hashes = new ulong[Math.Max(capacity, 1)];
    }

    /// <summary>Length of a step, s.</summary>
    public double TimeStep { get; }

    /// <summary>The tick at which it starts.</summary>
    public long StartTick { get; }

    /// <summary>The tick after its last step.</summary>
    public long EndTick => StartTick + _count;

    /// <summary>The state at its start.</summary>
    public BallState Start => _start;

    /// <summary>The kicks; those before <see cref="StartTick"/> and from <see cref="EndTick"/> on do not count.</summary>
    public KickLog Kicks { get; }

    /// <summary>The hash of the state at a tick.</summary>
    /// <param name="tick">From <see cref="StartTick"/> to <see cref="EndTick"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not part of the segment.</exception>
    public ulong HashAt(long tick)
    {
        Check.Within(nameof(tick), tick, StartTick, EndTick);
        return tick == StartTick ? Snapshot.Hash(in _start) : _hashes[(int)(tick - StartTick) - 1];
    }

    /// <summary>Plays the segment again and compares.</summary>
    /// <param name="simulator">The scene of the match, with its settings.</param>
    /// <returns>The first tick whose state is not the recorded one to the last bit; null when all are.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public long? FirstDivergence(Simulator simulator)
    {
        FixedStepRunner runner = Replay(simulator);
        while (runner.Tick < EndTick)
        {
            runner.Step();
            if (Snapshot.Hash(runner.State) != HashAt(runner.Tick))
            {
                return runner.Tick;
            }
        }

        return null;
    }

    /// <summary>A runner at the start of the segment, with its kicks: stepping it plays the segment again.</summary>
    /// <param name="simulator">The scene of the match, with its settings.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public FixedStepRunner Replay(Simulator simulator)
    {
        double longestFrame = Math.Max(TimeStep, Math.Min(0.25, TimeStep * (FixedStepRunner.MostSteps / 2)));
        var runner = new FixedStepRunner(simulator ?? throw new ArgumentNullException(nameof(simulator)), TimeStep, longestFrame);
        for (int i = Kicks.FirstAt(StartTick); i < Kicks.Count && Kicks[i].Tick < EndTick; i++)
        {
            runner.Kicks.Add(in Kicks[i]);
        }

        runner.Restore(StartTick, in _start);
        return runner;
    }

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
        writer.Bits((ulong)BitConverter.DoubleToInt64Bits(TimeStep), 8);
        writer.Integer((ulong)StartTick);
        writer.State(in _start);
        kicks.Write(ref writer);
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

        double timeStep = BitConverter.Int64BitsToDouble((long)reader.Bits(8));
        long startTick = reader.Long();
        if (startTick > LastTick)
        {
            throw ByteReader.Broken("the first tick is too large");
        }

        BallState start = reader.State();
        try
        {
            Check.Within("timeStep", timeStep, 0, Limits.Time, exclusiveLow: true);
            Check.Advances("timeStep", timeStep, start.Time);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }

        KickLog kicks = KickLog.Read(ref reader);
        int count = reader.Count(sizeof(ulong));
        var segment = new MatchSegment(timeStep, startTick, in start, kicks, count);
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

    /// <summary>Forgets what came after a tick; false when the state at that tick is not the recorded one.</summary>
    internal bool TryRewind(long tick, in BallState state)
    {
        if (tick < StartTick || tick > EndTick || HashAt(tick) != Snapshot.Hash(in state))
        {
            return false;
        }

        _count = (int)(tick - StartTick);
        return true;
    }
}
