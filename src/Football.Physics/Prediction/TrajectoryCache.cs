namespace FootballPhysics.Prediction;

/// <summary>Keeps a prediction of a moving ball up to date, doing as little as it can.</summary>
/// <remarks>
/// While the real ball keeps to the predicted path, the past is dropped and the end extended; only a kick, or a path that leaves the
/// tolerance, starts it again. With the game's own integrator and step the prediction is the future bit for bit.
/// </remarks>
public sealed class TrajectoryCache
{
    /// <summary>A velocity may differ by the tolerance times this, 1/s, before the ball counts as kicked.</summary>
    private const double VelocityShare = 100;

    private readonly Simulator _simulator;
    private readonly LookAheadRequest _request;
    private bool _valid;

    /// <summary>Makes a prediction for balls of one scene.</summary>
    /// <param name="simulator">The scene, compiled for the integrator to predict with.</param>
    /// <param name="request">How far to look ahead, and in which steps.</param>
    /// <param name="tolerance">How far, m, the real ball may be off the path before it is predicted again; not negative, default 1e-5.</param>
    /// <param name="capacity">Pieces of path to make room for; default 512.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    public TrajectoryCache(Simulator simulator, LookAheadRequest request, double tolerance = 1e-5, int capacity = 512)
    {
        _simulator = simulator ?? throw new ArgumentNullException(nameof(simulator));
        _request = request ?? throw new ArgumentNullException(nameof(request));
        _request.Validate();
        Check.NotNegative(nameof(tolerance), tolerance);
        Tolerance = tolerance;
        Path = new Trajectory(capacity);
    }

    /// <summary>The predicted path. It starts at or before the ball's last known time.</summary>
    public Trajectory Path { get; }

    /// <summary>How far, m, the real ball may be off the path before it is predicted again.</summary>
    public double Tolerance { get; }

    /// <summary>How often the path was predicted anew.</summary>
    public int Recomputations { get; private set; }

    /// <summary>Forgets the path, so that the next update predicts anew.</summary>
    public void Invalidate() => _valid = false;

    /// <summary>Brings the prediction up to the real ball. Allocates nothing.</summary>
    /// <param name="real">The real ball.</param>
    /// <returns>True when the path was predicted anew, false when it was kept and, where needed, extended.</returns>
    /// <remarks>What a force of the game's own throws comes through; the path then ends before the step in which it did, and the next update predicts anew.</remarks>
    /// <exception cref="ArgumentOutOfRangeException">The ball's clock stands so high that the steps of the request would not move it.</exception>
    public bool Update(in BallState real)
    {
        _request.CheckClock(in real);
        bool keeps = _valid && OnPath(in real);

        // What throws in between leaves a path that is not used again.
        _valid = false;
        if (!keeps)
        {
            _simulator.LookAheadInWholeSteps(in real, _request, Path);
            _valid = true;
            Recomputations++;
            return true;
        }

        // The ball keeps to the path: its past is dropped, and its end extended in whole steps.
        Path.Forget(real.Time);

        // A path that an event ended, or its memory within a step, has nothing to be extended by.
        if (Path.EndsWhole)
        {
            _simulator.Extend(Path, real.Time + _request.Duration, _request.TimeStep, _request.StopAt);
        }

        _valid = true;
        return false;
    }

    private bool OnPath(in BallState real)
    {
        // Before the path, or beyond an end at which it still moves, there is nothing to compare with.
        if (!(real.Time >= Path.StartTime && (real.Time <= Path.EndTime || Path.Final.Motion == MotionState.Rest)))
        {
            return false;
        }

        // The velocity too: a kick is seen at once, not when the ball has gone somewhere else.
        return Vector3d.Distance(Path.PositionAt(real.Time), real.Position) <= Tolerance
            && Vector3d.Distance(Path.VelocityAt(real.Time), real.Velocity) <= Tolerance * VelocityShare;
    }
}
