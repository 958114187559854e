namespace FootballPhysics.Engines;

/// <summary>Plays a recorded stretch of a match in a window: forwards in time, and to any tick.</summary>
public sealed class RecordingPlayer
{
    private readonly Simulator _simulator;
    private readonly Action<double>? _bodiesAt;
    private FixedStepRunner _runner;
    private double _ahead;

    /// <summary>Begins at the start of a segment.</summary>
    /// <param name="segment">The segment, of one ball.</param>
    /// <param name="simulator">The scene of the match, with its settings.</param>
    /// <param name="bodiesAt">Puts an engine's colliders to where they were at a time, s; default none.</param>
    /// <exception cref="ArgumentNullException">Segment or scene is null.</exception>
    /// <exception cref="ArgumentException">The scene, or its settings, are not those of the segment.</exception>
    /// <exception cref="InvalidOperationException">An engine's colliders moved, and nothing says where they were.</exception>
    public RecordingPlayer(Recording segment, Simulator simulator, Action<double>? bodiesAt = null)
    {
        Check.Given(nameof(segment), segment);
        Check.Given(nameof(simulator), simulator);
        Segment = segment;
        _simulator = simulator;
        _bodiesAt = bodiesAt;
        _runner = segment.Replay(simulator, bodiesAt);
    }

    /// <summary>The segment.</summary>
    public Recording Segment { get; }

    /// <summary>The tick that is shown.</summary>
    public long Tick => _runner.Tick;

    /// <summary>How long the segment is, s.</summary>
    public double Duration => (Segment.EndTick - Segment.StartTick) * Segment.TimeStep;

    /// <summary>How far it has got, s.</summary>
    public double Time => ((Tick - Segment.StartTick) * Segment.TimeStep) + _ahead;

    /// <summary>True when there is nothing left to play.</summary>
    public bool IsOver => Tick >= Segment.EndTick;

    /// <summary>The ball at the shown tick.</summary>
    public BallState State => _runner.State;

    /// <summary>Where to draw the ball.</summary>
    public BallPose Pose => _runner.PoseAt(_ahead / Segment.TimeStep);

    /// <summary>True where the ball at the shown tick is the recorded one to the last bit.</summary>
    public bool IsTrue => Snapshot.Hash(_runner.State) == Segment.HashAt(Tick);

    /// <summary>Plays on.</summary>
    /// <param name="seconds">How long, s; not negative.</param>
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

    /// <summary>Goes to a tick.</summary>
    /// <param name="tick">From the segment's first to its last.</param>
    /// <exception cref="ArgumentOutOfRangeException">The tick is not part of the segment.</exception>
    public void Seek(long tick)
    {
        Segment.Seek(_runner, tick);
        _ahead = 0;
    }

    /// <summary>Plays all of it again and compares.</summary>
    /// <returns>The first tick whose state is not the recorded one to the last bit; null when all are.</returns>
    public long? FindDivergence()
    {
        long shown = Tick;
        long? divergence = Segment.FirstDivergence(_simulator, _bodiesAt);
        _runner = Segment.Replay(_simulator, _bodiesAt);
        Seek(shown);
        return divergence;
    }
}
