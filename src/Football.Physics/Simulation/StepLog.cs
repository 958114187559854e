using FootballPhysics.Contacts;
using FootballPhysics.Simulation;

namespace FootballPhysics;

/// <summary>The events and counts of a step or a run. Use one per ball or per thread, and reuse it.</summary>
public sealed partial class StepLog
{
    /// <summary>Creates an empty log.</summary>
    /// <param name="eventCapacity">The initial capacity for events, at least 1; default 32. It grows to at most <paramref name="mostEvents"/>.</param>
    /// <param name="mostEvents">The maximum number of events kept, at least 32; default <see cref="EventBuffer.DefaultMost"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A value is out of range. The message names the field, the value and the
    /// range.</exception>
    public StepLog(int eventCapacity = 32, int mostEvents = EventBuffer.DefaultMost) => Events = new EventBuffer(eventCapacity, mostEvents);

    /// <summary>The events since the last <see cref="Clear"/>, in order.</summary>
    public EventBuffer Events { get; }

    /// <summary>The number of integrated pieces: one per step, plus one for every event or split inside a step.</summary>
    public long Steps { get; internal set; }

    /// <summary>The number of force evaluations, including those that locate events.</summary>
    public long Evaluations { get; internal set; }

    /// <summary>The number of gap evaluations by searches for contacts.</summary>
    internal long SearchEvaluations { get; set; }

    /// <summary>The number of steps that ended early because they reached the limit of pieces or evaluations.</summary>
    /// <remarks>
    /// A step may use 8,192 pieces and 32,768 evaluations of forces and of gaps to other objects. After that, the ball keeps its position for the rest of the step. The count is 0 for any realistic
    /// football, but can grow if objects press the ball from all sides.
    /// </remarks>
    public long StalledSteps { get; internal set; }

    /// <summary>The number of steps in which a custom force changed faster than the integrator could follow.</summary>
    /// <remarks>
    /// A step is divided until its error is small, see <see cref="IForce"/>. If its evaluations do not suffice, the step is counted here, and the ball may keep its
    /// position for the rest of the step. The count is 0 for a spring or a damping of up to 3 000/s in steps of up to 1/30 s.
    /// </remarks>
    public long StiffSteps { get; internal set; }

    /// <summary>The number of impacts and other events that were counted but not reported.</summary>
    /// <remarks>
    /// After the tenth impact at one instant, further impacts are resolved together and not reported. The same holds after the 14th event
    /// of a step
    /// if moving objects press the ball. After the 14th event, impacts below the minimum bounce speed are not reported either.
    /// A <see cref="MotionState.Pinned"/> ball has no impacts. After the 20th event per 0.25 s of a step, only rest, goals and squeezes are
    /// reported.
    /// </remarks>
    public long UnreportedImpacts { get; internal set; }

    /// <summary>The number of moving contacts without load that were dropped because more than 16 surfaces touched the ball.</summary>
    /// <remarks>Stationary surfaces are never dropped.</remarks>
    public long LeftOut { get; internal set; }

    /// <summary>True after a piece of high order, which custom forces required: the ball may leave the bounds of its speed within a step.</summary>
    internal bool HasFollowed { get; set; }

    /// <summary>The step, in s, whose errors at the end of a slide are allowed in shorter steps too; 0: each step has its own.</summary>
    internal double CoarseStep { get; set; }

    /// <summary>True if the step ended early at the requested event.</summary>
    internal bool Halted { get; set; }

    /// <summary>The event at which steps end early.</summary>
    internal StopAt StopAt { get; set; }

    /// <summary>True if impacts push objects with a mass: in the game's own steps, but not in a look-ahead.</summary>
    internal bool Pushes { get; set; }

    /// <summary>True if a step ends early after an impact that pushes an object.</summary>
    internal bool HaltsAtPush { get; set; }

    /// <summary>True after an impact has pushed an object that has a mass.</summary>
    internal bool Pushed { get; set; }

    /// <summary>Stores the motions before a push, for steps that are repeated; null if no steps are repeated.</summary>
    internal MotionSnapshot? Motions { get; set; }

    /// <summary>True if a call continues a step: its counters then start at <see cref="Spent"/> instead of zero.</summary>
    internal bool Continues { get; set; }

    /// <summary>The counters of a step that is taken in several calls.</summary>
    internal StepBudget Spent;

    /// <summary>The observer that receives every piece of motion. Default null, which costs nothing.</summary>
    /// <remarks>A step is one piece, or several if it contains events.</remarks>
    internal PieceObserver? Observer
    {
        get => _observer;
        set
        {
            _observer = value;
            IsWatched = value is not null || _zones is not null;
            _path = value as PathObserver;
        }
    }

    /// <summary>True if only the path is observed: see <see cref="PathObserver"/>.</summary>
    internal bool WantsPathOnly => _path is not null && _zones is null;

    /// <summary>Reports a whole step of flight to an observer that ignores the states.</summary>
    /// <param name="stepper">Computes the acceleration at the end, if it is needed.</param>
    /// <param name="end">The ball at the end.</param>
    /// <param name="time">The start time, s.</param>
    /// <param name="position">Position at the start, m.</param>
    /// <param name="velocity">Velocity at the start, m/s.</param>
    /// <param name="spin">Spin at the start, rad/s.</param>
    /// <param name="acceleration">Acceleration at the start, m/s².</param>
    /// <param name="order">Order of the integrator.</param>
    internal void ShowFlight(
        Stepper stepper, in BallState end, double time, in Vector3d position, in Vector3d velocity, double spin, in Vector3d acceleration, int order) =>
        Halted |= _path!.AddFlight(stepper, in end, time, in position, in velocity, spin, in acceleration, PathSegment.DegreeOf(order, true));

    /// <summary>Reports a whole step without air, before it is taken, to an observer that ignores the states.</summary>
    /// <param name="start">The ball at the start.</param>
    /// <param name="h">The length of the step, s.</param>
    /// <param name="end">The end time, s.</param>
    /// <param name="climb">Upward velocity at the end, m/s.</param>
    /// <param name="height">Height at the end, m.</param>
    /// <param name="upward">The constant upward acceleration, m/s².</param>
    /// <param name="order">Order of the integrator.</param>
    internal void ShowFall(in BallState start, double h, double end, double climb, double height, double upward, int order) =>
        Halted |= _path!.AddFall(in start, h, end, climb, height, upward, PathSegment.DegreeOf(order, true));

    /// <summary>Reports a piece to the zones and to the observer.</summary>
    /// <param name="before">The ball at the start of the piece.</param>
    /// <param name="after">The ball at its end.</param>
    /// <param name="startAcceleration">Acceleration at the start, m/s².</param>
    /// <param name="endAcceleration">Acceleration at the end, m/s²; only if it is needed.</param>
    /// <param name="order">Order of the integrator.</param>
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

    /// <summary>Starts a step of a ball in a group, which is taken in several calls.</summary>
    /// <param name="ball">The index of the ball.</param>
    /// <param name="clears">Whether to clear the log.</param>
    /// <param name="zones">The zones that observe it; null if there are none.</param>
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
        Spent = default;
        Zones = null;
        zones?.Begin(this, in s);
    }

    /// <summary>Ends a step of a ball in a group.</summary>
    /// <param name="s">The ball.</param>
    internal void End(in BallState s)
    {
        _zones?.Moved(this, in s);
        Abandon();
    }

    /// <summary>Ends a step of a ball in a group after an exception.</summary>
    internal void Abandon()
    {
        Continues = false;
        Zones = null;
    }

    /// <summary>Reports an event between two calls of a step, or only counts it if the step has reported too many.</summary>
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
        Events.Add(other.Events);
        AddCounts(other);
        ZoneEvents += other.ZoneEvents;
    }

    /// <summary>Adds the counts of another log.</summary>
    internal void AddCounts(StepLog other)
    {
        Steps += other.Steps;
        Evaluations += other.Evaluations;
        SearchEvaluations += other.SearchEvaluations;
        StalledSteps += other.StalledSteps;
        StiffSteps += other.StiffSteps;
        UnreportedImpacts += other.UnreportedImpacts;
        LeftOut += other.LeftOut;
    }

    /// <summary>Returns a mark of the current contents, for <see cref="TakeBack"/>.</summary>
    internal StepLogMark Mark() => new(Events.Count, Events.Dropped, Events.Impacts, Steps, Evaluations, StalledSteps, UnreportedImpacts, LeftOut, StiffSteps, SearchEvaluations);

    /// <summary>Removes everything added after a mark.</summary>
    internal void TakeBack(in StepLogMark mark)
    {
        Events.TakeBack(mark.Events, mark.Missed, mark.Impacts);
        Steps = mark.Steps;
        Evaluations = mark.Evaluations;
        StalledSteps = mark.Stalled;
        StiffSteps = mark.Stiff;
        SearchEvaluations = mark.Searches;
        UnreportedImpacts = mark.Unreported;
        LeftOut = mark.LeftOut;
        Halted = false;
    }

    /// <summary>Removes all events and resets the counts.</summary>
    public void Clear()
    {
        Events.Clear();
        Steps = 0;
        Evaluations = 0;
        SearchEvaluations = 0;
        StalledSteps = 0;
        StiffSteps = 0;
        UnreportedImpacts = 0;
        LeftOut = 0;
        Halted = false;
        ZoneEvents = 0;
    }
}

/// <summary>A mark of the contents of a log.</summary>
/// <param name="Events">Number of events kept.</param>
/// <param name="Missed">Number of events dropped.</param>
/// <param name="Impacts">Number of impacts among both.</param>
/// <param name="Steps">Pieces.</param>
/// <param name="Evaluations">Force evaluations.</param>
/// <param name="Stalled">Steps that reached their limit.</param>
/// <param name="Unreported">Events that were only counted.</param>
/// <param name="LeftOut">Contacts dropped from a set.</param>
/// <param name="Stiff">Steps whose custom forces were not followed.</param>
/// <param name="Searches">Gap evaluations of searches.</param>
internal readonly record struct StepLogMark(int Events, long Missed, long Impacts, long Steps, long Evaluations, long Stalled, long Unreported, long LeftOut, long Stiff, long Searches);
