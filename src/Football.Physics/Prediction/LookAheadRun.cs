using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A look-ahead in parts: each call takes a limited number of steps, and the next call resumes there.</summary>
/// <remarks>
/// The finished path is bit-identical to that of <see cref="SimulatorExtensions.LookAhead(Simulator, in BallState, LookAheadRequest, Trajectory)"/>,
/// for any number of steps per call. The run has its own copy of the ball and of the bodies' motions. Your game may therefore step and kick the ball and move
/// bodies between calls. The run does not notice such changes: call <see cref="Follows"/> to detect them. Calls do not
/// allocate once the path is large enough. Not thread-safe.
/// </remarks>
public sealed class LookAheadRun
{
    private readonly Simulator _simulator;
    private readonly LookAheadMotions _motions;
    private LookAheadRequest? _request;
    private LookAheadSteps _steps;
    private BallState _from;
    private int _uses;
    private bool _endsWhenFull;

    /// <summary>Creates a look-ahead in parts.</summary>
    /// <param name="simulator">The scene, compiled for the integrator of the prediction.</param>
    /// <param name="path">Receives the path and the events; default: a new trajectory.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The scene has engine colliders.</exception>
    public LookAheadRun(Simulator simulator, Trajectory? path = null)
    {
        _simulator = simulator ?? throw new ArgumentNullException(nameof(simulator));
        _motions = new LookAheadMotions(simulator.World);
        Path = path ?? new Trajectory();
    }

    /// <summary>The path so far; <see cref="Trajectory.IsComplete"/> is false until the look-ahead is finished.</summary>
    public Trajectory Path { get; }

    /// <summary>True if the look-ahead was started and has not finished, failed or been cancelled.</summary>
    public bool IsRunning { get; private set; }

    /// <summary>The number of steps since the start.</summary>
    public long Steps { get; private set; }

    /// <summary>Starts a look-ahead without taking a step, and cancels any look-ahead that is running.</summary>
    /// <param name="from">The state of the ball; it is copied.</param>
    /// <param name="request">The duration and the stop conditions.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="from"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public void Start(in BallState from, LookAheadRequest request)
    {
        Check.Given(nameof(request), request);
        request.Validate();
        request.CheckClock(in from);
        BallState.Launched(in from);
        IsRunning = false;
        _request = request;
        _from = from;
        _motions.Start();
        Steps = 0;
        Begin(endsWhenFull: false);
        IsRunning = true;
    }

    /// <summary>Takes a number of steps, or fewer if the look-ahead ends.</summary>
    /// <param name="maximumSteps">The maximum number of steps; at least 1.</param>
    /// <returns>True if the look-ahead is finished; false if it will continue.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="maximumSteps"/> is below 1.</exception>
    /// <exception cref="InvalidOperationException">
    /// No look-ahead is running, another look-ahead has used the trajectory, or a custom force is not finite.
    /// </exception>
    public bool Continue(int maximumSteps)
    {
        Check.Within(nameof(maximumSteps), maximumSteps, 1, int.MaxValue);
        if (!IsRunning)
        {
            throw new InvalidOperationException("No look-ahead is running. Call Start first.");
        }

        if (Path.Uses != _uses)
        {
            IsRunning = false;
            throw new InvalidOperationException("Another look-ahead has used the trajectory. Use a trajectory of its own for each run, and call Start again.");
        }

        // Until the last step, an exception leaves the run in its stopped state.
        IsRunning = false;
        Path.GoOn();
        _motions.Enter();
        bool isFinished;
        try
        {
            isFinished = Take(maximumSteps);
        }
        catch
        {
            // Remove the segments of the failed step.
            Path.Break(in _steps.State);
            throw;
        }
        finally
        {
            _motions.Leave();
        }

        if (isFinished)
        {
            Path.End(in _steps.State);
        }
        else
        {
            Path.Pause(in _steps.State);
            IsRunning = true;
        }

        return isFinished;
    }

    /// <summary>Stops the look-ahead. The path keeps the part computed so far.</summary>
    public void Cancel() => IsRunning = false;

    /// <summary>Returns true if a ball is still on the path; false if a kick or a hit has made the path outdated.</summary>
    /// <param name="ball">The current state of the ball.</param>
    /// <param name="tolerance">The maximum distance from the path, in m; not negative, default 1e-5. For velocities it is multiplied by 100/s.</param>
    /// <returns>Also false if the ball's time is outside the part computed so far, unless the ball rests at the end of that part.</returns>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="tolerance"/> is negative.</exception>
    public bool Follows(in BallState ball, double tolerance = 1e-5)
    {
        Check.NotNegative(nameof(tolerance), tolerance);
        BallState.Launched(in ball);
        return _request is not null && Path.Uses == _uses && Path.Has(in ball, tolerance);
    }

    /// <summary>Takes steps until the budget is used up or the look-ahead ends.</summary>
    private bool Take(int maximumSteps)
    {
        for (int taken = 0; taken < maximumSteps;)
        {
            if (_steps.Take())
            {
                taken++;
                Steps++;
            }
            else if (!Path.Overflows || _endsWhenFull)
            {
                return true;
            }
            else
            {
                // The path does not fit: simulate again, up to the last segment that fits.
                _motions.Leave();
                _motions.Restart();
                Begin(endsWhenFull: true);
                Path.GoOn();
                _motions.Enter();
            }
        }

        // The last step may have reached the end, so no further call is needed.
        return _steps.HasEnded && (!Path.Overflows || _endsWhenFull);
    }

    /// <summary>Begins the path at the initial state.</summary>
    private void Begin(bool endsWhenFull)
    {
        _endsWhenFull = endsWhenFull;
        _steps = new LookAheadSteps(_simulator, in _from, _request!, Path, endsWhenFull);
        _uses = Path.Uses;
        Path.Log.Pushes = _simulator.World.MayGiveWay;
        Path.Pause(in _from);
        _motions.MoveTo(in _from, Path.OnStep);
    }
}
