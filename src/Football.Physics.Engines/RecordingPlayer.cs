using FootballPhysics.Numerics;

namespace FootballPhysics.Engines;

/// <summary>Plays back a recording, forwards in time or from any tick.</summary>
public sealed class RecordingPlayer
{
    private readonly Simulator _simulator;
    private readonly Action<double>? _bodiesAt;
    private FixedStepRunner _runner;
    private double _ahead;

    /// <summary>Creates a player at the beginning of a recording.</summary>
    /// <param name="segment">The recording, of one ball.</param>
    /// <param name="simulator">The scene of the match, with the same settings.</param>
    /// <param name="bodiesAt">Positions an engine's colliders for a time, in s; default none.</param>
    /// <exception cref="ArgumentNullException"><paramref name="segment"/> or <paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentException">The scene or its settings differ from those of the recording.</exception>
    /// <exception cref="InvalidOperationException">An engine's colliders moved, and <paramref name="bodiesAt"/> is null.</exception>
    public RecordingPlayer(Recording segment, Simulator simulator, Action<double>? bodiesAt = null)
    {
        Check.Given(nameof(segment), segment);
        Check.Given(nameof(simulator), simulator);
        Segment = segment;
        _simulator = simulator;
        _bodiesAt = bodiesAt;
        _runner = segment.Replay(simulator, bodiesAt);
    }

    /// <summary>The recording.</summary>
    public Recording Segment { get; }

    /// <summary>The tick shown.</summary>
    public long Tick => _runner.Tick;

    /// <summary>The duration of the recording, in s.</summary>
    public double Duration => (Segment.EndTick - Segment.StartTick) * Segment.TimeStep;

    /// <summary>The current playback time, in s from the start.</summary>
    public double Time => ((Tick - Segment.StartTick) * Segment.TimeStep) + _ahead;

    /// <summary>True if the playback has reached the end.</summary>
    public bool IsOver => Tick >= Segment.EndTick;

    /// <summary>The state of the ball at the tick shown.</summary>
    public BallState State => _runner.State;

    /// <summary>The pose in which to draw the ball.</summary>
    public BallPose Pose => _runner.PoseAt(_ahead / Segment.TimeStep);

    /// <summary>True if the ball at the tick shown is bit-identical to the recording.</summary>
    public bool IsTrue => Snapshot.Hash(_runner.State) == Segment.HashAt(Tick);

    /// <summary>Advances the playback.</summary>
    /// <param name="seconds">The time to advance, in s; not negative.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="seconds"/> is negative or not finite.</exception>
    public void Advance(double seconds)
    {
        Check.NotNegative(nameof(seconds), seconds);
        _ahead += seconds;
        while (_ahead >= Segment.TimeStep && !IsOver)
        {
            _runner.Step();
            _ahead -= Segment.TimeStep;
        }

        _ahead = IsOver ? 0 : _ahead;
    }

    /// <summary>Moves the playback to a tick.</summary>
    /// <param name="tick">From the first tick of the recording to the last.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not part of the recording.</exception>
    public void Seek(long tick)
    {
        Segment.Seek(_runner, tick);
        _ahead = 0;
    }

    /// <summary>Replays the whole recording and compares every state with the recorded one.</summary>
    /// <returns>The first tick whose state differs; null if all are bit-identical.</returns>
    public long? FindDivergence()
    {
        long shown = Tick;
        long? divergence = Segment.FirstDivergence(_simulator, _bodiesAt);
        _runner = Segment.Replay(_simulator, _bodiesAt);
        Seek(shown);
        return divergence;
    }
}
