using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A look-ahead of one or several balls in parts: each call takes a limited number of steps, and the next call resumes there.</summary>
/// <remarks>
/// The finished paths are bit-identical to those of <see cref="SimulatorExtensions.LookAhead(Simulator, in BallState, LookAheadRequest, Trajectory)"/> and
/// <see cref="SimulatorExtensions.LookAhead(BallGroup, BallState[], LookAheadRequest, Trajectory[])"/>,
/// for any number of steps per call. The run has its own copies of the balls and of the bodies' motions. Your game may therefore step and kick the balls and move
/// bodies between calls. The run does not notice such changes: call <see cref="Follows(in BallState, double)"/> to detect them. Calls do not
/// allocate once the path is large enough. Not thread-safe.
/// </remarks>
public sealed class LookAheadRun
{
    private readonly Simulator? _alone;
    private readonly Trajectory[] _paths;
    private readonly int[] _uses;
    private readonly LookAheadMotions _motions;
    private readonly LookAheadSteps _steps;

    /// <summary>Creates a look-ahead of one ball in parts.</summary>
    /// <param name="simulator">The scene, compiled for the integrator of the prediction.</param>
    /// <param name="path">Receives the path and the events; default: a new trajectory.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The scene has engine colliders.</exception>
    public LookAheadRun(Simulator simulator, Trajectory? path = null)
        : this(simulator ?? throw new ArgumentNullException(nameof(simulator)), null, [path ?? new Trajectory()]) => _alone = simulator;

    /// <summary>Creates a look-ahead of several balls in parts.</summary>
    /// <param name="group">The balls.</param>
    /// <param name="capacity">The number of path segments that fit for each ball; at first; at least 1, default 512. A path grows if it needs more.</param>
    /// <exception cref="ArgumentNullException"><paramref name="group"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is below 1, or the scene has engine colliders.</exception>
    public LookAheadRun(BallGroup group, int capacity = 512)
        : this((group ?? throw new ArgumentNullException(nameof(group))).SimulatorOf(0), group, [.. Enumerable.Range(0, group.Count).Select(_ => new Trajectory(capacity))])
    {
    }

    private LookAheadRun(Simulator first, BallGroup? group, Trajectory[] paths)
    {
        _motions = new LookAheadMotions(first.World);
        _paths = paths;
        _uses = new int[paths.Length];
        _steps = new LookAheadSteps(group, paths);
    }

    /// <summary>The path of the first ball so far; <see cref="Trajectory.IsComplete"/> is false until the look-ahead is finished.</summary>
    public Trajectory Path => _paths[0];

    /// <summary>The paths so far, one per ball.</summary>
    public IReadOnlyList<Trajectory> Paths => _paths;

    /// <summary>True if the look-ahead was started and has not finished, failed or been cancelled.</summary>
    public bool IsRunning { get; private set; }

    /// <summary>The number of steps since the start; all balls take a step together.</summary>
    public long Steps { get; private set; }

    /// <summary>Starts a look-ahead of one ball without taking a step, and cancels any look-ahead that is running.</summary>
    /// <param name="from">The state of the ball; it is copied.</param>
    /// <param name="request">The duration and the stop conditions.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentException"><paramref name="from"/> was never launched, or the run has several balls.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public void Start(in BallState from, LookAheadRequest request)
    {
        Check.Given(nameof(request), request);
        if (_alone is null)
        {
            _steps.Start([from], request);
        }
        else
        {
            _steps.Start(_alone, in from, request);
        }

        Start();
    }

    /// <summary>Starts a look-ahead of the balls of a group without taking a step, and cancels any look-ahead that is running.</summary>
    /// <param name="from">The states of the balls; they are copied.</param>
    /// <param name="request">The duration, and the event that ends it. A plane or a point is not supported.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The number of states differs from the number of balls, their times differ, a state was never launched, or the
    /// run has no group.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public void Start(BallState[] from, LookAheadRequest request)
    {
        Check.Given(nameof(from), from);
        Check.Given(nameof(request), request);
        _steps.Start(from, request);
        Start();
    }

    /// <summary>Takes a number of steps, or fewer if the look-ahead ends.</summary>
    /// <param name="maximumSteps">The maximum number of steps; at least 1.</param>
    /// <returns>True if the look-ahead is finished; false if it will continue.</returns>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="maximumSteps"/> is below 1.</exception>
    /// <exception cref="InvalidOperationException">
    /// No look-ahead is running, another look-ahead has used a trajectory, or a custom force is not finite.
    /// </exception>
    public bool Continue(int maximumSteps)
    {
        Check.Within(nameof(maximumSteps), maximumSteps, 1, int.MaxValue);
        if (!IsRunning)
        {
            throw new InvalidOperationException("No look-ahead is running. Call Start first.");
        }

        // Until the last step, an exception leaves the run in its stopped state.
        IsRunning = false;
        for (int i = 0; i < _paths.Length; i++)
        {
            if (_paths[i].Uses != _uses[i])
            {
                throw new InvalidOperationException("Another look-ahead has used a trajectory. Use a trajectory of its own for each run, and call Start again.");
            }
        }

        _steps.GoOn();
        _motions.Enter();
        try
        {
            Take(maximumSteps);
        }
        catch
        {
            // Remove the segments of the failed step.
            _steps.Break();
            throw;
        }
        finally
        {
            _motions.Leave();
        }

        // The last step may have reached the end, so no further call is needed.
        IsRunning = !_steps.HasEnded || _steps.IsTooLong;
        if (IsRunning)
        {
            _steps.Pause();
        }
        else
        {
            _steps.End();
        }

        return !IsRunning;
    }

    /// <summary>Stops the look-ahead. The paths keep the part computed so far.</summary>
    public void Cancel() => IsRunning = false;

    /// <summary>Returns true if a ball is still on its path; false if a kick or a hit has made the path outdated.</summary>
    /// <param name="ball">The current state of the first ball.</param>
    /// <param name="tolerance">The maximum distance from the path, in m; not negative, default 1e-5. For velocities it is multiplied by 100/s.</param>
    /// <returns>Also false if the ball's time is outside the part computed so far, unless the ball rests at the end of that part.</returns>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="tolerance"/> is negative.</exception>
    public bool Follows(in BallState ball, double tolerance = 1e-5) => Follows(0, in ball, tolerance);

    /// <inheritdoc cref="Follows(in BallState, double)"/>
    /// <param name="index">The index of the ball.</param>
    /// <param name="ball">The current state of the ball.</param>
    /// <param name="tolerance">The maximum distance from the path, in m; not negative, default 1e-5. For velocities it is multiplied by 100/s.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball, or <paramref name="tolerance"/> is negative.</exception>
    public bool Follows(int index, in BallState ball, double tolerance = 1e-5)
    {
        Check.Index(nameof(index), index, _paths.Length);
        Check.NotNegative(nameof(tolerance), tolerance);
        BallState.Launched(in ball);
        return _paths[index].Uses == _uses[index] && _uses[index] > 0 && _paths[index].Has(in ball, tolerance);
    }

    private void Start()
    {
        _motions.Start();
        Steps = 0;
        Begin(endsWhenFull: false);
        IsRunning = true;
    }

    /// <summary>Takes steps until the budget is used up or the look-ahead ends.</summary>
    private void Take(int maximumSteps)
    {
        for (int taken = 0; taken < maximumSteps;)
        {
            if (_steps.Take())
            {
                taken++;
                Steps++;
            }
            else if (!_steps.IsTooLong)
            {
                return;
            }
            else
            {
                // The path does not fit: simulate again, up to the last segment that fits.
                _motions.Leave();
                _motions.Restart();
                Begin(endsWhenFull: true);
                _steps.GoOn();
                _motions.Enter();
            }
        }
    }

    /// <summary>Begins the paths at the initial states.</summary>
    private void Begin(bool endsWhenFull)
    {
        _steps.Begin(endsWhenFull);
        _steps.Pause();
        for (int i = 0; i < _paths.Length; i++)
        {
            _uses[i] = _paths[i].Uses;
        }

        _steps.MoveBodies(_motions);
    }
}
