using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A look-ahead of several balls in parts: each call takes a limited number of steps, and the next call resumes there.</summary>
/// <remarks>
/// The finished paths are bit-identical to those of <see cref="SimulatorExtensions.LookAhead(BallGroup, BallState[], LookAheadRequest, Trajectory[])"/>,
/// for any number of steps per call. The run has its own copies of the balls and of the bodies' motions. Your game may therefore step and kick the balls of the
/// same group between calls. The run does not notice such changes: call <see cref="Follows"/> to detect them. Not thread-safe.
/// </remarks>
public sealed class GroupLookAheadRun
{
    private readonly BallGroup _group;
    private readonly Trajectory[] _paths;
    private readonly int[] _uses;
    private readonly LookAheadMotions _motions;
    private readonly GroupLookAheadSteps _steps;

    /// <summary>Creates a look-ahead in parts.</summary>
    /// <param name="group">The balls.</param>
    /// <param name="capacity">The number of path segments that fit for each ball; at first; at least 1, default 512. A path grows if it needs more.</param>
    /// <exception cref="ArgumentNullException"><paramref name="group"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is below 1, or the scene has engine colliders.</exception>
    public GroupLookAheadRun(BallGroup group, int capacity = 512)
    {
        _group = group ?? throw new ArgumentNullException(nameof(group));
        _motions = new LookAheadMotions(group.SimulatorOf(0).World);
        _paths = new Trajectory[group.Count];
        _uses = new int[group.Count];
        for (int i = 0; i < _paths.Length; i++)
        {
            _paths[i] = new Trajectory(capacity);
        }

        _steps = new GroupLookAheadSteps(group, _paths);
    }

    /// <summary>The paths so far, one per ball; <see cref="Trajectory.IsComplete"/> is false until the look-ahead is finished.</summary>
    public IReadOnlyList<Trajectory> Paths => _paths;

    /// <summary>True if the look-ahead was started and has not finished, failed or been cancelled.</summary>
    public bool IsRunning { get; private set; }

    /// <summary>The number of steps since the start; all balls take a step together.</summary>
    public long Steps { get; private set; }

    /// <summary>Starts a look-ahead without taking a step, and cancels any look-ahead that is running.</summary>
    /// <param name="from">The states of the balls; they are copied.</param>
    /// <param name="request">The duration, and the event that ends it. A plane or a point is not supported.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentException">The number of states differs from the number of balls, or a state was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public void Start(BallState[] from, LookAheadRequest request)
    {
        Check.Given(nameof(from), from);
        Check.Given(nameof(request), request);
        SimulatorExtensions.CheckGroup(_group, from, request, _paths);
        IsRunning = false;
        _motions.Start();
        _steps.Begin(from, request);
        _paths[0].Log.Pushes = _group.SimulatorOf(0).World.MayGiveWay;
        _steps.End(isComplete: false);
        for (int i = 0; i < _paths.Length; i++)
        {
            _uses[i] = _paths[i].Uses;
        }

        _motions.MoveTo(in from[0], _paths[0].OnStep);
        Steps = 0;
        IsRunning = true;
    }

    /// <summary>Takes a number of steps, or fewer if the look-ahead ends.</summary>
    /// <param name="maximumSteps">The maximum number of steps; at least 1.</param>
    /// <returns>True if the look-ahead is finished; false if it will continue.</returns>
    /// <exception cref="ArgumentException">The times of the states differ.</exception>
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
                throw new InvalidOperationException("Another look-ahead has used a trajectory. Call Start again.");
            }
        }

        bool isFinished = false;
        _steps.GoOn();
        _motions.Enter();
        try
        {
            for (int i = 0; i < maximumSteps && _steps.Take(); i++)
            {
                Steps++;
            }

            isFinished = _steps.HasEnded;
            IsRunning = !isFinished;
        }
        finally
        {
            // End each path at its ball's position, even after an exception.
            _motions.Leave();
            _steps.End(isFinished);
        }

        return isFinished;
    }

    /// <summary>Stops the look-ahead. The paths keep the part computed so far.</summary>
    public void Cancel() => IsRunning = false;

    /// <summary>Returns true if a ball is still on its path; false if a kick or a hit has made the path outdated.</summary>
    /// <param name="index">The index of the ball.</param>
    /// <param name="ball">The current state of the ball.</param>
    /// <param name="tolerance">The maximum distance from the path, in m; not negative, default 1e-5. For velocities it is multiplied by 100/s.</param>
    /// <returns>Also false if the ball's time is outside the part computed so far, unless the ball rests at the end of that part.</returns>
    /// <exception cref="ArgumentException"><paramref name="ball"/> was never launched.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball, or <paramref name="tolerance"/> is negative.</exception>
    public bool Follows(int index, in BallState ball, double tolerance = 1e-5)
    {
        Check.Index(nameof(index), index, _paths.Length);
        Check.NotNegative(nameof(tolerance), tolerance);
        BallState.Launched(in ball);
        return _paths[index].Uses == _uses[index] && _uses[index] > 0 && _paths[index].Has(in ball, tolerance);
    }
}
