namespace Football.Physics;

/// <summary>Watches one flight of a kick for the crossings of one or two planes.</summary>
internal sealed class KickFlight : PieceObserver
{
    private Vector3d _point;
    private Vector3d _normal;
    private Vector3d _pointVelocity;
    private Vector3d _through;
    private Vector3d _throughNormal;
    private bool _wantsThrough;
    private double _floor;

    /// <summary>Whether the target's plane was crossed.</summary>
    public bool Crossed { get; private set; }

    /// <summary>When, s after the kick.</summary>
    public double Time { get; private set; }

    /// <summary>Position relative to the target then, m.</summary>
    public Vector3d Offset { get; private set; }

    /// <summary>Velocity relative to the target then, m/s.</summary>
    public Vector3d Velocity { get; private set; }

    /// <summary>Whether the plane of the point on the way was crossed.</summary>
    public bool CrossedThrough { get; private set; }

    /// <summary>When, s after the kick.</summary>
    public double ThroughTime { get; private set; }

    /// <summary>Position relative to the point then, m.</summary>
    public Vector3d ThroughOffset { get; private set; }

    /// <summary>Velocity then, m/s.</summary>
    public Vector3d ThroughVelocity { get; private set; }

    /// <summary>The lowest end of a piece before the crossing, m.</summary>
    public double Lowest { get; private set; }

    /// <summary>The end of the last piece.</summary>
    public Vector3d End { get; private set; }

    public override bool WantsEndAcceleration => false;

    /// <summary>Prepares for a flight to a target that may move.</summary>
    /// <param name="point">The target.</param>
    /// <param name="velocity">Its velocity.</param>
    /// <param name="normal">Normal of its plane, forward.</param>
    /// <param name="floor">Height at which a falling ball is given up.</param>
    public void Aim(in Vector3d point, in Vector3d velocity, in Vector3d normal, double floor)
    {
        _point = point;
        _pointVelocity = velocity;
        _normal = normal;
        _floor = floor;
        _wantsThrough = false;
    }

    /// <summary>Adds a point on the way.</summary>
    public void AimThrough(in Vector3d point, in Vector3d normal)
    {
        _through = point;
        _throughNormal = normal;
        _wantsThrough = true;
    }

    /// <summary>Forgets the last flight.</summary>
    public void Reset()
    {
        Crossed = false;
        CrossedThrough = false;
        Lowest = double.PositiveInfinity;
    }

    /// <summary>Whether a plane that is still to be crossed lies behind the ball.</summary>
    public bool Crosses(in BallState state) =>
        (_wantsThrough && !CrossedThrough && Passes(state.Position, in _through, in _throughNormal))
        || Passes(state.Position - (state.Time * _pointVelocity), in _point, in _normal);

    /// <summary>Takes the end of a step that crosses nothing.</summary>
    /// <returns>True when the ball is given up.</returns>
    public bool Pass(in BallState state)
    {
        End = state.Position;
        Lowest = Math.Min(Lowest, state.Position.Y);
        return state.Position.Y < _floor && state.Velocity.Y < 0;
    }

    public override bool Add(in PathPiece piece)
    {
        End = piece.EndPosition;
        if (_wantsThrough && !CrossedThrough && Passes(piece.EndPosition, in _through, in _throughNormal)
            && piece.Crosses(in _through, in _throughNormal, out double time))
        {
            CrossedThrough = true;
            ThroughTime = time;
            ThroughOffset = piece.PositionAt(time) - _through;
            ThroughVelocity = piece.VelocityAt(time);
        }

        PathPiece relative = _pointVelocity == Vector3d.Zero ? piece : piece.SeenFrom(in _pointVelocity);
        if (Passes(relative.EndPosition, in _point, in _normal) && relative.Crosses(in _point, in _normal, out time))
        {
            Crossed = true;
            Time = time;
            Offset = relative.PositionAt(time) - _point;
            Velocity = relative.VelocityAt(time);
            return !_wantsThrough || CrossedThrough;
        }

        Lowest = Math.Min(Lowest, piece.EndPosition.Y);
        return piece.EndPosition.Y < _floor && piece.EndVelocity.Y < 0;
    }

    private static bool Passes(in Vector3d position, in Vector3d point, in Vector3d normal) =>
        Vector3d.Dot(position - point, in normal) >= 0;
}
