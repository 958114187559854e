using FootballPhysics.Simulation;

namespace FootballPhysics;

/// <content>The zone data of a log.</content>
public sealed partial class StepLog
{
    private PieceObserver? _observer;
    private PathObserver? _path;
    private ZoneWatch? _zones;
    private ZoneCrossing[] _crossings = [];
    private int _crossingCount;

    /// <summary>True if an observer or a zone receives the pieces.</summary>
    internal bool IsWatched { get; private set; }

    /// <summary>The zones that observe the pieces; null outside a step, and in scenes without zones.</summary>
    internal ZoneWatch? Zones
    {
        get => _zones;
        set
        {
            _zones = value;
            IsWatched = value is not null || _observer is not null;
        }
    }

    /// <summary>True if zones report no events, as in flights of which only the impacts and the end matter.</summary>
    internal bool IgnoresZones { get; init; }

    /// <summary>The last position of the ball that the zones have processed, m.</summary>
    internal Vector3d ZonePlace { get; set; }

    /// <summary>Number of zone events so far. They do not count towards the limits of a step.</summary>
    internal int ZoneEvents { get; set; }

    /// <summary>True if the acceleration at the end of a piece is needed.</summary>
    internal bool WantsEnd(in BallState before, in BallState after, in Vector3d startAcceleration) =>
        _observer is { WantsEndAcceleration: true } || (_zones is not null && _zones.IsNear(in before, in after, in startAcceleration));

    /// <summary>Inserts a crossing in order.</summary>
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

    /// <summary>Returns the crossings of a piece, and clears them.</summary>
    internal Span<ZoneCrossing> TakeCrossings()
    {
        int count = _crossingCount;
        _crossingCount = 0;
        return _crossings.AsSpan(0, count);
    }
}
