using FootballPhysics.Contacts;

namespace FootballPhysics.Prediction;

/// <summary>The steps of a look-ahead of one ball, taken one at a time.</summary>
/// <remarks>A look-ahead in one go and a look-ahead in parts take the same steps, so their results are bit-identical.</remarks>
internal struct LookAheadSteps
{
    private readonly Simulator _simulator;
    private readonly LookAheadRequest _request;
    private readonly Trajectory _into;
    private readonly double _end;
    private readonly double _last;

    /// <summary>The ball.</summary>
    public BallState State;

    /// <summary>Begins a path.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="from">The initial state.</param>
    /// <param name="request">The duration and the stop conditions.</param>
    /// <param name="into">Receives the path.</param>
    /// <param name="endsWhenFull">True to end with the last segment that fits; false to end at the first one that does not.</param>
    public LookAheadSteps(Simulator simulator, in BallState from, LookAheadRequest request, Trajectory into, bool endsWhenFull)
    {
        into.Begin(simulator, in from, request, endsWhenFull);
        into.LeaveOpen(request);
        _simulator = simulator;
        _request = request;
        _into = into;

        _end = from.Time + request.Duration;

        // A remainder below a billionth of a step is only rounding error of the clock.
        _last = _end - (ContactTolerances.StepRounding * request.TimeStep);
        State = from;
        into.Log.Halted = false;
        into.Log.StopAt = request.StopAt;
    }

    /// <summary>True if the time has run out, or an event has ended the look-ahead.</summary>
    public readonly bool HasEnded => !(State.Time < _last) || _into.Log.Halted;

    /// <summary>Takes one step.</summary>
    /// <returns>False if the look-ahead had already ended.</returns>
    public bool Take()
    {
        if (HasEnded)
        {
            return false;
        }

        double left = _end - State.Time;
        _simulator.Advance(ref State, _request.TimeStep < left ? _request.TimeStep : left, _into.Log);
        _into.OnStep?.Invoke(in State);
        return true;
    }
}
