using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>
/// Plays ahead of the server, so that the actions of its own team show immediately and reach the server in time. It guesses the inputs of the other team, and replays from
/// the first tick that it guessed wrongly. It needs two calls of the library: the step, and <see cref="Rollback.ResimulateFrom"/>.
/// </summary>
public sealed class Client(int seed, HashLog hashes, string? otherVersion = null)
{
    private const int RollbackTicks = 128;

    /// <summary>The maximum number of ticks whose inputs it sends.</summary>
    private const int MostTicks = 200;

    /// <summary>The minimum number of ticks by which its inputs should reach the server before they are due.</summary>
    private const int LeastSpare = 2;
    private const int MostSpare = 7;

    private readonly Match _match = new();
    private readonly Brain _brain = new(team: 1, seed);
    private readonly View _view = new();
    private Rollback? _rollback;
    private long _confirmed;    // the server's inputs before this tick are known
    private long _serverHas;    // the server has our inputs before this tick
    private long _spare = (LeastSpare + MostSpare) / 2;
    private long _paceChanged;
    private int _joins;

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
            return now % 10 == 0 && Refused is null ? [Packets.OfJoin(hash, _joins)] : [];
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

                // Send no more than a packet and the memory hold. The server has already guessed older inputs.
                writer.WriteInputs(_match, 1, Math.Max(_serverHas, _match.Tick - MostTicks), _match.Tick);
            }),
        ];
    }

    /// <summary>Returns the number of ticks to play now: usually 1; more if the inputs reach the server too late, 0 if they arrive too early.</summary>
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
            _rollback = null;   // the server no longer sends the inputs in between: join again
            _joins++;
            return;
        }

        if (to <= _confirmed)
        {
            return;     // older than the known inputs
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
            PlayAgain(rollback, begin);
        }

        for (long tick = first + 1; tick <= to; tick++)
        {
            // This tick is final: all inputs before it are known. The referee judges it, as the one of the server does.
            BallState final = rollback.StateAt(tick);
            if (_match.Referee.Judge(in final) is { } restart)
            {
                _match.Runner.Kicks.Add(in restart);
                if (restart.Tick <= _match.Tick)
                {
                    PlayAgain(rollback, restart.Tick - 1, isRestart: true);
                }
            }

            hashes.Add(tick, rollback.HashAt(tick), _match.Referee.Now);
        }

        CheckBall(reader, rollback);
    }

    /// <summary>Plays again from a tick: first the players, then the ball. The events of the old ticks are replaced.</summary>
    private void PlayAgain(Rollback rollback, long begin, bool isRestart = false)
    {
        Corrections.Keep(rollback, begin);
        for (long tick = begin; tick < _match.Tick; tick++)
        {
            _match.MovePlayers(tick);
        }

        _match.TakeBack(rollback.StateAt(begin).Time);
        rollback.ResimulateFrom(begin);
        _match.Keep(rollback.Events);
        Corrections.Compare(rollback, begin, isRestart);
        _view.Corrected(_match.Runner.State);
    }

    /// <summary>Compares the server's ball with ours at a tick whose inputs are all known. If they are not bit-identical, reports the difference, and takes over the server's ball.</summary>
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
