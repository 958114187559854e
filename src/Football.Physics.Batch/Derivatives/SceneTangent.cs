using FootballPhysics.Contacts;
using FootballPhysics.Simulation;
using FootballPhysics.State;

namespace FootballPhysics.Batch;

/// <summary>Observes a simulation in one scene, and updates the derivatives by the launch segment by segment and event by event.</summary>
/// <remarks>
/// In plain flight, J̇ = A(t) J along the simulated path. The time of an event shifts with the launch by δt = −∇g·δy/ġ. There J ← R' (J + ẏ₋ ⊗ δt) − ẏ₊ ⊗ δt
/// (saltation), where R is the map of the event. <see cref="StepDifferences"/> handles all other steps.
/// </remarks>
internal sealed class SceneTangent : PieceObserver
{
    private readonly Surroundings _around;
    private readonly ImpactMap _impacts;
    private readonly EventSurface _surface;
    private readonly FlightTangent _flight;
    private readonly double _inertiaFactor;
    private readonly double[] _map = new double[MotionVector.Size * MotionVector.Size];
    private LocalFlight _now;
    private LocalFlight _next;
    private BallState _last;
    private StepLog? _log;
    private int _event;

    /// <summary>True if the tangent refers to the launch-dependent time of an event, false for one fixed time.</summary>
    private bool _atEvent;

    /// <summary>The end of the step, in s.</summary>
    private double _stepEnd;

    /// <summary>True if the entire step is one segment that is not yet processed.</summary>
    private bool _isHeld;

    /// <summary>True if the tangent at the start of the step is saved.</summary>
    private bool _isKept;

    /// <summary>True if the step contains more than plain flight and impacts.</summary>
    private bool _isLeft;

    public SceneTangent(Scene scene)
    {
        _around = new Surroundings(scene, SceneAir.Of(scene));
        _impacts = new ImpactMap(_around);
        _surface = new EventSurface(_around);
        _flight = new FlightTangent(_around);
        _now = new LocalFlight(_around);
        _next = new LocalFlight(_around);
        _inertiaFactor = scene.Ball.InertiaFactor;
    }

    /// <summary>The derivatives.</summary>
    public Tangent Tangent { get; } = new();

    /// <summary>The derivative of the last event's time by the launch: δt of each column.</summary>
    public double[] EventTimes { get; } = new double[Tangent.Columns];

    public override bool Add(in PathSegment piece) => false;

    /// <summary>Starts at a launch.</summary>
    /// <param name="from">The ball.</param>
    /// <param name="log">The log of the run; events from here on belong to the run.</param>
    public void Begin(in BallState from, StepLog log)
    {
        _log = log;
        _flight.Abandon();
        _isHeld = false;
        Tangent.Reset();
        Array.Clear(EventTimes, 0, EventTimes.Length);
        GoOn(in from);
        if (from.Motion is MotionState.Sliding or MotionState.Rolling)
        {
            // The ball is placed on the ground: remove the component along the normal.
            Vector3d normal = _around.World.CarrierOf(in from).At(from.Position, from.Time).Normal;
            Tangent.Project(0, in normal);
            Tangent.Project(MotionVector.Velocity, in normal);
            if (from.Motion == MotionState.Rolling)
            {
                Tangent.Roll(in normal, _around.Radius, _inertiaFactor);
            }
        }
    }

    /// <summary>Begins a step.</summary>
    /// <param name="start">The ball.</param>
    /// <param name="dt">The length of the step, in s.</param>
    public void BeginStep(in BallState start, double dt)
    {
        Commit();
        _stepEnd = start.Time + dt;
        _isKept = false;
        _isLeft = false;
        if (start.Motion != MotionState.Airborne || start.Nets != 0)
        {
            Leave();
        }
    }

    public override bool Add(in BallState before, in BallState after, in PathSegment piece)
    {
        if (_isLeft || !(after.Time > before.Time))
        {
            return false;
        }

        if (_isHeld)
        {
            Leave();
            return false;
        }

        bool isPlain = before.Motion == MotionState.Airborne && before.Nets == 0 && _flight.Takes(in before, in after);
        bool goesOn = isPlain && _flight.IsOpen && GoesOn(in before);
        if (goesOn && !_isKept && after.Time >= _stepEnd)
        {
            // A full step of an ongoing flight, the usual case. Hold it until the step ends without an event.
            _isHeld = true;
            _last = after;
            return false;
        }

        Keep();
        if (isPlain && !(goesOn && _flight.IsOpen))
        {
            Land();
            Join(in before);
            isPlain = _now.IsPlain;
        }

        if (!isPlain)
        {
            Leave();
            return false;
        }

        if (!_flight.IsOpen)
        {
            _flight.Begin(in before, _now.Branch, _log!.Events.Impacts > 0);
        }

        _flight.Add(in after);
        _last = after;
        return false;
    }

    /// <summary>Ends a step.</summary>
    /// <param name="end">The ball.</param>
    /// <returns>True if it contained more than plain flight and impacts. The tangent is then that at its start, and <see cref="StepDifferences"/> must update it.</returns>
    public bool EndStep(in BallState end)
    {
        // If an impact ended the run, the final state is that just before it.
        bool hit = _log!.Halted && _log.StopAt == StopAt.Impact;
        if (!hit && (end.Motion != MotionState.Airborne || end.Nets != 0))
        {
            Leave();
        }

        return _isLeft;
    }

    /// <summary>Continues after a step that <see cref="StepDifferences"/> has processed.</summary>
    /// <param name="from">The ball.</param>
    public void GoOn(in BallState from)
    {
        _last = from;
        _event = _log!.Events.Count;
        _atEvent = false;
        _now.Take(in from);
    }

    /// <summary>Ends the run.</summary>
    /// <remarks>If an event ended it, the tangent is that of the motion just before the event, at the time of <see cref="EventTimes"/>.</remarks>
    /// <param name="final">The ball.</param>
    /// <param name="ended">True if an event ended the run.</param>
    public void Finish(in BallState final, bool ended)
    {
        Land();
        if (!ended)
        {
            Join(in final);
            _last = final;
            return;
        }

        for (; _event < _log!.Events.Count && !_atEvent; _event++)
        {
            ref readonly BallEvent e = ref _log.Events[_event];
            if (e.Kind == BallEventKind.Impact)
            {
                ToImpact(e.ColliderIndex);
            }
        }
    }

    /// <summary>Returns true if a segment of flight continues the last one without an event in between.</summary>
    private bool GoesOn(in BallState before) =>
        _event == _log!.Events.Count && (before.Branch == _now.Branch || before.Branch == DragBranch.Unknown)
        && before.Time == _last.Time && before.Velocity == _last.Velocity;

    /// <summary>Processes the held step.</summary>
    private void Commit()
    {
        if (_isHeld)
        {
            _isHeld = false;
            _flight.Add(in _last);
        }
    }

    /// <summary>Ends the current plain flight.</summary>
    private void Land()
    {
        Commit();
        if (_flight.IsOpen)
        {
            _flight.End(Tangent);
        }
    }

    /// <summary>Saves the tangent at the start of the step.</summary>
    private void Keep()
    {
        if (!_isKept)
        {
            Land();
            Tangent.Keep();
            _isKept = true;
        }
    }

    /// <summary>Leaves the entire step to <see cref="StepDifferences"/>.</summary>
    private void Leave()
    {
        if (_isLeft)
        {
            return;
        }

        _isLeft = true;
        _isHeld = false;
        if (_isKept)
        {
            _flight.Abandon();
            Tangent.Restore();
        }
        else
        {
            Land();
        }
    }

    /// <summary>Processes the events between the last segment and the next, and starts the next motion.</summary>
    private void Join(in BallState before)
    {
        BallState at = _last;
        int nested = 0;
        for (; _event < _log!.Events.Count; _event++)
        {
            ref readonly BallEvent e = ref _log.Events[_event];
            if (e.Kind == BallEventKind.Impact && nested-- <= 0)
            {
                nested = Hit(ref at, e.ColliderIndex);
            }
        }

        _next.Take(in before);
        if (!_atEvent && _now.Branch != _next.Branch && _now.Branch < DragBranch.AlongCriticalSpeed && at.Motion == before.Motion)
        {
            ToEvent(_surface.DragJump(_now, _next.Branch, at.Time, MotionVector.Of(in at)));
        }

        if (_atEvent)
        {
            _next.Rates(before.Time, MotionVector.Of(in before), out MotionRates rates);
            Tangent.Shift(before.Velocity, in rates, EventTimes, -1.0);
        }

        _atEvent = false;
        (_now, _next) = (_next, _now);
    }

    /// <summary>Processes an impact.</summary>
    /// <returns>The number of further impacts at the same time.</returns>
    private int Hit(ref BallState at, int thing)
    {
        if (!_atEvent)
        {
            ToImpact(thing);
        }

        int impacts = _impacts.Impact(ref at, thing, _map);
        Tangent.Map(_map);
        if (_around.World.Moves)
        {
            Tangent.Add(_impacts.TimeRate, EventTimes);
        }

        return impacts - 1;
    }

    private void ToImpact(int thing) => ToEvent(_surface.Contact(thing, in _last));

    private void ToEvent(in EventGradient g)
    {
        if (!(Math.Abs(g.Rate) > 0))
        {
            return;
        }

        _now.Rates(_last.Time, MotionVector.Of(in _last), out MotionRates rates);
        Tangent.Times(in g.Place, in g.Velocity, in g.Spin, g.Rate, EventTimes);
        Tangent.Shift(_last.Velocity, in rates, EventTimes, 1.0);
        _atEvent = true;
    }
}
