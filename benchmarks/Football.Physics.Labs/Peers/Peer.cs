using System.Buffers.Binary;

namespace FootballPhysics.Labs.Peers;

/// <summary>One of two peers: it plays ahead of the other's inputs, sends its own until they are confirmed, and counts the goals of final ticks.</summary>
internal sealed class Peer
{
    public const int Ticks = 360;

    /// <summary>The number of ticks by which a peer may be ahead of what it knows of the other, and by which an input may be late.</summary>
    public const int MostLate = 20;

    private const int Header = 2 * sizeof(long);
    private const int Checkpoint = 30;

    private readonly int _team;
    private readonly SeededRandom _random;
    private readonly Link _link;
    private readonly Rollback _rollback;
    private readonly List<(long Issued, KickInput Kick)> _kicks = [];
    private readonly List<(long Issued, PlaceInput Place)> _places = [];

    /// <summary>The goal events since the last final tick; a correction replaces those after its tick.</summary>
    private readonly List<BallEvent> _events = [];
    private readonly Dictionary<string, long> _counts = [];
    private long _known;
    private long _acknowledged;
    private long _final;

    public Peer(int team, PeerMatch match, SeededRandom random, Link link)
    {
        _team = team;
        _random = random;
        _link = link;
        Match = match;
        _rollback = new Rollback(match.Runner, MostLate + 2);
    }

    public PeerMatch Match { get; }

    public Score Score { get; } = new();

    /// <summary>The hashes of final ticks.</summary>
    public List<ulong> Checkpoints { get; } = [];

    /// <summary>True if all ticks are final, and the other peer has all inputs.</summary>
    public bool IsDone => _final == Ticks && _acknowledged == Ticks;

    private FixedStepRunner Runner => Match.Runner;

    /// <summary>Returns the name of the count of inputs that are as late.</summary>
    public static string Lateness(int late) => FormattableString.Invariant($"late {(late + 4) / 5}");

    /// <summary>Adds the counts of this peer.</summary>
    public void AddTo(LabCounts counts)
    {
        foreach ((string what, long count) in _counts)
        {
            counts.Add(what, count);
        }
    }

    /// <summary>Plays a tick, with the inputs of this peer in time, if the other is not too far behind.</summary>
    public void Advance()
    {
        if (Runner.Tick < Ticks && Runner.Tick < _known + MostLate)
        {
            Decide();
            Runner.Step();
            Keep(Runner.Events);
            Finish();
        }
    }

    /// <summary>Sends all inputs that the other peer has not confirmed.</summary>
    public void Send()
    {
        var log = new KickLog();
        foreach ((long issued, KickInput kick) in _kicks)
        {
            if (issued >= _acknowledged)
            {
                log.Add(in kick);
            }
        }

        foreach ((long issued, PlaceInput place) in _places)
        {
            if (issued >= _acknowledged)
            {
                log.Add(in place);
            }
        }

        byte[] inputs = log.ToBytes();
        var packet = new byte[Header + inputs.Length];
        BinaryPrimitives.WriteInt64LittleEndian(packet, Runner.Tick);
        BinaryPrimitives.WriteInt64LittleEndian(packet.AsSpan(sizeof(long)), _known);
        inputs.CopyTo(packet, Header);
        _link.Send(1 - _team, packet);
    }

    /// <summary>Takes up the packets that have arrived, in any order and any number of times.</summary>
    public void Receive()
    {
        foreach (byte[] packet in _link.Received(_team))
        {
            long tick = BinaryPrimitives.ReadInt64LittleEndian(packet);
            _acknowledged = Math.Max(_acknowledged, BinaryPrimitives.ReadInt64LittleEndian(packet.AsSpan(sizeof(long))));
            var log = KickLog.FromBytes(packet.AsSpan(Header));
            for (int i = 0; i < log.Count; i++)
            {
                KickInput kick = log[i];
                if (kick.Tick >= _rollback.OldestTick)
                {
                    Correct(kick.Tick, Runner.Kicks.Has(in kick), _rollback.ApplyKick(in kick));
                }
            }

            for (int i = 0; i < log.PlaceCount; i++)
            {
                PlaceInput place = log.PlaceAt(i);
                if (place.Tick >= _rollback.OldestTick)
                {
                    Correct(place.Tick, Runner.Kicks.Has(in place), _rollback.ApplyPlace(in place));
                }
            }

            _known = Math.Max(_known, tick);
        }

        Finish();
    }

    /// <summary>Notes a late input, and replaces the events of the ticks that it changed.</summary>
    private void Correct(long tick, bool isDuplicate, long? changed)
    {
        if (isDuplicate)
        {
            Count("inputs that came again");
            return;
        }

        if (tick < Runner.Tick)
        {
            Count("late inputs");
            Count(Lateness((int)(Runner.Tick - tick)));
            Count("ticks resimulated", Runner.Tick - tick);
        }

        if (changed is not null)
        {
            double from = _rollback.StateAt(tick).Time;
            _events.RemoveAll(happened => happened.Time > from);
            Keep(_rollback.Events);
        }
    }

    /// <summary>Draws a kick, a throw or a dropped ball of this peer's players, from the ball as this peer predicts it.</summary>
    private void Decide()
    {
        long tick = Runner.Tick;
        if (_random.Chance(0.05))
        {
            double side = _team == 0 ? 1 : -1;
            var goal = new Vector3d(_random.Uniform(-3.3, 3.3), _random.Uniform(0.2, 2), side * PeerMatch.Length);
            Vector3d way = goal - Runner.State.Position;
            Vector3d spin = new(_random.Uniform(-30, 30), _random.Uniform(-50, 50), 0);
            Issue(new KickInput(tick, _random.Uniform(6, 28) / Math.Max(1, way.Length) * (way + new Vector3d(0, 0.12 * way.Length, 0)), spin, Player()));
        }

        Vector3d at = Runner.State.Position;
        if ((Math.Abs(at.X) > PeerMatch.Width || Math.Abs(at.Z) > PeerMatch.Length + 1) && _random.Chance(0.1))
        {
            // A throw, now or in a few ticks.
            double x = Math.CopySign(PeerMatch.Width, at.X);
            Issue(new PlaceInput(tick + _random.Below(6), Player(), 0, new Vector3d(x, 2, Math.Clamp(at.Z, -12, 12)), new Vector3d(-0.6 * x, 2, _random.Uniform(-5, 5)), default, Quaterniond.FromAxisAngle(Vector3d.Up, 1)));
        }
        else if (_random.Chance(0.008))
        {
            // A dropped ball, often before a goal: a player of each team may give one in the same tick.
            double z = _random.Chance(0.5) ? _random.Any(-8, 8) : _random.Uniform(-11, 11);
            Issue(new PlaceInput(tick + _random.Below(2), Player(), 0, new Vector3d(_random.Uniform(-6, 6), 1, z)));
        }

        // The first peer kicks off after a final goal.
        if (_team == 0 && !Score.IsLive && !_places.Exists(restart => restart.Place.Tick >= _final && restart.Place.Player == 0))
        {
            Issue(new PlaceInput(tick + 1, 0, 0, Vector3d.Zero));
        }
    }

    private int Player() => (11 * _team) + 1 + _random.Below(10);

    private void Issue(KickInput kick)
    {
        _kicks.Add((Runner.Tick, kick));
        Correct(kick.Tick, false, _rollback.ApplyKick(in kick));
    }

    private void Issue(PlaceInput place)
    {
        // A player gives one restart for a tick: a second one would be a correction, which must not arrive before the first.
        if (!_places.Exists(other => other.Place.Tick == place.Tick && other.Place.Player == place.Player))
        {
            _places.Add((Runner.Tick, place));
            Correct(place.Tick, false, _rollback.ApplyPlace(in place));
        }
    }

    private void Keep(EventBuffer events)
    {
        foreach (ref readonly BallEvent happened in events)
        {
            if (happened.Kind == BallEventKind.Goal)
            {
                _events.Add(happened);
            }
        }
    }

    /// <summary>Counts the goals of the ticks that no input changes any more.</summary>
    private void Finish()
    {
        for (; _final < Math.Min(Runner.Tick, _known); _final++)
        {
            double end = _rollback.StateAt(_final + 1).Time;
            Score.Add(Runner.Kicks, _final, [.. _events.Where(happened => happened.Time <= end)]);
            _events.RemoveAll(happened => happened.Time <= end);
            if ((_final + 1) % Checkpoint == 0)
            {
                Checkpoints.Add(_rollback.HashAt(_final + 1));
            }
        }
    }

    private void Count(string what, long number = 1) => _counts[what] = _counts.GetValueOrDefault(what) + number;
}
