namespace FootballPhysics.Aiming;

/// <summary>
/// Flies kicks without ground to the vertical plane through the target, and to that of a point on the way. Without ground the crossing moves
/// smoothly with the kick, so that Newton's method finds its root.
/// </summary>
internal sealed class PlaneShooter : KickObserver
{
    /// <summary>Share of the longest step below which what is left to a time is not worth a step.</summary>
    private const double ShortestStep = 1e-3;

    private readonly AimContext _context;
    private readonly Simulator _simulator;
    private readonly KickFlight _flight;
    private PlaneCrossing _target;
    private PlaneCrossing _through;
    private bool _wantsThrough;
    private double _floor;
    private double _longestStep;
    private double _step;
    private double _end;
    private double _targetTime;

    /// <param name="context">Where flights are counted.</param>
    /// <param name="simulator">The scene without ground.</param>
    public PlaneShooter(AimContext context, Simulator simulator)
    {
        _context = context;
        _simulator = simulator;
        _flight = new KickFlight(simulator, this);
    }

    /// <summary>The crossing of the target's plane.</summary>
    public ref readonly PlaneCrossing Target => ref _target;

    /// <summary>The crossing of the plane of the point on the way.</summary>
    public ref readonly PlaneCrossing Through => ref _through;

    /// <summary>The lowest end of a piece before the target's plane, m.</summary>
    public double Lowest { get; private set; }

    /// <summary>Prepares for flights to a target that may move.</summary>
    public void Aim(in TargetFrame frame, in Vector3d targetVelocity)
    {
        _target = new PlaneCrossing(in frame.Target, in targetVelocity, in frame.Forward);
        _floor = frame.Floor;
        _wantsThrough = false;
    }

    /// <summary>Adds a point on the way.</summary>
    public void AimThrough(in Vector3d point, in Vector3d normal)
    {
        _through = new PlaneCrossing(in point, Vector3d.Zero, in normal);
        _wantsThrough = true;
    }

    /// <summary>Flies a kick until its planes are crossed, or it is given up.</summary>
    /// <param name="from">Where the ball is, m.</param>
    /// <param name="velocity">Its velocity, m/s.</param>
    /// <param name="spin">Its spin, rad/s.</param>
    /// <param name="longestStep">The longest step, s.</param>
    /// <param name="throughTime">When the plane of the point on the way is about to be crossed, s: a step ends there. 0 where that is not known.</param>
    /// <param name="targetTime">The same for the plane of the target.</param>
    public void Fly(in Vector3d from, in Vector3d velocity, in Vector3d spin, double longestStep, double throughTime, double targetTime)
    {
        _target.Reset();
        _through.Reset();
        Lowest = double.PositiveInfinity;

        // Steps end at the time at which the first plane is expected, then at that of the second.
        BallState state = _simulator.LaunchAt(from, velocity, spin, 0);
        _longestStep = longestStep;
        _targetTime = targetTime;
        _end = _wantsThrough ? throughTime : targetTime;
        _step = StepTo(_end);
        _flight.Fly(ref state, AimContext.LongestFlight - (1e-9 * longestStep));
        _context.CountSimulation(_flight.Pieces);
    }

    public override double StepFrom(in BallState state, out bool watches)
    {
        // Equal steps, so long that one ends where a plane is about to be crossed: it is then read off where the step is most exact.
        watches = false;
        if (state.Time > _end - (ShortestStep * _longestStep))
        {
            _end = _targetTime - state.Time > ShortestStep * _longestStep ? _targetTime : double.PositiveInfinity;
            _step = StepTo(_end - state.Time);
        }

        return _step;
    }

    public override bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        // A whole step that crosses is read off the cubic between its ends; one that had pieces (the drag law's jump) is taken again with each piece looked at; one that
        // crosses nothing only tells how low it came.
        bool whole = !ended && log.Steps == 1;
        if (whole && _wantsThrough && !_through.Crossed)
        {
            _through.FindNear(in before, in after);
        }

        if (whole && _target.FindNear(in before, in after))
        {
            ended = !_wantsThrough || _through.Crossed;
            return false;
        }

        bool crosses = (_wantsThrough && !_through.Crossed && _through.IsBehind(in after)) || _target.IsBehind(in after);
        if (crosses && !whole)
        {
            return true;
        }

        ended |= crosses ? Add(PathSegment.Cubic(in before, in after)) : GivesUp(after.Position, after.Velocity);
        return false;
    }

    public override bool Add(in PathSegment piece)
    {
        if (_wantsThrough && !_through.Crossed)
        {
            _through.Find(in piece);
        }

        return _target.Find(in piece) ? !_wantsThrough || _through.Crossed : GivesUp(piece.EndPosition, piece.EndVelocity);
    }

    /// <summary>The length of equal steps that end with a time.</summary>
    private double StepTo(double time) =>
        time > ShortestStep * _longestStep && time < double.PositiveInfinity ? time / Math.Ceiling((time / _longestStep) - 1e-6) : _longestStep;

    /// <summary>Takes the end of a piece that crosses nothing.</summary>
    /// <returns>True where the ball falls below the floor.</returns>
    private bool GivesUp(in Vector3d position, in Vector3d velocity)
    {
        Lowest = Math.Min(Lowest, position.Y);
        return position.Y < _floor && velocity.Y < 0;
    }
}

/// <summary>Where a flight crosses a vertical plane through a point that may move.</summary>
internal struct PlaneCrossing
{
    /// <summary>Share of a step after its end within which a crossing is still read off it.</summary>
    private const double Reach = 0.05;

    /// <summary>Newton's method for the crossing ends with a change of this share of the step: then what is left is rounding.</summary>
    private const double Closeness = 1e-9;

    private readonly Vector3d _point;
    private readonly Vector3d _pointVelocity;
    private readonly Vector3d _normal;

    /// <param name="point">The point at time 0, m.</param>
    /// <param name="pointVelocity">Its velocity, m/s.</param>
    /// <param name="normal">Normal of the plane, forward.</param>
    public PlaneCrossing(in Vector3d point, in Vector3d pointVelocity, in Vector3d normal)
        : this()
    {
        _point = point;
        _pointVelocity = pointVelocity;
        _normal = normal;
    }

    /// <summary>True when it was crossed.</summary>
    public bool Crossed { get; private set; }

    /// <summary>When, s after the kick.</summary>
    public double Time { get; private set; }

    /// <summary>Position relative to the point then, m.</summary>
    public Vector3d Offset { get; private set; }

    /// <summary>Position then, m.</summary>
    public readonly Vector3d Position => _point + (Time * _pointVelocity) + Offset;

    /// <summary>Velocity relative to the point then, m/s.</summary>
    public Vector3d Velocity { get; private set; }

    /// <summary>Forgets the last flight.</summary>
    public void Reset() => Crossed = false;

    /// <summary>Takes a crossing.</summary>
    /// <param name="time">When, s after the kick.</param>
    /// <param name="position">Where, m.</param>
    /// <param name="velocity">The ball's velocity, m/s.</param>
    public void Take(double time, in Vector3d position, in Vector3d velocity)
    {
        Crossed = true;
        Time = time;
        Offset = position - (time * _pointVelocity) - _point;
        Velocity = velocity - _pointVelocity;
    }

    /// <summary>How far a ball has come beyond the plane, m.</summary>
    public readonly double Beyond(in Vector3d position, double time) => Vector3d.Dot(position - (time * _pointVelocity) - _point, in _normal);

    /// <summary>How fast it gets away from there, m/s.</summary>
    public readonly double Outward(in Vector3d velocity) => Vector3d.Dot(velocity - _pointVelocity, in _normal);

    /// <summary>A vector's part along the normal.</summary>
    public readonly double Along(in Vector3d vector) => Vector3d.Dot(in vector, in _normal);

    /// <summary>Looks for the crossing in a step of one piece, or just after its end, where the cubic between its ends goes on.</summary>
    /// <returns>True where it is there, and the ball comes nearer to the plane all along.</returns>
    public bool FindNear(in BallState start, in BallState end)
    {
        double length = end.Time - start.Time;
        double before = Beyond(start.Position, start.Time);
        double after = Beyond(end.Position, end.Time);

        // In units of the step. The ball must begin before the plane, and end beyond it or shortly before.
        double slope = length * Outward(end.Velocity);
        if (!(before < 0 && after > -Reach * slope && slope > 0))
        {
            return false;
        }

        var left = new WayLeft(new CubicHermite(-before, -length * Outward(start.Velocity), -after, -slope));
        double farthest = 1.0 + (2.0 * Reach);

        // From the tangent at the end of the step, where it is most exact.
        double s = Roots.Newton(ref left, 0, farthest, 1.0 - (after / slope), Closeness);
        if (!(s > 0 && s < farthest && left.Curve.C1 < 0 && left.Curve.SlopeAt(s) < 0))
        {
            return false;
        }

        var path = new CubicHermite3d(start.Position, start.Velocity, end.Position, end.Velocity, length);
        double t = s * length;
        Take(start.Time + t, path.PositionAt(t), path.VelocityAt(t));
        return true;
    }

    /// <summary>True when the plane lies behind the ball.</summary>
    public readonly bool IsBehind(in BallState state) => IsBehind(state.Position - (state.Time * _pointVelocity));

    /// <summary>Looks for the crossing in a piece of the flight.</summary>
    /// <returns>True where it is.</returns>
    public bool Find(in PathSegment piece)
    {
        // As the point sees it.
        PathSegment relative = _pointVelocity == Vector3d.Zero ? piece : piece.SeenFrom(in _pointVelocity);
        if (!IsBehind(relative.EndPosition) || !relative.Crosses(in _point, in _normal, out double time))
        {
            return false;
        }

        Crossed = true;
        Time = time;
        Offset = relative.PositionAt(time) - _point;
        Velocity = relative.VelocityAt(time);
        return true;
    }

    private readonly bool IsBehind(in Vector3d position) => Vector3d.Dot(position - _point, in _normal) >= 0;

    /// <summary>Distance left to the plane along a step.</summary>
    private readonly struct WayLeft(CubicHermite curve) : IDifferentiableFunction
    {
        public readonly CubicHermite Curve = curve;

        public bool Evaluate(double x, out double value, out double slope)
        {
            value = Curve.At(x);
            slope = Curve.SlopeAt(x);
            return false;
        }
    }
}
