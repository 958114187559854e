using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>
/// The authority of the match. It never rolls back: it replaces late inputs by guesses, and sends the inputs that it used to the client. It plays a team itself, as an opponent.
/// </summary>
public sealed class Server(int seed, HashLog hashes)
{
    /// <summary>The number of ticks between two packets to the client.</summary>
    private const int SendEvery = 2;

    /// <summary>The number of ticks without a packet after which a client counts as absent: its players stop.</summary>
    private const int Silence = 60;

    private readonly Match _match = new();
    private readonly Brain _brain = new(team: 0, seed);
    private long _received;     // inputs of the client before this tick are known
    private long _confirmed;    // the client has all inputs before this tick
    private long _heard = -1;
    private long _spare;
    private bool _joins;
    private long _attempt;
    private ulong _otherHash;
    private byte[] _ball = [];
    private long _ballTick;

    public string Score => _match.Referee.Summary;

    public int Late { get; private set; }

    public int Strips { get; private set; }

    /// <summary>The number of balls sent in 24 bytes.</summary>
    public int Short { get; private set; }

    public int Whole { get; private set; }

    public IReadOnlyList<byte[]> Tick(long now, byte[][] packets)
    {
        foreach (byte[] packet in packets)
        {
            Read(now, packet);
        }

        long tick = _match.Tick;
        _match.SetInput(tick, 0, Checked(_brain.Decide(_match, tick), tick));
        if (tick >= _received)
        {
            Late += _heard >= 0 && now - _heard <= Silence ? 1 : 0;
            _match.SetInput(tick, 1, now - _heard > Silence ? TeamInput.Stand : _match.Guess(tick, 1));
        }
        else
        {
            _match.SetInput(tick, 1, Checked(_match.InputAt(tick, 1), tick));
        }

        _match.Advance();

        // A tick of the server is final at once.
        BallState played = _match.Runner.State;
        if (_match.Referee.Judge(in played) is { } restart)
        {
            _match.Runner.Kicks.Add(in restart);
        }

        hashes.Add(_match.Tick, Snapshot.Hash(played), _match.Referee.Now);
        if (_match.Tick % Match.WireTicks == 0)
        {
            // Send the ball at this tick in 24 bytes. In a net, or between two feet, it needs a complete snapshot.
            BallState ball = _match.Runner.State;
            _ball = new byte[Snapshot.QuantizedSize];
            Short++;
            if (!_match.Runner.TryWriteQuantized(in ball, _ball))
            {
                Short--;
                Whole++;
                _ball = new byte[Snapshot.Size];
                Snapshot.Write(in ball, _ball);
            }

            _ballTick = _match.Tick;
        }

        return Answer();
    }

    private List<byte[]> Answer()
    {
        if (_otherHash != 0)
        {
            return [Packets.Of(PacketKind.Refuse, writer => writer.Write(_match.Runner.SessionHash))];
        }

        if (_joins)
        {
            return [Packets.Of(PacketKind.Welcome, writer => writer.WriteState(_match, _match.Tick, _match.Runner.State))];
        }

        if (_heard < 0 || _match.Tick % SendEvery != 0)
        {
            return [];
        }

        return
        [
            Packets.Of(PacketKind.Inputs, writer =>
            {
                writer.Write(_received);
                writer.Write((short)_spare);
                long from = Math.Max(_confirmed, _match.Tick - 200);
                writer.WriteInputs(_match, 0, from, _match.Tick);
                writer.WriteInputs(_match, 1, from, _match.Tick);
                writer.Write(_ballTick);
                writer.Write((byte)_ball.Length);
                writer.Write(_ball);
            }),
        ];
    }

    private void Read(long now, byte[] packet)
    {
        using var reader = new BinaryReader(new MemoryStream(packet));
        if ((PacketKind)reader.ReadByte() == PacketKind.Join)
        {
            ulong hash = reader.ReadUInt64();
            long attempt = reader.ReadInt64();
            if (attempt == _attempt && !_joins)
            {
                return;     // overtaken: this client has joined
            }

            _attempt = attempt;
            _otherHash = hash == _match.Runner.SessionHash ? 0 : hash;
            _confirmed = _joins ? _confirmed : _match.Tick;
            _joins = true;
            _received = Math.Max(_received, _match.Tick);
            return;
        }

        long confirmed = reader.ReadInt64();
        (long from, TeamInput[] inputs) = reader.ReadInputs();
        if (_joins && confirmed < _confirmed)
        {
            return;     // from the client that was there before
        }

        _joins = false;
        _heard = now;
        _confirmed = Math.Max(_confirmed, confirmed);
        for (int i = 0; i < inputs.Length; i++)
        {
            if (from + i >= Math.Max(_match.Tick, _received))
            {
                _match.SetInput(from + i, 1, inputs[i]);
            }
        }

        _received = Math.Max(_received, from + inputs.Length);
        _spare = from + inputs.Length - _match.Tick;
    }

    /// <summary>Removes a kick if the ball is not within reach on the server.</summary>
    private TeamInput Checked(TeamInput input, long tick)
    {
        if (input.Kick is not { } kick || _match.CanKick(kick.Player, _match.Runner.State, tick))
        {
            return input;
        }

        Strips++;
        return input with { Kick = null };
    }
}
