using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>
/// Plays ahead of the server, so that what its player does is seen at once and comes in time; what the others do it guesses, and plays again from the first tick in which it guessed wrongly.
/// Two calls of the library do it: the step, and <see cref="Rollback.ResimulateFrom"/>.
/// </summary>
public sealed class Client(int seed, HashLog hashes, string? otherVersion = null)
{
    private const int RollbackTicks = 128;

    /// <summary>So many ticks of inputs are sent at most.</summary>
    private const int MostTicks = 200;

    /// <summary>Its inputs are to come to the server so many ticks before they are needed.</summary>
    private const int LeastSpare = 2;
    private const int MostSpare = 7;

    private readonly Match _match = new();
    private readonly Brain _brain = new(team: 1, seed);
    private readonly View _view = new();
    private Rollback? _rollback;
    private long _confirmed;    // all inputs before this tick are the server's
    private long _serverHas;    // the server has ours before this tick
    private long _spare = (LeastSpare + MostSpare) / 2;
    private long _paceChanged;

    public Corrections Corrections { get; } = new();

    public View View => _view;

    public string? Refused { get; private set; }

    public IReadOnlyList<byte[]> Tick(long now, byte[][] packets)
    {
        foreach (byte[] packet in packets)
        {
            Read(packet);
        }

        if (_rollback is null)
        {
            ulong hash = otherVersion is null ? _match.Runner.SessionHash : 1;
            return now % 10 == 0 && Refused is null ? [Packets.Of(PacketKind.Join, writer => writer.Write(hash))] : [];
        }

        for (int steps = Pace(now); steps > 0 && _match.Tick - _confirmed < RollbackTicks - 2; steps--)
        {
            long tick = _match.Tick;
            _match.SetInput(tick, 1, _brain.Decide(_match, tick));
            _match.SetInput(tick, 0, _match.Guess(tick, 0));
            _match.Advance();
        }

        _view.Draw(_match.Runner.State);
        return
        [
            Packets.Of(PacketKind.Inputs, writer =>
            {
                writer.Write(_confirmed);

                // Not more than a packet and the memory hold: older ones the server has guessed long since.
                writer.WriteInputs(_match, 1, Math.Max(_serverHas, _match.Tick - MostTicks), _match.Tick);
            }),
        ];
    }

    /// <summary>One tick a tick; one more, or none, now and then, where the inputs come too late or too early.</summary>
    private int Pace(long now)
    {
        if (_spare is >= LeastSpare and <= MostSpare || now - _paceChanged < 30)
        {
            return 1;
        }

        _paceChanged = now;
        return _spare < LeastSpare ? 1 + (int)Math.Min(30, LeastSpare + 2 - _spare) : 0;
    }

    private void Read(byte[] packet)
    {
        using var reader = new BinaryReader(new MemoryStream(packet));
        switch ((PacketKind)reader.ReadByte())
        {
            case PacketKind.Refuse:
                Refused = $"another version, scene or step: {reader.ReadUInt64():x16} there";
                break;
            case PacketKind.Welcome when _rollback is null:
                reader.ReadState(_match);
                _confirmed = _serverHas = _match.Tick;
                _rollback = new Rollback(_match.Runner, RollbackTicks, keepsBodies: false);
                _view.Snap(_match.Runner.State);
                break;
            case PacketKind.Inputs when _rollback is not null:
                ReadInputs(reader, _rollback);
                break;
            default:
                break;
        }
    }

    private void ReadInputs(BinaryReader reader, Rollback rollback)
    {
        _serverHas = Math.Max(_serverHas, reader.ReadInt64());
        _spare = reader.ReadInt16();
        (long from, TeamInput[] theirs) = reader.ReadInputs();
        (_, TeamInput[] ours) = reader.ReadInputs();
        long to = Math.Min(from + theirs.Length, _match.Tick);
        if (from > _confirmed)
        {
            _rollback = null;   // what is missing in between the server sends no more: join again
            return;
        }

        if (to <= _confirmed)
        {
            return;     // older than what is known
        }

        long? wrong = null;
        for (long tick = _confirmed; tick < to; tick++)
        {
            bool changes = _match.SetInput(tick, 0, theirs[tick - from]) | _match.SetInput(tick, 1, ours[tick - from]);
            wrong ??= changes ? tick : null;
        }

        for (long tick = to; tick < _match.Tick; tick++)
        {
            bool changes = _match.SetInput(tick, 0, _match.Guess(tick, 0));
            wrong ??= changes ? tick : null;
        }

        long first = _confirmed;
        _confirmed = to;
        if (wrong is { } begin)
        {
            Corrections.Keep(rollback, begin);
            for (long tick = begin; tick < _match.Tick; tick++)
            {
                _match.MovePlayers(tick);
            }

            rollback.ResimulateFrom(begin);
            Corrections.Compare(rollback, begin);
            _view.Corrected(_match.Runner.State);
        }

        for (long tick = first + 1; tick <= to; tick++)
        {
            hashes.Add(tick, rollback.HashAt(tick));
        }

        CheckBall(reader, rollback);
    }

    /// <summary>The server's ball at a tick whose inputs are all known is ours to the last bit, or something is wrong; then it is named, and the server's counts.</summary>
    private void CheckBall(BinaryReader reader, Rollback rollback)
    {
        long tick = reader.ReadInt64();
        byte[] bytes = reader.ReadBytes(reader.ReadByte());
        if (tick < rollback.OldestTick || tick > _confirmed)
        {
            return;
        }

        BallState theirs = bytes.Length == Snapshot.QuantizedSize ? _match.Runner.ReadQuantized(bytes) : Snapshot.Read(bytes);
        Corrections.Checked++;
        if (Snapshot.Difference(theirs, rollback.StateAt(tick)) is { } difference)
        {
            Corrections.Diverged($"tick {tick}, {difference}");
            rollback.ApplyServerState(tick, in theirs);
        }
    }
}
