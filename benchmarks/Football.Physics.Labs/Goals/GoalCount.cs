using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Goals;

/// <summary>Counts shots that come to rest in a goal, and reported goals.</summary>
internal sealed class GoalCount
{
    /// <summary>The largest allowed difference between the time of an event and the time found on the sampled path, s.</summary>
    private const double Closeness = 1e-6;

    /// <summary>The time for which a shot is followed, s.</summary>
    private const double Longest = 12;

    private readonly Trajectory _path = new(1 << 16);

    public int Shots { get; private set; }

    /// <summary>The number of shots with a goal event.</summary>
    public int Reported { get; private set; }

    /// <summary>The number of these that hit the frame or the keeper before.</summary>
    public int Rebounds { get; private set; }

    /// <summary>The number of these that slid or rolled over the line.</summary>
    public int Carried { get; private set; }

    /// <summary>The number of shots that came to rest in a goal with nets.</summary>
    public int LieIn { get; private set; }

    /// <summary>The number of these without the event.</summary>
    public int LieInUnreported { get; private set; }

    /// <summary>The number of shots over the line of a goal by the sampled path, without the event.</summary>
    public int Missed { get; private set; }

    /// <summary>The number of shots with the event that were not over the line by the sampled path, at another time, or reported twice.</summary>
    public int Wrong { get; private set; }

    /// <summary>The number of shots that passed the mouth within a micrometre of post or bar, or turned back within a micrometre of the line.</summary>
    public int Undecided { get; private set; }

    /// <summary>The number of shots not followed to the end: the path had more pieces than the buffer holds.</summary>
    public int Cut { get; private set; }

    /// <summary>Simulates a shot. Returns true if events and sampled path agree.</summary>
    public bool Add(SeededRandom random)
    {
        var shot = new GoalShot(random);
        BallState start = shot.Start;
        shot.Simulator.LookAhead(in start, new LookAheadRequest { Duration = Longest, TimeStep = shot.TimeStep }, _path);
        var watch = new GoalWatch(shot.Goal, shot.Simulator.Scene.Ball.Radius);
        watch.Follow(_path);
        Shots++;
        Cut += _path.IsComplete ? 0 : 1;
        Undecided += watch.IsUndecided ? 1 : 0;
        BallEvent[] events = _path.Events.Span.ToArray();
        BallEvent[] reported = [.. events.Where(item => item.Kind == BallEventKind.Goal)];
        bool lies = shot.Goal.HasNet && _path.Final.Motion == MotionState.Rest && watch.LiesIn(_path.Final.Position);
        LieIn += lies ? 1 : 0;
        LieInUnreported += lies && reported.Length == 0 ? 1 : 0;
        if (reported.Length > 0)
        {
            Reported++;
            Rebounds += events.Any(item => item.Kind == BallEventKind.Impact && item.ColliderIndex > 0 && item.Time <= reported[0].Time) ? 1 : 0;
            Carried += MotionAt(reported[0].Time) is MotionState.Sliding or MotionState.Rolling ? 1 : 0;
        }

        bool missed = reported.Length == 0 && watch.Time < double.PositiveInfinity;
        bool wrong = reported.Length > 1 || (reported.Length == 1 && !(Math.Abs(reported[0].Time - watch.Time) <= Closeness));
        bool decided = !watch.IsUndecided;
        Missed += missed && decided ? 1 : 0;
        Wrong += wrong && decided ? 1 : 0;
        return !decided || !(missed || wrong || (lies && reported.Length == 0));
    }

    private MotionState MotionAt(double time)
    {
        foreach (ref readonly PathSegment piece in _path.Pieces)
        {
            if (piece.EndTime >= time)
            {
                return piece.Motion;
            }
        }

        return _path.Final.Motion;
    }
}
