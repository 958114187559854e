using FootballPhysics.Contacts;
using FootballPhysics.Numerics;

namespace FootballPhysics.Prediction;

/// <summary>A look-ahead of one or several balls, taken one step at a time.</summary>
/// <remarks>A look-ahead in one go and a look-ahead in parts take the same steps, so their results are bit-identical.</remarks>
/// <param name="group">The balls; null for a single ball.</param>
/// <param name="into">Receives the path of each ball.</param>
internal sealed class LookAheadSteps(BallGroup? group, Trajectory[] into)
{
    private readonly BallGroup? _group = group;
    private readonly Trajectory[] _into = into;
    private readonly StepLog[] _logs = [.. into.Select(path => path.Log)];
    private readonly BallState[] _from = new BallState[into.Length];
    private readonly BallState[] _states = new BallState[into.Length];
    private Simulator _simulator = null!;
    private LookAheadRequest _request = null!;
    private double _end;
    private double _last;
    private bool _endsWhenFull;

    /// <summary>True if an event has ended the look-ahead.</summary>
    public bool IsHalted { get; private set; }

    /// <summary>True if the time has run out, or an event has ended the look-ahead.</summary>
    public bool HasEnded => !(_states[0].Time < _last) || IsHalted;

    /// <summary>True if the path of a single ball does not fit. It must be simulated again, up to the last segment that fits.</summary>
    /// <remarks>A path that exactly fills the buffer is complete. In a group, a ball continues without its path.</remarks>
    public bool IsTooLong => _group is null && _into[0].Overflows && !_endsWhenFull;

    /// <summary>Sets the start of a single ball.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="from">The initial state.</param>
    /// <param name="request">The duration and the stop conditions.</param>
    public void Start(Simulator simulator, in BallState from, LookAheadRequest request)
    {
        request.Validate();
        request.CheckClock(in from);
        BallState.Launched(in from);
        _simulator = simulator;
        _request = request;
        _from[0] = from;
    }

    /// <summary>Sets the start of the balls of a group.</summary>
    /// <param name="from">The initial states.</param>
    /// <param name="request">The duration and the stop condition.</param>
    public void Start(BallState[] from, LookAheadRequest request)
    {
        request.Validate();
        if (from.Length != _from.Length)
        {
            throw new ArgumentException($"from has {from.Length} states, but there are {_from.Length} balls. Pass one state for each ball.");
        }

        // If a single ball reached the plane, all paths would end.
        if (request.UntilPlane is not null || request.UntilPassing is not null)
        {
            string field = request.UntilPlane is null ? "lookAhead.untilPassing" : "lookAhead.untilPlane";
            throw Check.Conflict(field, field + " is not supported for several balls. Leave it unset, and search each path for the crossing.");
        }

        request.CheckClock(in from[0]);
        for (int i = 0; i < from.Length; i++)
        {
            BallGroup.CheckState(in from[i], i, from[0].Time);
        }

        _simulator = _group!.SimulatorOf(0);
        _request = request;
        Array.Copy(from, _from, from.Length);
    }

    /// <summary>Begins the paths at the start.</summary>
    /// <param name="endsWhenFull">True to end with the last segment that fits; false to end at the first one that does not.</param>
    public void Begin(bool endsWhenFull)
    {
        _endsWhenFull = endsWhenFull;
        IsHalted = false;
        Array.Copy(_from, _states, _from.Length);

        // All balls share one step length. A remainder below a billionth of a step is only rounding error of the clock.
        _end = _from[0].Time + _request.Duration;
        _last = _end - (ContactTolerances.StepRounding * _request.TimeStep);
        for (int i = 0; i < _into.Length; i++)
        {
            // Each path stores its own ball's segments and events.
            _into[i].Begin(_group?.SimulatorOf(i) ?? _simulator, in _from[i], _request, endsWhenFull, goesOn: _group is not null);
        }

        // The look-ahead also pushes movable objects, and restores them afterwards.
        _logs[0].Pushes = _simulator.World.MayGiveWay;
    }

    /// <summary>Continues from the end of the path of a single ball, in whole steps.</summary>
    /// <param name="end">The time that the last step reaches or passes, s.</param>
    public void Extend(double end)
    {
        IsHalted = false;
        _end = double.PositiveInfinity;
        _last = end;
        _states[0] = _into[0].Final;
        _into[0].Resume();
    }

    /// <summary>Takes one step.</summary>
    /// <returns>False if the look-ahead had already ended.</returns>
    public bool Take()
    {
        if (HasEnded)
        {
            return false;
        }

        IsHalted = Advance(Math.Min(_request.TimeStep, _end - _states[0].Time));
        _into[0].OnStep?.Invoke(in _states[0]);
        return true;
    }

    /// <summary>Takes all steps in one go.</summary>
    public void Run()
    {
        World world = _simulator.World;
        bool moves = _into[0].OnStep is not null || world.MayGiveWay;
        if (moves)
        {
            world.KeepMotions();

            // Move the bodies to the start time, because the game may have set them to another time.
            _into[0].OnStep?.Invoke(in _states[0]);
        }

        try
        {
            while (Take())
            {
            }
        }
        catch
        {
            Break();
            throw;
        }
        finally
        {
            if (moves)
            {
                world.PutMotionsBack();
            }
        }

        End();
    }

    /// <summary>Moves the bodies to the start time, because the game may have set them to another time.</summary>
    /// <param name="motions">The motions of the look-ahead.</param>
    public void MoveBodies(LookAheadMotions motions) => motions.MoveTo(in _from[0], _into[0].OnStep);

    /// <summary>Continues after a pause.</summary>
    public void GoOn()
    {
        foreach (Trajectory path in _into)
        {
            path.GoOn();
        }
    }

    /// <summary>Shows the paths so far.</summary>
    public void Pause()
    {
        for (int i = 0; i < _into.Length; i++)
        {
            _into[i].Pause(in _states[i]);
        }
    }

    /// <summary>Ends each path at its ball's position.</summary>
    public void End()
    {
        for (int i = 0; i < _into.Length; i++)
        {
            _into[i].End(in _states[i]);
        }
    }

    /// <summary>Ends each path before a step that failed.</summary>
    public void Break()
    {
        for (int i = 0; i < _into.Length; i++)
        {
            _into[i].Break(in _states[i]);
        }
    }

    /// <summary>Takes one step.</summary>
    /// <returns>True if an event ends the look-ahead.</returns>
    private bool Advance(double dt)
    {
        if (_group is not null)
        {
            bool ended = _group.Step(_states, dt, null, _request.StopAt == StopAt.Impact ? StopAt.Impact : StopAt.Time, _logs);
            return ended || (_request.StopAt == StopAt.Rest && Array.TrueForAll(_states, state => state.Motion == MotionState.Rest));
        }

        _logs[0].Halted = false;
        _logs[0].StopAt = _request.StopAt;
        _simulator.Advance(ref _states[0], dt, _logs[0]);
        return _logs[0].Halted;
    }
}
