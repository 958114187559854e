namespace Football.Physics;

/// <summary>
/// The derivatives by the launch in one scene. Between events J̇ = A(t) J along the path that the simulation took; at an event, whose time moves with the
/// launch by δt = −∇g·δy/ġ, J ← R' (J + ẏ₋ ⊗ δt) − ẏ₊ ⊗ δt (saltation), R being what the event does to the motion.
/// </summary>
internal sealed class SceneTangent<TAir> : TangentObserver
    where TAir : struct, IAir
{
    private readonly Surroundings<TAir> _around;
    private readonly ImpactMap<TAir> _impacts;
    private readonly EventSurface<TAir> _surface;
    private readonly FlightTangent<TAir> _flight;
    private readonly double _restEnergy;
    private readonly BallProperties _ball;
    private readonly double[] _map = new double[MotionVector.Size * MotionVector.Size];
    private readonly PieceTangent<TAir> _piece;
    private readonly NetPieceTangent<TAir> _inNets;
    private LocalMotion<TAir> _now;
    private LocalMotion<TAir> _next;
    private BallState _last;
    private StepLog? _log;
    private int _event;

    /// <summary>Whether the tangent is that of one event's time for all launches, and not of one time.</summary>
    private bool _atEvent;

    /// <summary>A piece of a slide that is not taken yet.</summary>
    private bool _isHeld;
    private BallState _heldBefore;
    private BallState _heldAfter;

    /// <summary>Whether all spin ended with the last piece.</summary>
    private bool _spinEnded;

    /// <summary>Whether the last piece was the end of a slide, which leaves the spin of a roll.</summary>
    private bool _rolls;

    public SceneTangent(Scene scene, Integrator integrator, in TAir air)
    {
        _around = new Surroundings<TAir>(scene, in air);
        _impacts = new ImpactMap<TAir>(scene, _around);
        _surface = new EventSurface<TAir>(_around);
        _flight = new FlightTangent<TAir>(_around);
        var step = new StepTangent<TAir>(Tangent, integrator);
        _piece = new PieceTangent<TAir>(Tangent, _around.Radius, step);
        _inNets = new NetPieceTangent<TAir>(Tangent, step, _around.World);
        _now = new LocalMotion<TAir>(_around, scene.Ground.Heights is null, scene.Ball);
        _next = new LocalMotion<TAir>(_around, scene.Ground.Heights is null, scene.Ball);
        _restEnergy = scene.Ground.RestEnergy;
        _ball = scene.Ball;
    }

    public override void Begin(in BallState from, StepLog log)
    {
        _log = log;
        _event = log.Events.Count;
        _last = from;
        _atEvent = false;
        _rolls = false;
        _isHeld = false;
        _spinEnded = false;
        Array.Clear(EventTimes, 0, EventTimes.Length);
        _flight.Abandon();
        _inNets.Start();
        Tangent.Reset();
        _now.Take(in from);
        if (from.Motion is MotionState.Sliding or MotionState.Rolling)
        {
            // Placed on the ground: neither off it nor into it.
            Vector3d normal = _now.NormalAt(from.Position, from.Time);
            Tangent.Project(0, in normal);
            Tangent.Project(MotionVector.Velocity, in normal);
            if (from.Motion == MotionState.Rolling)
            {
                Tangent.Roll(in normal, _around.Radius, _ball.InertiaFactor);
            }
        }
    }

    public override bool Add(in BallState before, in BallState after, in PathPiece piece)
    {
        double h = after.Time - before.Time;
        if (!(h > 0))
        {
            return false;
        }

        // Plain flight goes on where nothing has happened: whole steps of it are taken together.
        if (_flight.IsOpen && GoesOn(in before) && _flight.Takes(in before, in after))
        {
            _flight.Add(in after);
            _last = after;
            return false;
        }

        if (_isHeld && SlidesOn(in before))
        {
            _heldAfter = after;
            _last = after;
            return false;
        }

        Join(in before);
        if (_now.IsPlainFlight && _flight.Takes(in before, in after))
        {
            _flight.Begin(in before, _now.Branch, _log!.Events.Impacts > 0);
            _flight.Add(in after);
            _last = after;
            return false;
        }

        _spinEnded = before.SpinRate > 0 && after.SpinRate == 0;
        if (before.Motion == MotionState.Sliding)
        {
            // Whether it is the last of a slide, what comes next tells.
            _isHeld = true;
            _heldBefore = before;
            _heldAfter = after;
        }
        else if (before.Motion == MotionState.Airborne && _now.Nets != 0 && !_now.IsGuided)
        {
            _inNets.Propagate(_now, in before, h, StepEnd);
        }
        else
        {
            _piece.Propagate(_now, before.Time, MotionVector.Of(in before), MotionVector.Of(in after), h);
        }

        _last = after;
        return false;
    }

    public override void Finish(in BallState final, bool ended)
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
                ToImpact(e.Thing);
            }
            else if (e.Kind == BallEventKind.Rest)
            {
                ToRest();
            }
        }
    }

    /// <summary>Whether a piece of flight begins as the last one ended, without an event between them.</summary>
    private bool GoesOn(in BallState before) =>
        _event == _log!.Events.Count && before.Motion == MotionState.Airborne && before.Nets == 0
        && (before.Branch == _now.Branch || before.Branch == DragBranch.Unknown) && before.Time == _last.Time && before.Velocity == _last.Velocity;

    /// <summary>Whether a piece goes on with the last moment of a slide, which is taken as one: the shorter it gets, the less its pieces tell.</summary>
    private bool SlidesOn(in BallState before) =>
        before.Motion == MotionState.Sliding && _event == _log!.Events.Count && before.Nets == _heldBefore.Nets && before.Branch == _heldBefore.Branch
        && before.Carrier == _heldBefore.Carrier && _now.IsAlmostRolling(_heldBefore.Time, MotionVector.Of(in _heldBefore));

    /// <summary>Ends a plain flight that is under way, and takes the piece of a slide that was held.</summary>
    private void Land()
    {
        if (_flight.IsOpen)
        {
            _flight.End(Tangent);
        }

        if (!_isHeld)
        {
            return;
        }

        _isHeld = false;
        Motion start = MotionVector.Of(in _heldBefore);
        if (_event < _log!.Events.Count && _log.Events[_event].Kind == BallEventKind.Roll)
        {
            _piece.EndSlide(_now, _heldBefore.Time, in start, EventTimes);
            _atEvent = true;
            _rolls = true;
        }
        else
        {
            _piece.Propagate(_now, _heldBefore.Time, in start, MotionVector.Of(in _heldAfter), _heldAfter.Time - _heldBefore.Time);
        }
    }

    /// <summary>Goes through the events between the last piece and where the ball goes on from, and takes up what moves it there.</summary>
    private void Join(in BallState before)
    {
        Land();
        BallState at = _last;
        int nested = 0;
        bool hit = false;
        for (; _event < _log!.Events.Count; _event++)
        {
            ref readonly BallEvent e = ref _log.Events[_event];
            switch (e.Kind)
            {
                case BallEventKind.Impact when nested > 0:
                    nested--;
                    break;
                case BallEventKind.Impact:
                    hit = true;
                    Hit(ref at, e.Thing, ref nested);
                    break;
                case BallEventKind.Roll when !hit && !_rolls:
                    _impacts.StartRolling(ref at, _map);
                    Tangent.Map(_map);
                    break;
                case BallEventKind.Slide when !hit:
                    ToEvent(_surface.Grip(_now, at.Time, MotionVector.Of(in at)));
                    break;
                case BallEventKind.Rest:
                    ToRest();
                    Tangent.Clear(MotionVector.Velocity);
                    Tangent.Clear(MotionVector.Spin);
                    break;
            }
        }

        _next.Take(in before);
        if (!_atEvent)
        {
            Compare(in at, in before);
        }

        if (_atEvent)
        {
            _next.Rates(before.Time, MotionVector.Of(in before), out MotionRates rates);
            Tangent.Shift(before.Velocity, in rates, EventTimes, -1.0);
            _inNets.Start(EventTimes);
        }
        else
        {
            _inNets.GoOn(_next, in before);
        }

        _atEvent = false;
        _rolls = false;
        _spinEnded = false;
        (_now, _next) = (_next, _now);
    }

    /// <summary>What changed without an event that is told: the branch of the drag law, a net, drilling friction that has ended a spin, the end of all spin.</summary>
    private void Compare(in BallState at, in BallState before)
    {
        Motion motion = MotionVector.Of(in at);
        if (_now.Motion != _next.Motion)
        {
            return;
        }

        if (_now.Branch != _next.Branch && _now.Branch < DragBranch.AlongCriticalSpeed)
        {
            ToEvent(_surface.DragJump(_now, _next.Branch, at.Time, in motion));
        }
        else if (_now.Nets != _next.Nets)
        {
            ToEvent(_surface.Net(_now, _next, in motion));
        }
        else if (_inNets.WasTaken && _surface.Slack(_now, at.Time, in motion, out EventGradient slack))
        {
            ToEvent(in slack);
        }
        else if (_now.SpinSign != 0 && _next.SpinSign == 0 && _now.Drills && _next.Motion != MotionState.Airborne)
        {
            ShapePoint surface = _now.SurfaceAt(at.Position, at.Time);
            Tangent.EndDrilling(surface.Normal, surface.Curvature, at.Spin);
        }

        if (_next.IsPinned && !_now.IsPinned)
        {
            // It stands: it only spins about the normal.
            Tangent.Clear(MotionVector.Velocity);
            Tangent.Keep(MotionVector.Spin, _next.NormalAt(before.Position, before.Time));
        }

        if (_spinEnded)
        {
            Tangent.Clear(MotionVector.Spin);
        }
    }

    private void Hit(ref BallState at, int thing, ref int nested)
    {
        if (!_atEvent)
        {
            ToImpact(thing);
        }

        _inNets.Hit();
        nested = _impacts.Impact(ref at, thing, _map) - 1;
        Tangent.Map(_map);
        if (_around.World is { Moves: true })
        {
            Tangent.Add(_impacts.TimeRate, EventTimes);
        }
    }

    private void ToImpact(int thing) => ToEvent(_surface.Contact(thing, in _last));

    private void ToRest()
    {
        if (_atEvent)
        {
            return;
        }

        // E = ½ m |v−V|² + ½ I ω²
        Vector3d carrier = _around.World is { } world ? world.CarrierOf(in _last).Velocity : Vector3d.Zero;
        Vector3d impulse = _ball.Mass * (_last.Velocity - carrier);
        Vector3d turn = _ball.MomentOfInertia * _last.Spin;
        _now.Rates(_last.Time, MotionVector.Of(in _last), out MotionRates rates);
        double power = Vector3d.Dot(in impulse, in rates.Acceleration) + Vector3d.Dot(in turn, in rates.SpinAcceleration);
        ToEvent(new EventGradient(Vector3d.Zero, in impulse, in turn, power));
    }

    private void ToEvent(in EventGradient g)
    {
        if (!(Math.Abs(g.Rate) > 0))
        {
            return;
        }

        _now.Rates(_last.Time, MotionVector.Of(in _last), out MotionRates rates);
        if (_inNets.WasTaken)
        {
            Tangent.Times(in g.Place, in g.Velocity, in g.Spin, _inNets.Rate(in g, _last.Velocity, in rates), EventTimes);
            _inNets.Shift(EventTimes, 1.0);
        }
        else
        {
            Tangent.Times(in g.Place, in g.Velocity, in g.Spin, g.Rate, EventTimes);
            Tangent.Shift(_last.Velocity, in rates, EventTimes, 1.0);
        }

        _atEvent = true;
    }
}
