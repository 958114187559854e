namespace Football.Physics;

/// <summary>Measures by what a kick misses a target that may move, and a point on the way, before its first impact: in steps that leave no doubt.</summary>
internal sealed class MissMeter : PieceObserver
{
    /// <summary>Step of the measurement, s: its own error is below 1e-6 m.</summary>
    private const double TimeStep = 0.005;

    private readonly Simulator _simulator;
    private readonly StepLog _log = new();
    private readonly bool _stillAir;
    private Vector3d _target;
    private Vector3d _targetVelocity;
    private Vector3d? _through;
    private double _best;
    private double _bestThrough;
    private double _time;
    private Vector3d _position;

    public MissMeter(Simulator simulator)
    {
        _simulator = simulator;
        _stillAir = simulator.Scene.Air.IsStill;
        _log.Observer = this;
    }

    public override bool WantsEndAcceleration => true;

    /// <summary>Flies a kick and measures.</summary>
    public MeasuredMiss Measure(AimRequest request, in Vector3d velocity, in Vector3d spin)
    {
        BallState state = _simulator.Launch(request.From, velocity, spin);
        _target = request.Target;
        _targetVelocity = request.TargetVelocity;
        _through = request.Through;
        _time = 0;
        _position = state.Position;
        _best = (_position - _target).LengthSquared;
        _bestThrough = _through is { } point ? (_position - point).LengthSquared : 0;
        _log.Clear();
        _simulator.Run(ref state, TimeStep, AimContext.LongestFlight, StopAt.Impact, _log, null);
        return new MeasuredMiss(Math.Sqrt(_best), _through is null ? null : Math.Sqrt(_bestThrough), _time, in _position);
    }

    public override bool Add(in PathPiece piece)
    {
        PathPiece relative = _targetVelocity == Vector3d.Zero ? piece : piece.SeenFrom(in _targetVelocity);
        double squared = relative.ClosestApproach(in _target, out double time);
        if (squared < _best)
        {
            _best = squared;
            _time = time;
            _position = piece.PositionAt(time);
        }

        if (_through is { } point)
        {
            _bestThrough = Math.Min(_bestThrough, piece.ClosestApproach(in point, out _));
        }

        return piece.Motion != MotionState.Airborne && _targetVelocity == Vector3d.Zero
            && IsPast(in piece, in _target, _best) && (_through is not { } way || IsPast(in piece, in way, _bestThrough));
    }

    /// <summary>Whether a ball on the ground comes no closer: it is too far below, or rolls away, and no wind brings it back.</summary>
    private bool IsPast(in PathPiece piece, in Vector3d point, double best)
    {
        Vector3d gap = piece.EndPosition - point;
        return gap.Y * gap.Y >= best || (_stillAir && piece.Motion == MotionState.Rolling && Vector3d.Dot(in gap, piece.EndVelocity) > 0);
    }
}
