using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>Keeps a prediction of a moving ball up to date at minimum cost.</summary>
/// <remarks>
/// While the ball follows the predicted path, an update only drops the part that the ball has passed and extends the path. After a kick, or a deviation above
/// the tolerance, it recomputes the path. With the game's own integrator and step, the prediction is bit-identical to the later simulation.
/// </remarks>
public sealed class TrajectoryCache
{
    private readonly Simulator _simulator;
    private readonly LookAheadRequest _request;
    private readonly LookAheadSteps _steps;
    private bool _valid;

    /// <summary>Creates a cache for the prediction of a ball in one scene.</summary>
    /// <param name="simulator">The scene, compiled for the integrator of the prediction.</param>
    /// <param name="request">The duration and step of the prediction.</param>
    /// <param name="tolerance">The maximum deviation of the ball from the path before it is recomputed, in m; not negative, default 1e-5.</param>
    /// <param name="capacity">The number of path segments that fit at first; default 512. The path grows if it needs more.</param>
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
        _steps = new LookAheadSteps(null, [Path]);
    }

    /// <summary>The predicted path; it starts at or before the ball's last known time.</summary>
    public Trajectory Path { get; }

    /// <summary>The maximum deviation of the ball from the path before it is recomputed, in m.</summary>
    public double Tolerance { get; }

    /// <summary>The number of times the path was recomputed.</summary>
    public int Recomputations { get; private set; }

    /// <summary>Discards the path, so that the next update recomputes it.</summary>
    public void Invalidate() => _valid = false;

    /// <summary>Updates the prediction to the current state of the ball.</summary>
    /// <param name="real">The current state of the ball.</param>
    /// <returns>True if the path was recomputed; false if it was kept and, if necessary, extended.</returns>
    /// <remarks>Does not allocate once the path is large enough. An exception from a custom force propagates; the path then ends before the failed step, and the next update
    /// recomputes it.</remarks>
    /// <exception cref="ArgumentException"><paramref name="real"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The ball's clock is so large that the steps of the request would not advance it.</exception>
    public bool Update(in BallState real)
    {
        BallState.Launched(in real);
        _request.CheckClock(in real);
        bool keeps = _valid && Path.Has(in real, Tolerance);

        // First mark the path as invalid, so that it is not reused if an exception interrupts the update.
        _valid = false;
        if (keeps)
        {
            // The ball follows the path: drop the part that the ball has passed.
            Path.Forget(real.Time);
        }
        else
        {
            Begin(in real);
            Recomputations++;
        }

        Extend(real.Time);
        _valid = true;
        return !keeps;
    }

    /// <summary>Repeats the updates from the state at which the path was last recomputed up to a later time, as a rollback requires.</summary>
    /// <param name="start">The state at which the path was recomputed.</param>
    /// <param name="time">The time of the last update, in s.</param>
    internal void Repeat(in BallState start, double time)
    {
        _valid = false;
        Begin(in start);
        Extend(start.Time);

        // Extend the path in parts, so that it fits into the memory that sufficed before.
        for (double at = start.Time; at < time && !_steps.IsHalted;)
        {
            Path.Forget(at);
            at = Math.Min(time, at + (0.5 * _request.Duration));
            Extend(at);
        }

        _valid = true;
    }

    private void Begin(in BallState from)
    {
        _steps.Start(_simulator, in from, _request);
        _steps.Begin(endsWhenFull: false);
    }

    /// <summary>Extends the path by complete steps up to the duration after a time, or to the event that ends it.</summary>
    private void Extend(double time)
    {
        if (!_steps.IsHalted)
        {
            _steps.Extend(time + _request.Duration);
            _steps.Run();
        }
    }
}
