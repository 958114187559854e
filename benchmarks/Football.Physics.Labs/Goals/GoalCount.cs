using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Goals;

/// <summary>Counts shots that come to lie in a goal, and those that are told to be goals.</summary>
internal sealed class GoalCount
{
    /// <summary>How far the time of an event may be off that of the watched path, s.</summary>
    private const double Closeness = 1e-6;

    /// <summary>How long a shot is watched, s.</summary>
    private const double Longest = 12;

    private readonly Trajectory _path = new(1 << 16);

    public int Shots { get; private set; }

    /// <summary>With the event.</summary>
    public int Told { get; private set; }

    /// <summary>Of these, met the frame or who stood there before.</summary>
    public int Rebounds { get; private set; }

    /// <summary>Of these, were carried by the ground over the line.</summary>
    public int Carried { get; private set; }

    /// <summary>Came to lie in a goal with nets.</summary>
    public int LieIn { get; private set; }

    /// <summary>Of these, without the event.</summary>
    public int LieInUntold { get; private set; }

    /// <summary>Were over the line of a goal by the watched path, without the event.</summary>
    public int Missed { get; private set; }

    /// <summary>With the event, and not over the line by the watched path, or at another time, or twice.</summary>
    public int Wrong { get; private set; }

    /// <summary>Came through the mouth within a micrometre of post or bar.</summary>
    public int Undecided { get; private set; }

    /// <summary>Not watched to the end: the path had more pieces than room.</summary>
    public int Cut { get; private set; }

    /// <summary>Plays a shot. True where event and watched path agree.</summary>
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
        BallEvent[] told = [.. events.Where(item => item.Kind == BallEventKind.Goal)];
        bool lies = shot.Goal.HasNet && _path.Final.Motion == MotionState.Rest && watch.LiesIn(_path.Final.Position);
        LieIn += lies ? 1 : 0;
        LieInUntold += lies && told.Length == 0 ? 1 : 0;
        if (told.Length > 0)
        {
            Told++;
            Rebounds += events.Any(item => item.Kind == BallEventKind.Impact && item.ColliderIndex > 0 && item.Time <= told[0].Time) ? 1 : 0;
            Carried += MotionAt(told[0].Time) is MotionState.Sliding or MotionState.Rolling ? 1 : 0;
        }

        bool missed = told.Length == 0 && watch.Time < double.PositiveInfinity;
        bool wrong = told.Length > 1 || (told.Length == 1 && !(Math.Abs(told[0].Time - watch.Time) <= Closeness));
        bool decided = !watch.IsUndecided;
        Missed += missed && decided ? 1 : 0;
        Wrong += wrong && decided ? 1 : 0;
        return !decided || !(missed || wrong || (lies && told.Length == 0));
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
