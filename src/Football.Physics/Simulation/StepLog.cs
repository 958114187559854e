namespace FootballPhysics;

/// <summary>The log of a step or a run, beside the state: events in order, and counts. One a ball (or a thread); reused.</summary>
public sealed partial class StepLog
{
    /// <summary>Makes an empty log.</summary>
    /// <param name="eventCapacity">Events to make room for, at least 1; default 32. It grows up to <paramref name="mostEvents"/>.</param>
    /// <param name="mostEvents">How many events it keeps, at least 32; default <see cref="EventBuffer.DefaultMost"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public StepLog(int eventCapacity = 32, int mostEvents = EventBuffer.DefaultMost) => Events = new EventBuffer(eventCapacity, mostEvents);

    /// <summary>The events since the last <see cref="Clear"/>, in order.</summary>
    public EventBuffer Events { get; }

    /// <summary>Integrated pieces of motion: one a step, and one more for every event or split inside it.</summary>
    public long Steps { get; internal set; }

    /// <summary>Right-hand sides evaluated, those spent on locating events included.</summary>
    public long Evaluations { get; internal set; }

    /// <summary>
    /// Calls whose step had all the pieces (8 192) or evaluations (32 768) that one may have, before its end: the ball stayed where it was for the rest.
    /// 0 for anything like a football; where a ball is pressed from all sides time may not go on otherwise.
    /// </summary>
    public long StalledSteps { get; internal set; }

    /// <summary>
    /// Impacts that were not told one by one: where things that move press the ball, those of one instant after the tenth, of one step after its fourteenth event,
    /// are taken together; and after that event those slower than the slowest bounce, as of a ball that trembles in a corner. While the ball is <see cref="MotionState.Pinned"/> there are none.
    /// After the 20th event of a step (of a step longer than 0.25 s: of each 0.25 s), all kinds but rest, goals and squeezes are counted here.
    /// </summary>
    public long UnreportedImpacts { get; internal set; }

    /// <summary>
    /// Contacts of moving objects that were left out because more than 16 surfaces touched the ball at once, and that had no load. Stationary surfaces are never left out.
    /// </summary>
    public long LeftOut { get; internal set; }

    /// <summary>True when the step ended early at the event asked for.</summary>
    internal bool Halted { get; set; }

    /// <summary>The event at which steps end early.</summary>
    internal StopAt StopAt { get; set; }

    /// <summary>True when what has a mass goes on with what an impact left it: in the steps of a game, not where one only looks what would come.</summary>
    internal bool Pushes { get; set; }

    /// <summary>True when a step ends early after an impact that pushes something.</summary>
    internal bool HaltsAtPush { get; set; }

    /// <summary>True after an impact has pushed an object that has a mass.</summary>
    internal bool Pushed { get; set; }

    /// <summary>Keeps the motions before a push, for steps that are taken again; null if none are.</summary>
    internal MotionsBefore? Motions { get; set; }

    /// <summary>True if a call continues a step: its counters start at <see cref="Spent"/> instead of zero.</summary>
    internal bool Continues { get; set; }

    /// <summary>The counters of a step that is taken in several calls.</summary>
    internal StepBudget Spent;

    /// <summary>Watches every piece of motion: a step is one piece, or several where something happens in it. Default null, which costs nothing.</summary>
    public PieceObserver? Observer
    {
        get => _observer;
        set
        {
            _observer = value;
            IsWatched = value is not null || _zones is not null;
        }
    }

    /// <summary>Shows a piece to the zones and to the observer.</summary>
    /// <param name="before">The ball at the piece's start.</param>
    /// <param name="after">The ball at its end.</param>
    /// <param name="startAcceleration">Acceleration at the start, m/s².</param>
    /// <param name="endAcceleration">Acceleration at the end, m/s²; only where it is wanted.</param>
    /// <param name="order">Order of the method that took it.</param>
    internal void Show(in BallState before, in BallState after, in Vector3d startAcceleration, in Vector3d endAcceleration, int order)
    {
        _zones?.See(this, in before, in after, in startAcceleration, in endAcceleration, order);
        if (_observer is not { } observer)
        {
            return;
        }

        var piece = new PathSegment(
            before.Time,
            after.Time - before.Time,
            before.Position,
            before.Velocity,
            in startAcceleration,
            after.Position,
            after.Velocity,
            in endAcceleration,
            before.Motion,
            PathSegment.DegreeOf(order, observer.WantsEndAcceleration));
        Halted |= observer.Add(in before, in after, in piece);
    }

    /// <summary>Begins a step of a ball of a group, which is taken in several calls.</summary>
    /// <param name="ball">The ball's number.</param>
    /// <param name="clears">Whether the log is emptied.</param>
    /// <param name="zones">The zones that watch it; null if there are none.</param>
    /// <param name="s">The ball.</param>
    internal void Begin(int ball, bool clears, ZoneWatch? zones, in BallState s)
    {
        if (clears)
        {
            Clear();
        }

        Events.Ball = ball;
        StopAt = StopAt.Time;
        Halted = false;
        HaltsAtPush = false;
        Pushes = true;
        Pushed = false;
        Continues = true;
        Spent = StepBudget.New;
        Zones = null;
        zones?.Begin(this, in s);
    }

    /// <summary>Ends a step of a ball of a group.</summary>
    /// <param name="s">The ball.</param>
    internal void End(in BallState s)
    {
        _zones?.Moved(this, in s);
        Abandon();
    }

    /// <summary>Ends a step of a ball of a group that failed.</summary>
    internal void Abandon()
    {
        Continues = false;
        Zones = null;
    }

    /// <summary>Reports an event of a ball between two calls of its step, or only counts it if the step has reported too many.</summary>
    internal void Report(in BallEvent item)
    {
        if (StepBudget.Reports(item.Kind, Spent.Events, 0))
        {
            Spent.Events++;
            Events.Add(in item);
        }
        else
        {
            UnreportedImpacts++;
        }
    }

    /// <summary>Adds the events and counts of another log.</summary>
    internal void Add(StepLog other)
    {
        for (int i = 0; i < other.Events.Count; i++)
        {
            Events.Add(in other.Events[i]);
        }

        Steps += other.Steps;
        Evaluations += other.Evaluations;
        StalledSteps += other.StalledSteps;
        UnreportedImpacts += other.UnreportedImpacts;
        ZoneEvents += other.ZoneEvents;
    }

    /// <summary>Mark of its contents now, to come back to.</summary>
    internal StepLogMark Mark() => new(Events.Count, Events.Dropped, Events.Impacts, Steps, Evaluations, StalledSteps, UnreportedImpacts, LeftOut);

    /// <summary>Forgets what came after a mark.</summary>
    internal void TakeBack(in StepLogMark mark)
    {
        Events.TakeBack(mark.Events, mark.Missed, mark.Impacts);
        Steps = mark.Steps;
        Evaluations = mark.Evaluations;
        StalledSteps = mark.Stalled;
        UnreportedImpacts = mark.Untold;
        LeftOut = mark.LeftOut;
        Halted = false;
    }

    /// <summary>Forgets events and counts.</summary>
    public void Clear()
    {
        Events.Clear();
        Steps = 0;
        Evaluations = 0;
        StalledSteps = 0;
        UnreportedImpacts = 0;
        LeftOut = 0;
        Halted = false;
        ZoneEvents = 0;
    }
}

/// <summary>Contents of a log at one instant.</summary>
/// <param name="Events">Events that were kept.</param>
/// <param name="Missed">Events that were not.</param>
/// <param name="Impacts">Impacts among both.</param>
/// <param name="Steps">Pieces.</param>
/// <param name="Evaluations">Right-hand sides.</param>
/// <param name="Stalled">Steps that came to their last piece.</param>
/// <param name="Untold">Impacts that were not told one by one.</param>
/// <param name="LeftOut">Contacts that were left out of a set.</param>
internal readonly record struct StepLogMark(int Events, long Missed, long Impacts, long Steps, long Evaluations, long Stalled, long Untold, long LeftOut);
