namespace Football.Physics;

/// <summary>
/// Flies kicks without ground to the vertical plane through the target, and to that of a point on the way. Without ground the crossing moves
/// smoothly with the kick, so that Newton's method finds its root.
/// </summary>
internal sealed class PlaneShooter : PieceObserver
{
    private readonly AimContext _context;
    private readonly Simulator _simulator;
    private readonly StepLog _log = new();
    private readonly StepLog _watched = new();
    private PlaneCrossing _target;
    private PlaneCrossing _through;
    private bool _wantsThrough;
    private double _floor;

    /// <param name="context">Where flights are counted.</param>
    /// <param name="simulator">The scene without ground.</param>
    public PlaneShooter(AimContext context, Simulator simulator)
    {
        _context = context;
        _simulator = simulator;
        _watched.Observer = this;
    }

    /// <summary>The crossing of the target's plane.</summary>
    public ref readonly PlaneCrossing Target => ref _target;

    /// <summary>The crossing of the plane of the point on the way.</summary>
    public ref readonly PlaneCrossing Through => ref _through;

    /// <summary>The lowest end of a piece before the target's plane, m.</summary>
    public double Lowest { get; private set; }

    /// <summary>The end of the last piece.</summary>
    public Vector3d End { get; private set; }

    public override bool WantsEndAcceleration => false;

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
    public void Fly(in Vector3d from, in Vector3d velocity, in Vector3d spin, double timeStep)
    {
        _target.Reset();
        _through.Reset();
        Lowest = double.PositiveInfinity;
        BallState state = _simulator.Launch(from, velocity, spin);
        double last = AimContext.LongestFlight - (1e-9 * timeStep);
        bool ended = false;
        _log.Clear();
        long watched = 0;
        while (!ended && state.Time < last && _log.Steps + watched < AimContext.MostPieces)
        {
            // A step that nobody watches is the fastest; one that crosses a plane and has more than one piece is taken again, watched.
            BallState before = state;
            long pieces = _log.Steps;
            ended = _simulator.StepToImpact(ref state, timeStep, _log);
            if (!Crosses(in state))
            {
                ended |= GivesUp(state.Position, state.Velocity);
            }
            else if (!ended && _log.Steps == pieces + 1)
            {
                ended = Add(PathPiece.Cubic(in before, in state));
            }
            else
            {
                state = before;
                _watched.Clear();
                ended = _simulator.StepToImpact(ref state, timeStep, _watched);
                watched += _watched.Steps;
            }
        }

        _context.CountSimulation(_log.Steps + watched);
    }

    public override bool Add(in PathPiece piece)
    {
        if (_wantsThrough && !_through.Crossed)
        {
            _through.Find(in piece);
        }

        if (_target.Find(in piece))
        {
            End = piece.EndPosition;
            return !_wantsThrough || _through.Crossed;
        }

        return GivesUp(piece.EndPosition, piece.EndVelocity);
    }

    /// <summary>Whether a plane that is still to be crossed lies behind the ball.</summary>
    private bool Crosses(in BallState state) =>
        (_wantsThrough && !_through.Crossed && _through.IsBehind(in state)) || _target.IsBehind(in state);

    /// <summary>Takes the end of a piece that crosses nothing.</summary>
    /// <returns>True where the ball falls below the floor.</returns>
    private bool GivesUp(in Vector3d position, in Vector3d velocity)
    {
        End = position;
        Lowest = Math.Min(Lowest, position.Y);
        return position.Y < _floor && velocity.Y < 0;
    }
}
