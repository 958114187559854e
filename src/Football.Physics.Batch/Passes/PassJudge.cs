namespace FootballPhysics.Batch;

/// <summary>Judges kicks of a fan on their exact paths.</summary>
/// <param name="simulator">The open pitch.</param>
/// <param name="amongThings">The complete scene; null if it has no objects.</param>
internal sealed class PassJudge(Simulator simulator, Simulator? amongThings)
{
    /// <summary>The extra time that a look-ahead covers beyond the known bound, in s.</summary>
    private const double Ahead = 0.4;

    /// <summary>The step of a kick in a scene with objects, in s.</summary>
    private const double TimeStep = 0.02;

    private readonly StepLog _log = new() { IgnoresZones = true };
    private readonly Interception _query = new();
    private readonly Trajectory _path = new();

    /// <summary>Look-aheads of 1, 2, 3 … s, up to the duration of a pass, for passes in the air and on the ground.</summary>
    private LookAheadRequest[] _toImpact = [];
    private LookAheadRequest[] _toRest = [];
    private double _duration;

    /// <summary>Prepares for passes of a given duration.</summary>
    public void Begin(double duration)
    {
        if (_duration == duration)
        {
            return;
        }

        _duration = duration;
        int seconds = (int)Math.Ceiling(duration);
        _toImpact = new LookAheadRequest[seconds];
        _toRest = new LookAheadRequest[seconds];
        for (int i = 0; i < seconds; i++)
        {
            _toImpact[i] = new LookAheadRequest { Duration = Math.Min(i + 1, duration), StopAt = StopAt.Impact };
            _toRest[i] = _toImpact[i] with { StopAt = StopAt.Rest };
        }
    }

    /// <summary>Judges a kick.</summary>
    /// <param name="request">The fan.</param>
    /// <param name="index">The index of the kick.</param>
    /// <param name="mates">The team mates.</param>
    /// <param name="opponents">The opponents.</param>
    /// <param name="score">The known lower bound; on return the score, infinite if the kick is lost. It is the time of the receipt, in s, or the distance from the target, in m.</param>
    /// <param name="choice">The result for this kick, if it is not lost.</param>
    /// <returns>False if the look-ahead was too short: the score is then an improved lower bound.</returns>
    public bool Judge(PassFanRequest request, int index, Player[] mates, Player[] opponents, ref double score, out PassResult choice)
    {
        double known = mates.Length > 0 ? Math.Min(score + request.Margin + Ahead, _duration) : _duration;
        int seconds = Math.Min(Math.Max(0, (int)Math.Ceiling(known) - 1), _toImpact.Length - 1);
        bool ends = Fly(request, index, seconds, out Vector3d velocity, out Vector3d spin);
        bool isWhole = ends || seconds == _toImpact.Length - 1;
        BallState end = _path.Final;
        var meeting = new PathPoint(end.Time, end.Position, end.Velocity, 0);
        int receiver = mates.Length > 0 ? _query.FindFirst(_path, mates, out meeting) : -1;
        int opponent = _query.FindFirst(_path, opponents, out PathPoint lost);
        double lead = opponent < 0 ? double.PositiveInfinity : lost.Time - meeting.Time;
        choice = new PassResult { IsFound = true, Velocity = velocity, Spin = spin, Receiver = receiver, Meeting = meeting, TimeMargin = lead };
        bool holds;
        if (mates.Length == 0)
        {
            holds = ends && opponent < 0;
            score = (end.Position - (request.Target ?? request.From)).Horizontal.Length;
        }
        else
        {
            holds = receiver >= 0 && lead >= request.Margin;
            if (!isWhole && receiver < 0)
            {
                score = end.Time;
                return false;
            }

            if (!isWhole && opponent < 0 && !(meeting.Time + request.Margin <= end.Time))
            {
                score = meeting.Time;
                return false;
            }

            score = meeting.Time;
        }

        score = holds && !MeetsThing(request.From, in velocity, in spin, meeting.Time) ? score : double.PositiveInfinity;
        return true;
    }

    /// <summary>Returns true if a kick hits an object of the scene within a time.</summary>
    private bool MeetsThing(in Vector3d from, in Vector3d velocity, in Vector3d spin, double time)
    {
        // A player who has the ball already reaches it at once.
        if (amongThings is null || !(time > 0))
        {
            return false;
        }

        // A test run only: objects that it pushes are put back for the next kick.
        BallState ball = amongThings.Launch(from, velocity, spin);
        _log.Clear();
        _log.Pushes = false;
        amongThings.RunChecked(ref ball, TimeStep, time, StopAt.Time, _log, null);
        bool meets = _log.Events.Dropped > 0;
        foreach (ref readonly BallEvent happened in _log.Events.Span)
        {
            meets |= happened.Kind == BallEventKind.Net || (happened.Kind == BallEventKind.Impact && happened.ColliderIndex > 0);
        }

        return meets;
    }

    /// <summary>Returns the result of a kick with its lead over every opponent, which may need a longer look-ahead.</summary>
    public PassResult Completed(PassFanRequest request, int index, Player[] opponents, in PassResult choice, int kicks, int open)
    {
        double lead = choice.TimeMargin;
        if (double.IsPositiveInfinity(lead) && opponents.Length > 0)
        {
            Fly(request, index, _toImpact.Length - 1, out _, out _);
            int opponent = _query.FindFirst(_path, opponents, out PathPoint lost);
            lead = opponent < 0 ? lead : lost.Time - choice.Meeting.Time;
        }

        return new PassResult
        {
            IsFound = true,
            Velocity = choice.Velocity,
            Spin = choice.Spin,
            Receiver = choice.Receiver,
            Meeting = choice.Meeting,
            TimeMargin = lead,
            Kicks = kicks,
            Open = open,
        };
    }

    /// <summary>Simulates a kick.</summary>
    /// <returns>True if the pass lands, or comes to rest.</returns>
    private bool Fly(PassFanRequest request, int index, int seconds, out Vector3d velocity, out Vector3d spin)
    {
        request.Kick(index, out velocity, out spin);
        BallState ball = simulator.Launch(request.From, velocity, spin);
        bool rolls = ball.Motion != MotionState.Airborne;
        simulator.LookAhead(in ball, rolls ? _toRest[seconds] : _toImpact[seconds], _path);
        return rolls ? _path.Final.Motion == MotionState.Rest : _path.TryGetTouchdown(0, out _);
    }
}
