using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.Simulation;

namespace FootballPhysics.Aiming;

/// <summary>Simulates kicks without ground to the vertical planes through the target and a waypoint.</summary>
/// <remarks>
/// Without ground, the crossing changes smoothly with the kick, so Newton's method converges.
/// </remarks>
internal sealed class PlaneShooter : PieceObserver, IKickObserver
{
    /// <summary>A remaining time below this share of the longest step is too short for a step of its own.</summary>
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

    /// <param name="context">Counts the flights.</param>
    /// <param name="simulator">The scene without ground.</param>
    public PlaneShooter(AimContext context, Simulator simulator)
    {
        _context = context;
        _simulator = simulator;
        _flight = new KickFlight(simulator, this);
    }

    /// <summary>The crossing of the target's plane.</summary>
    public ref readonly PlaneCrossing Target => ref _target;

    /// <summary>The crossing of the waypoint's plane.</summary>
    public ref readonly PlaneCrossing Through => ref _through;

    /// <summary>The least height above the ground at the end of any segment before the target's plane, in m.</summary>
    public double Lowest { get; private set; }

    /// <summary>Prepares for flights to a target that may move.</summary>
    public void Aim(in TargetFrame frame, in Vector3d targetVelocity)
    {
        _target = new PlaneCrossing(in frame.Target, in targetVelocity, in frame.Forward);
        _floor = frame.Floor;
        _wantsThrough = false;
    }

    /// <summary>Adds a waypoint.</summary>
    public void AimThrough(in Vector3d point, in Vector3d normal)
    {
        _through = new PlaneCrossing(in point, Vector3d.Zero, in normal);
        _wantsThrough = true;
    }

    /// <summary>Simulates a kick until it has crossed its planes, or can no longer cross them.</summary>
    /// <param name="from">The position of the ball, in m.</param>
    /// <param name="orientation">The orientation of the ball.</param>
    /// <param name="velocity">The velocity, in m/s.</param>
    /// <param name="spin">The spin, in rad/s.</param>
    /// <param name="longestStep">The longest step, in s.</param>
    /// <param name="throughTime">The expected time at the waypoint's plane, in s, at which a step ends; 0 if unknown.</param>
    /// <param name="targetTime">The expected time at the target's plane, in s; 0 if unknown.</param>
    public void Fly(in Vector3d from, in Quaterniond orientation, in Vector3d velocity, in Vector3d spin, double longestStep, double throughTime, double targetTime)
    {
        _target.Reset();
        _through.Reset();
        Lowest = double.PositiveInfinity;

        // Let one step end at the expected time of the first plane, and a later one at the expected time of the second.
        BallState state = _simulator.LaunchAt(in from, in velocity, in spin, 0, in orientation);
        _longestStep = longestStep;
        _targetTime = targetTime;
        _end = _wantsThrough ? throughTime : targetTime;
        _step = StepTo(_end);
        _flight.Fly(ref state, AimContext.LongestFlight - (ContactTolerances.StepRounding * longestStep));
        _context.CountSimulation(_flight.Pieces);
    }

    public double StepFrom(in BallState state, out bool watches)
    {
        // Use equal steps, one of which ends at the expected crossing, where the interpolation is most accurate.
        watches = false;
        if (state.Time > _end - (ShortestStep * _longestStep))
        {
            _end = _targetTime - state.Time > ShortestStep * _longestStep ? _targetTime : double.PositiveInfinity;
            _step = StepTo(_end - state.Time);
        }

        return _step;
    }

    public bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        // If a step has one segment, interpolate the crossing in it. If it has several (at the jump in the drag law), repeat the step and inspect
        // each segment. If there is no crossing, only store the height.
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

    /// <summary>Returns the length of equal steps that end at a time.</summary>
    private double StepTo(double time) =>
        time > ShortestStep * _longestStep && time < double.PositiveInfinity ? time / Math.Ceiling((time / _longestStep) - 1e-6) : _longestStep;

    /// <summary>Stores the end of a segment that contains no crossing.</summary>
    /// <returns>True if the ball falls below the floor.</returns>
    private bool GivesUp(in Vector3d position, in Vector3d velocity)
    {
        Lowest = Math.Min(Lowest, _context.Clearance(in position));
        return position.Y < _floor && velocity.Y < 0;
    }
}

/// <summary>The crossing of a flight and a vertical plane through a point that may move.</summary>
/// <param name="point">The point at time 0, in m.</param>
/// <param name="pointVelocity">The velocity of the point, in m/s.</param>
/// <param name="normal">The normal of the plane, pointing forward.</param>
internal struct PlaneCrossing(in Vector3d point, in Vector3d pointVelocity, in Vector3d normal)
{
    /// <summary>A crossing may lie beyond the end of a step by up to this share of the step.</summary>
    private const double Reach = 0.05;

    /// <summary>The relative change at which Newton's method ends; smaller changes are rounding errors.</summary>
    private const double Closeness = 1e-9;

    private readonly Vector3d _point = point;
    private readonly Vector3d _pointVelocity = pointVelocity;
    private readonly Vector3d _normal = normal;

    /// <summary>True if the plane was crossed.</summary>
    public bool Crossed { get; private set; }

    /// <summary>The time of the crossing, in s after the kick.</summary>
    public double Time { get; private set; }

    /// <summary>The position relative to the point at the crossing, in m.</summary>
    public Vector3d Offset { get; private set; }

    /// <summary>The position at the crossing, in m.</summary>
    public readonly Vector3d Position => _point + (Time * _pointVelocity) + Offset;

    /// <summary>The velocity relative to the point at the crossing, in m/s.</summary>
    public Vector3d Velocity { get; private set; }

    /// <summary>Discards the last crossing.</summary>
    public void Reset() => Crossed = false;

    /// <summary>Stores a crossing.</summary>
    /// <param name="time">The time, in s after the kick.</param>
    /// <param name="position">The position, in m.</param>
    /// <param name="velocity">The velocity of the ball, in m/s.</param>
    public void Take(double time, in Vector3d position, in Vector3d velocity)
    {
        Crossed = true;
        Time = time;
        Offset = position - (time * _pointVelocity) - _point;
        Velocity = velocity - _pointVelocity;
    }

    /// <summary>Returns the distance of a position beyond the plane, in m.</summary>
    public readonly double Beyond(in Vector3d position, double time) => Vector3d.Dot(position - (time * _pointVelocity) - _point, in _normal);

    /// <summary>Returns the rate at which this distance grows, in m/s.</summary>
    public readonly double Outward(in Vector3d velocity) => Vector3d.Dot(velocity - _pointVelocity, in _normal);

    /// <summary>Returns the component of a vector along the normal.</summary>
    public readonly double Along(in Vector3d vector) => Vector3d.Dot(in vector, in _normal);

    /// <summary>Finds a crossing within a single-segment step, or just after its end, on the cubic between its ends.</summary>
    /// <returns>True if there is a crossing, and the ball approaches the plane throughout.</returns>
    public bool FindNear(in BallState start, in BallState end)
    {
        double length = end.Time - start.Time;
        double before = Beyond(start.Position, start.Time);
        double after = Beyond(end.Position, end.Time);

        // Times are in units of the step. The ball must start in front of the plane, and end behind it or shortly before it.
        double slope = length * Outward(end.Velocity);
        if (!(before < 0 && after > -Reach * slope && slope > 0))
        {
            return false;
        }

        var left = new WayLeft(new CubicHermite(-before, -length * Outward(start.Velocity), -after, -slope));
        double farthest = 1.0 + (2.0 * Reach);

        // Start from the tangent at the end of the step, because the cubic is most accurate there.
        double s = Roots.Newton(ref left, 0, farthest, 1.0 - (after / slope), Closeness);
        if (!(s > 0 && s < farthest && left.Curve.C1 < 0 && left.Curve.SlopeAt(s) < 0))
        {
            return false;
        }

        var path = PathSegment.Cubic(start.Position, start.Velocity, end.Position, end.Velocity, length);
        double t = s * length;
        Take(start.Time + t, path.PositionAt(t), path.VelocityAt(t));
        return true;
    }

    /// <summary>True if the ball is beyond the plane.</summary>
    public readonly bool IsBehind(in BallState state) => IsBehind(state.Position - (state.Time * _pointVelocity));

    /// <summary>Finds a crossing in a segment of the flight.</summary>
    /// <returns>True if there is one.</returns>
    public bool Find(in PathSegment piece)
    {
        // The path relative to the point.
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

    /// <summary>The remaining distance to the plane along a step.</summary>
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
