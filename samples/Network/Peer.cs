using FootballPhysics.Netcode;

namespace FootballPhysics.Network;

/// <summary>The three calls that a GGPO-like library makes into a game. A frame is a tick.</summary>
public interface IRollbackGame
{
    long Frame { get; }

    void Save();

    void Load(long frame);

    void Advance(TeamInput first, TeamInput second);
}

/// <summary>The match behind these calls. A saved state is the ball's state, which is a value, and the positions of the players.</summary>
public sealed class MatchCallbacks(Match match) : IRollbackGame
{
    private readonly BallState[] _saved = new BallState[Match.Kept];

    public long Frame => match.Tick;

    public void Save() => _saved[match.Tick % Match.Kept] = match.Runner.State;

    public void Load(long frame) => match.Restore(frame, match.PlayersAt(frame), in _saved[frame % Match.Kept]);

    public void Advance(TeamInput first, TeamInput second)
    {
        long tick = match.Tick;
        match.SetInput(tick, 0, first);
        match.SetInput(tick, 1, second);
        match.Advance();
    }

    public BallState Saved(long frame) => _saved[frame % Match.Kept];
}

/// <summary>
/// One of two equal peers, as in GGPO. Each sends the inputs of its team, guesses those of the other, and rolls back if a guess was wrong. There is no authority; both reach
/// bit-identical states. A peer waits while the other is more than <see cref="MostAhead"/> ticks behind, so the match pauses while one is absent.
/// </summary>
public sealed class Peer(int team, int seed, HashLog hashes)
{
    /// <summary>The delay of a team's own inputs, in ticks. It hides as much of the network delay from corrections.</summary>
    private const int InputDelay = 3;

    private const int MostAhead = 60;

    private readonly Match _match = new();
    private readonly Brain _brain = new(team, seed);
    private readonly Dictionary<long, TeamInput> _theirs = [];
    private MatchCallbacks? _game;
    private long _confirmed;    // the other's inputs before this tick are known
    private long _otherHas;     // the other has our inputs before this tick
    private long _decided;      // our inputs before this tick are decided
    private long _final;        // states before this tick are final, and logged
    private bool _begun;
    private long _joinAt = -1;
    private long _attempt;
    private long _theirGuesses;

    public string Score => _match.Referee.Summary;

    public int Rollbacks { get; private set; }

    public int Ticks { get; private set; }

    public int Waits { get; private set; }

    public IReadOnlyList<byte[]> Tick(long now, byte[][] packets)
    {
        long? wrong = null;
        foreach (byte[] packet in packets)
        {
            wrong = Earlier(wrong, Read(packet));
        }

        // The first peer starts the match; the second sends requests to join.
        if (_game is null && team == 1)
        {
            return now % 10 == 0 ? [Packets.OfJoin(_match.Runner.SessionHash, 0)] : [];
        }

        _game ??= new MatchCallbacks(_match);
        PlayAgain(wrong);
        for (; _final <= _confirmed && _final < _game.Frame; _final++)
        {
            // The state at this tick is final: all inputs before it are known. The referee judges the tick that led to it, as the one of the other peer does.
            BallState final = _game.Saved(_final);
            if (_final > _match.Referee.Tick && _match.Referee.Judge(in final) is { } restart)
            {
                _match.Runner.Kicks.Add(in restart);
                PlayAgain(restart.Tick - 1);
            }

            hashes.Add(_final, Snapshot.Hash(final), _match.Referee.Now);
        }

        Play(now);
        if (_joinAt >= 0)
        {
            return [Packets.Of(PacketKind.Welcome, writer => writer.WriteState(_match, _joinAt, _joinAt == _game.Frame ? _match.Runner.State : _game.Saved(_joinAt)))];
        }

        return !_begun && team == 0 ? [] :
        [
            Packets.Of(PacketKind.Inputs, writer =>
            {
                writer.Write(_confirmed);
                writer.Write((short)(_game.Frame - _confirmed));
                writer.WriteInputs(_match, team, _otherHas, _decided);
            }),
        ];
    }

    private void Play(long now)
    {
        // Both peers should guess equally far ahead: the one that guesses farther sometimes waits a tick.
        long guesses = _game!.Frame - _confirmed;
        bool isAhead = guesses - _theirGuesses > 4 && now % 10 == 0;
        if (isAhead || guesses >= MostAhead || (!_begun && team == 0))
        {
            Waits++;
            return;
        }

        for (; _decided <= _game.Frame + InputDelay; _decided++)
        {
            TeamInput input = _brain.Decide(_match, _game.Frame);
            KickInput? kick = input.Kick is { } wish ? new KickInput(_decided, wish.Velocity, wish.Spin, wish.Player) : null;
            _match.SetInput(_decided, team, input with { Kick = kick });
        }

        Step();
    }

    /// <summary>Replays from a wrong guess, as every GGPO-like loop does: loads its frame, and advances to the current one.</summary>
    private void PlayAgain(long? wrong)
    {
        if (wrong is not { } from || from >= _game!.Frame)
        {
            return;
        }

        long now = _game.Frame;
        Rollbacks++;
        Ticks += (int)(now - from);
        _game.Load(from);
        while (_game.Frame < now)
        {
            Step();
        }
    }

    private void Step()
    {
        long tick = _game!.Frame;
        TeamInput theirs = _theirs.TryGetValue(tick, out TeamInput? known) ? known : _match.Guess(tick, 1 - team);
        TeamInput ours = _match.InputAt(tick, team);
        _game.Save();
        _game.Advance(team == 0 ? ours : theirs, team == 0 ? theirs : ours);
        _theirs.Remove(tick - Match.Kept);
    }

    /// <summary>Reads a packet. Returns the first tick that was guessed wrongly; null if there is none.</summary>
    private long? Read(byte[] packet)
    {
        using var reader = new BinaryReader(new MemoryStream(packet));
        switch ((PacketKind)reader.ReadByte())
        {
            case PacketKind.Join when _game is not null && reader.ReadUInt64() == _match.Runner.SessionHash:
                long attempt = reader.ReadInt64();
                if (attempt == _attempt && _joinAt < 0)
                {
                    return null;    // overtaken: this peer has joined
                }

                // A peer that joins begins at the end of the known inputs of both teams: nothing before that tick changes.
                _joinAt = _joinAt < 0 ? Math.Min(_confirmed, _game.Frame) : _joinAt;
                _attempt = attempt;
                _begun = true;
                return null;
            case PacketKind.Welcome when _game is null:
                reader.ReadState(_match);
                _confirmed = _otherHas = _final = _match.Tick;
                for (_decided = _match.Tick; _decided < _match.Tick + InputDelay; _decided++)
                {
                    _match.SetInput(_decided, team, TeamInput.Stand);
                }

                _game = new MatchCallbacks(_match);
                return null;
            case PacketKind.Inputs when _game is not null:
                return ReadInputs(reader);
            default:
                return null;
        }
    }

    private long? ReadInputs(BinaryReader reader)
    {
        long confirmed = reader.ReadInt64();
        _theirGuesses = reader.ReadInt16();
        (long from, TeamInput[] inputs) = reader.ReadInputs();
        if (_joinAt >= 0 && confirmed != _joinAt)
        {
            return null;    // from the peer that was there before
        }

        _otherHas = _joinAt >= 0 ? confirmed : Math.Max(_otherHas, confirmed);
        _joinAt = -1;
        long? wrong = null;
        for (int i = 0; i < inputs.Length && from <= _confirmed; i++)
        {
            long tick = from + i;
            if (tick < _confirmed)
            {
                continue;
            }

            _theirs[tick] = inputs[i];
            _confirmed = tick + 1;
            bool guessed = tick < _game!.Frame;
            wrong ??= guessed && !_match.InputAt(tick, 1 - team).SameAs(inputs[i]) ? tick : null;
        }

        return wrong;
    }

    private static long? Earlier(long? a, long? b) => a is null ? b : b is null ? a : Math.Min(a.Value, b.Value);
}
