namespace Football.Physics;

/// <summary>
/// The derivatives by the launch in one scene. Between events J̇ = A(t) J along the path that the simulation took; at an event, whose time moves with the
/// launch by δt = −∇g·δy/ġ, J ← R' (J + ẏ₋ ⊗ δt) − ẏ₊ ⊗ δt (saltation), R being what the event does to the motion.
/// </summary>
internal sealed class SceneTangent<TAir> : TangentObserver
    where TAir : struct, IAir
{
    /// <summary>The Gauss points of 0 … 1.</summary>
    private const double FirstGauss = 0.21132486540518713;
    private const double SecondGauss = 1.0 - FirstGauss;

    /// <summary>Share of the slip by which a motion is changed near the end of a slide.</summary>
    private const double SlipShare = 1e-3;

    /// <summary>A piece of a slide that leaves less than this share of its slip is the last one: all others leave most of it.</summary>
    private const double LastPiece = 0.05;

    /// <summary>Parts for a slip that ends within one piece.</summary>
    private const double PartsOfWhole = 32;

    /// <summary>A part of a flight changes the flow by no more than this share of it, and need not change it by less than this, m/s.</summary>
    private const double FlowShare = 0.1;
    private const double LeastFlow = 1e-3;

    private readonly Surroundings<TAir> _around;
    private readonly ImpactMap<TAir> _impacts;
    private readonly EventSurface<TAir> _surface;
    private readonly FlightTangent<TAir> _flight;
    private readonly double _restEnergy;
    private readonly BallProperties _ball;
    private readonly double[] _map = new double[MotionVector.Size * MotionVector.Size];
    private readonly double[] _first = new double[MotionVector.Size * MotionVector.Size];
    private readonly double[] _second = new double[MotionVector.Size * MotionVector.Size];
    private LocalMotion<TAir> _now;
    private LocalMotion<TAir> _next;
    private BallState _last;
    private StepLog? _log;
    private int _event;

    /// <summary>Whether the tangent is that of one event's time for all launches, and not of one time.</summary>
    private bool _atEvent;

    /// <summary>Whether the last piece was the end of a slide, which leaves the spin of a roll.</summary>
    private bool _rolls;

    public SceneTangent(Scene scene, in TAir air)
    {
        _around = new Surroundings<TAir>(scene, in air);
        _impacts = new ImpactMap<TAir>(scene, _around);
        _surface = new EventSurface<TAir>(_around);
        _flight = new FlightTangent<TAir>(_around);
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
        Array.Clear(EventTimes, 0, EventTimes.Length);
        _flight.Abandon();
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

        Join(in before);
        if (_now.IsPlainFlight && _flight.Takes(in before, in after))
        {
            _flight.Begin(in before, _now.Branch);
            _flight.Add(in after);
            _last = after;
            return false;
        }

        Motion start = MotionVector.Of(in before);
        Motion end = MotionVector.Of(in after);
        if (before.Motion == MotionState.Sliding && _now.SpeedOnSurface(after.Time, in end) < LastPiece * _now.SpeedOnSurface(before.Time, in start))
        {
            EndSlide(before.Time, in start);
        }
        else
        {
            Propagate(before.Time, in start, in end, h);
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

    /// <summary>Ends a plain flight that is under way.</summary>
    private void Land()
    {
        if (_flight.IsOpen)
        {
            _flight.End(Tangent);
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
        }

        _atEvent = false;
        _rolls = false;
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
            if (_surface.Net(_next.Nets & ~_now.Nets, _next.NetSides, in motion, out EventGradient edge))
            {
                ToEvent(in edge);
            }
        }
        else if (_now.SpinSign != _next.SpinSign && _next.Motion != MotionState.Airborne)
        {
            Vector3d normal = _now.NormalAt(at.Position, at.Time);
            _now.Rates(at.Time, in motion, out MotionRates rates);
            ToEvent(new EventGradient(Vector3d.Zero, Vector3d.Zero, in normal, Vector3d.Dot(in normal, in rates.SpinAcceleration)));
        }

        if (_next.IsPinned && !_now.IsPinned)
        {
            // It stands: it only spins about the normal.
            Tangent.Clear(MotionVector.Velocity);
            Tangent.Keep(MotionVector.Spin, _next.NormalAt(before.Position, before.Time));
        }

        if (before.SpinRate == 0 && before.Motion == MotionState.Airborne)
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

        Tangent.Times(in g.Place, in g.Velocity, in g.Spin, g.Rate, EventTimes);
        _now.Rates(_last.Time, MotionVector.Of(in _last), out MotionRates rates);
        Tangent.Shift(_last.Velocity, in rates, EventTimes, 1.0);
        _atEvent = true;
    }

    /// <summary>The end of a slide in closed form, from the start of its last piece to the roll.</summary>
    private void EndSlide(double time, in Motion start)
    {
        Array.Clear(_map, 0, _map.Length);
        _map[_map.Length - 1] = 1;
        double width = SlipShare * _now.SpeedOnSurface(time, in start);
        Span<double> times = stackalloc double[MotionVector.Size];
        for (int i = 0; i < MotionVector.AirDistance; i++)
        {
            double by = i < MotionVector.Velocity ? MotionVector.Width(in start, i) : i < MotionVector.Spin ? width : width / _around.Radius;
            Motion high = _now.EndSlide(time, MotionVector.Changed(in start, i, by), out double later);
            Motion low = _now.EndSlide(time, MotionVector.Changed(in start, i, -by), out double sooner);
            MotionVector.Write(_map, i, in high, in low, 2.0 * by);
            times[i] = (later - sooner) / (2.0 * by);
            if (i < MotionVector.Spin)
            {
                // Place and velocity change by little.
                _map[(i * MotionVector.Size) + i] += 1;
            }
        }

        for (int c = 0; c < Tangent.Columns; c++)
        {
            double sum = 0;
            for (int i = 0; i < MotionVector.AirDistance; i++)
            {
                sum += times[i] * Tangent[i, c];
            }

            EventTimes[c] = sum;
        }

        Tangent.Map(_map);
        _atEvent = true;
        _rolls = true;
    }

    private void Propagate(double time, in Motion start, in Motion end, double h)
    {
        _now.Rates(time, in start, out MotionRates startRates);
        _now.Rates(time + h, in end, out MotionRates endRates);
        int parts = Parts(time, in start, in end, h);
        double part = h / parts;
        for (int i = 0; i < parts; i++)
        {
            double first = (i + FirstGauss) / parts;
            double second = (i + SecondGauss) / parts;
            MotionJacobian.At(_now, time + (first * h), Between(first, h, in start, in startRates, in end, in endRates), _first);
            MotionJacobian.At(_now, time + (second * h), Between(second, h, in start, in startRates, in end, in endRates), _second);
            Tangent.Integrate(part, _first, _second);
        }
    }

    /// <summary>How many parts to take a piece in: the direction of friction turns with 1/|s|, or 1/|v|, which must not change by much within a part.</summary>
    private int Parts(double time, in Motion start, in Motion end, double h)
    {
        if (_now.IsPinned)
        {
            return 1;
        }

        // Where the flow all but stops it turns fast.
        double slowest = Math.Min(_now.FlowAt(in start), _now.FlowAt(in end));
        double turning = Vector3d.Distance(start.Velocity, end.Velocity) / ((FlowShare * slowest) + LeastFlow);
        double before = _now.Motion == MotionState.Airborne ? 0 : _now.SpeedOnSurface(time, in start);
        double after = _now.Motion == MotionState.Airborne ? 0 : _now.SpeedOnSurface(time + h, in end);
        double most = Math.Max(before, after);
        double stopping = most > 0 ? PartsOfWhole * (Math.Abs(before - after) / most) : 0;
        return 1 + (int)Math.Min(PartsOfWhole, Math.Max(turning, stopping));
    }

    /// <summary>The motion between both ends of a piece: cubic Hermite interpolants.</summary>
    private static Motion Between(double s, double h, in Motion start, in MotionRates startRates, in Motion end, in MotionRates endRates)
    {
        double t = s * h;
        return new Motion(
            new CubicHermite3d(start.Position, start.Velocity, end.Position, end.Velocity, h).PositionAt(t),
            new CubicHermite3d(start.Velocity, startRates.Acceleration, end.Velocity, endRates.Acceleration, h).PositionAt(t),
            new CubicHermite3d(start.Spin, startRates.SpinAcceleration, end.Spin, endRates.SpinAcceleration, h).PositionAt(t),
            start.AirDistance + (s * (end.AirDistance - start.AirDistance)));
    }
}
