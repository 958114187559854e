namespace FootballPhysics.Simulation;

/// <summary>Follows a ball to a time within its step.</summary>
internal sealed class BallLook
{
    private readonly StepLog _log = new();
    private int _ball = -1;
    private BallState _from;

    /// <summary>The ball at that time.</summary>
    public BallState State;

    /// <summary>Discards the ball.</summary>
    public void Forget() => _ball = -1;

    /// <summary>Follows a ball along its step. The motions of the objects that it pushes are restored afterwards.</summary>
    /// <param name="simulator">The scene of the ball.</param>
    /// <param name="ball">The index of the ball.</param>
    /// <param name="from">The ball.</param>
    /// <param name="duration">The duration, s.</param>
    /// <param name="spent">The counters of its step.</param>
    /// <param name="pushed">The motions of all objects that balls push.</param>
    public void Follow(Simulator simulator, int ball, in BallState from, double duration, in StepBudget spent, PushedMotions pushed)
    {
        _ball = ball;
        _from = from;
        State = from;
        _log.Clear();
        _log.Pushes = true;
        _log.Pushed = false;
        _log.Continues = true;
        _log.Spent = spent;
        if (duration > 0)
        {
            pushed.Keep();
            simulator.Advance(ref State, duration, _log);
            pushed.PutBack();
        }
    }

    /// <summary>Moves a ball to the time to which it was followed, if it is unchanged and has pushed no object.</summary>
    /// <param name="ball">The index of the ball.</param>
    /// <param name="s">The ball.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="own">Receives its events and counts.</param>
    public bool TryTake(int ball, ref BallState s, double time, StepLog own) => ball == _ball && TryTake(ref s, in _from, in State, time, _log, own);

    /// <summary>Moves a ball to the end of a computed path that starts at its state, ends at the given time, and pushes no
    /// object.</summary>
    /// <param name="s">The ball.</param>
    /// <param name="from">The start of the path.</param>
    /// <param name="end">Its end.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="log">The events and counts of the path.</param>
    /// <param name="own">Receives the events and counts of the ball.</param>
    public static bool TryTake(ref BallState s, in BallState from, in BallState end, double time, StepLog log, StepLog own)
    {
        bool isSame = end.Time == time && from.Time == s.Time && from.Position == s.Position && from.Velocity == s.Velocity && from.Spin == s.Spin
            && from.ClearUntil == s.ClearUntil && from.Motion == s.Motion && from.Carrier == s.Carrier;
        if (!isSame || log.Pushed || log.Halted || log.Events.Dropped > 0 || own.Observer is not null)
        {
            return false;
        }

        own.Zones?.Begin(own, in from);
        s = end;
        own.Add(log);
        own.ZonePlace = end.Position;
        own.Spent = log.Spent;
        return true;
    }
}
