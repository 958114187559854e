namespace FootballPhysics.Labs.Peers;

/// <summary>The score of a match, from ticks that no input changes any more: one goal counts between two restarts.</summary>
internal sealed class Score
{
    private readonly int[] _goals = new int[2];

    /// <summary>True from a restart to the next goal.</summary>
    public bool IsLive { get; private set; } = true;

    /// <summary>The number of goal events.</summary>
    public int Seen { get; private set; }

    /// <summary>The number of goals that count.</summary>
    public int Counted => _goals[0] + _goals[1];

    /// <summary>The score.</summary>
    public string Text => FormattableString.Invariant($"{_goals[0]}:{_goals[1]}");

    /// <summary>Adds the events of a tick.</summary>
    public void Add(KickLog inputs, long tick, IEnumerable<BallEvent> events)
    {
        int place = inputs.FirstPlaceAt(tick);
        IsLive |= place < inputs.PlaceCount && inputs.PlaceAt(place).Tick == tick;
        foreach (BallEvent happened in events.Where(happened => happened.Kind == BallEventKind.Goal))
        {
            Seen++;
            _goals[happened.Position.Z < 0 ? 0 : 1] += IsLive ? 1 : 0;
            IsLive = false;
        }
    }
}
