namespace Football.Physics;

/// <summary>Watches a flight for its closest approach to a target that may move, and to a point on the way.</summary>
internal sealed class ClosestPass : PieceObserver
{
    private readonly bool _still;
    private Vector3d _target;
    private Vector3d _targetVelocity;
    private Vector3d? _through;
    private double _best;
    private double _bestThrough;

    /// <summary>Makes one.</summary>
    /// <param name="still">Whether the air is still: a ball that rolls away then does not come back.</param>
    public ClosestPass(bool still) => _still = still;

    /// <summary>Distance of closest approach to the target, m.</summary>
    public double Miss => Math.Sqrt(_best);

    /// <summary>The same for the point on the way; null without one.</summary>
    public double? ThroughMiss => _through is null ? null : Math.Sqrt(_bestThrough);

    /// <summary>When the ball is closest to the target, s.</summary>
    public double Time { get; private set; }

    /// <summary>Where it is then, m.</summary>
    public Vector3d Position { get; private set; }

    public override bool WantsEndAcceleration => true;

    /// <summary>Starts from where the ball is.</summary>
    public void Begin(in Vector3d from, in Vector3d target, in Vector3d targetVelocity, Vector3d? through)
    {
        _target = target;
        _targetVelocity = targetVelocity;
        _through = through;
        _best = (from - target).LengthSquared;
        _bestThrough = through is { } point ? (from - point).LengthSquared : 0;
        Time = 0;
        Position = from;
    }

    public override bool Add(in PathPiece piece)
    {
        PathPiece relative = _targetVelocity == Vector3d.Zero ? piece : piece.SeenFrom(in _targetVelocity);
        double squared = relative.ClosestApproach(in _target, out double time);
        if (squared < _best)
        {
            _best = squared;
            Time = time;
            Position = piece.PositionAt(time);
        }

        if (_through is { } point)
        {
            _bestThrough = Math.Min(_bestThrough, piece.ClosestApproach(in point, out _));
        }

        return piece.Motion != MotionState.Airborne && _targetVelocity == Vector3d.Zero
            && IsPast(in piece, in _target, _best) && (_through is not { } way || IsPast(in piece, in way, _bestThrough));
    }

    /// <summary>Whether a ball on the ground comes no closer: it is too far below, or rolls away.</summary>
    private bool IsPast(in PathPiece piece, in Vector3d point, double best)
    {
        Vector3d gap = piece.EndPosition - point;
        return gap.Y * gap.Y >= best || (_still && piece.Motion == MotionState.Rolling && Vector3d.Dot(in gap, piece.EndVelocity) > 0);
    }
}
