namespace FootballPhysics;

/// <content>What a log keeps of the zones that watch a step.</content>
public sealed partial class StepLog
{
    private PieceObserver? _observer;
    private ZoneWatch? _zones;
    private ZoneCrossing[] _crossings = [];
    private int _crossingCount;

    /// <summary>True if pieces are shown to anyone.</summary>
    internal bool IsWatched { get; private set; }

    /// <summary>The zones that watch the pieces; null outside steps, and in scenes without zones.</summary>
    internal ZoneWatch? Zones
    {
        get => _zones;
        set
        {
            _zones = value;
            IsWatched = value is not null || _observer is not null;
        }
    }

    /// <summary>True if zones report nothing here: for flights of which only the impacts and the end count.</summary>
    internal bool IgnoresZones { get; init; }

    /// <summary>Where the zones saw the ball last, m.</summary>
    internal Vector3d ZonePlace { get; set; }

    /// <summary>Events of zones so far: the physics of a step does not count them.</summary>
    internal int ZoneEvents { get; set; }

    /// <summary>True if the acceleration at the end of a piece is worth an evaluation.</summary>
    internal bool WantsEnd(in BallState before, in BallState after, in Vector3d startAcceleration) =>
        _observer is { WantsEndAcceleration: true } || (_zones is not null && _zones.IsNear(in before, in after, in startAcceleration));

    /// <summary>Adds a crossing in its order.</summary>
    internal void AddCrossing(in ZoneCrossing crossing)
    {
        if (_crossingCount == _crossings.Length)
        {
            Array.Resize(ref _crossings, Math.Max(16, 2 * _crossingCount));
        }

        int place = _crossingCount++;
        for (; place > 0 && crossing.IsBefore(in _crossings[place - 1]); place--)
        {
            _crossings[place] = _crossings[place - 1];
        }

        _crossings[place] = crossing;
    }

    /// <summary>The crossings of a piece, which are forgotten.</summary>
    internal Span<ZoneCrossing> TakeCrossings()
    {
        int count = _crossingCount;
        _crossingCount = 0;
        return _crossings.AsSpan(0, count);
    }
}
