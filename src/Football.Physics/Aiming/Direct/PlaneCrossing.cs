namespace Football.Physics;

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

    /// <summary>Whether it was crossed.</summary>
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
        double slope = length * Outward(end.Velocity);
        if (!(before < 0 && after > -Reach * slope && slope > 0))
        {
            return false;
        }

        var left = new WayLeft(new CubicHermite(-before, -length * Outward(start.Velocity), -after, -slope));
        double farthest = 1.0 + (2.0 * Reach);
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

    /// <summary>Whether the plane lies behind the ball.</summary>
    public readonly bool IsBehind(in BallState state) => IsBehind(state.Position - (state.Time * _pointVelocity));

    /// <summary>Looks for the crossing in a piece of the flight.</summary>
    /// <returns>True where it is.</returns>
    public bool Find(in PathPiece piece)
    {
        PathPiece relative = _pointVelocity == Vector3d.Zero ? piece : piece.SeenFrom(in _pointVelocity);
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

    /// <summary>What is left to the plane along a step.</summary>
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
