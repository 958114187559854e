namespace Football.Physics;

/// <summary>Where a flight crosses a vertical plane through a point that may move.</summary>
internal struct PlaneCrossing
{
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

    /// <summary>Velocity relative to the point then, m/s.</summary>
    public Vector3d Velocity { get; private set; }

    /// <summary>Forgets the last flight.</summary>
    public void Reset() => Crossed = false;

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
}
