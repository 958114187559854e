using FootballPhysics.Contacts;

namespace FootballPhysics.Prediction;

/// <summary>The steps of a look-ahead of several balls, taken one at a time.</summary>
/// <param name="group">The balls.</param>
/// <param name="into">Receives the path of each ball.</param>
internal sealed class GroupLookAheadSteps(BallGroup group, Trajectory[] into)
{
    private readonly BallGroup _group = group;
    private readonly BallState[] _states = new BallState[group.Count];
    private readonly Trajectory[] _into = into;
    private readonly StepLog[] _logs = [.. into.Select(path => path.Log)];
    private StopAt _stopAt;
    private double _step;
    private double _end;
    private double _last;
    private bool _hasBegun;
    private bool _hasEnded;

    /// <summary>True if the time has run out, or an event has ended the look-ahead.</summary>
    public bool HasEnded => _hasEnded || (_hasBegun && !(_states[0].Time < _last));

    /// <summary>Begins the paths.</summary>
    /// <param name="from">The initial states; unchanged.</param>
    /// <param name="request">The duration and the stop condition.</param>
    public void Begin(BallState[] from, LookAheadRequest request)
    {
        Array.Copy(from, _states, from.Length);
        _stopAt = request.StopAt;
        _hasBegun = false;
        _hasEnded = false;

        // All balls share one step length.
        _step = request.TimeStep;
        _end = from[0].Time + request.Duration;
        _last = _end - (ContactTolerances.StepRounding * _step);
        for (int i = 0; i < _into.Length; i++)
        {
            // Each path stores its own ball's segments and events.
            _into[i].Begin(_group.SimulatorOf(i), in from[i], request, endsWhenFull: false, goesOn: true);
        }
    }

    /// <summary>Takes one step of all balls.</summary>
    /// <returns>False if the look-ahead had already ended.</returns>
    public bool Take()
    {
        // Take at least one step, because the step validates the states.
        if (HasEnded)
        {
            return false;
        }

        _hasBegun = true;
        double left = _end - _states[0].Time;
        bool ended = _group.Step(_states, Math.Min(_step, left), null, _stopAt == StopAt.Impact ? StopAt.Impact : StopAt.Time, _logs);
        _into[0].OnStep?.Invoke(in _states[0]);
        _hasEnded = ended || (_stopAt == StopAt.Rest && AllRest());
        return true;
    }

    /// <summary>Continues after a pause.</summary>
    public void GoOn()
    {
        foreach (Trajectory path in _into)
        {
            path.GoOn();
        }
    }

    /// <summary>Ends each path at its ball's position.</summary>
    /// <param name="isComplete">False if the look-ahead will continue.</param>
    public void End(bool isComplete)
    {
        for (int i = 0; i < _into.Length; i++)
        {
            if (isComplete)
            {
                _into[i].End(in _states[i]);
                _into[i].EndFull();
            }
            else
            {
                _into[i].Pause(in _states[i]);
            }
        }
    }

    private bool AllRest()
    {
        foreach (ref readonly BallState state in _states.AsSpan())
        {
            if (state.Motion != MotionState.Rest)
            {
                return false;
            }
        }

        return true;
    }
}
