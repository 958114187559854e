namespace Football.Physics;

/// <summary>
/// Flies kicks without ground to the vertical plane through the target, and to that of a point on the way. Without ground the crossing moves
/// smoothly with the kick, so that Newton's method finds its root.
/// </summary>
internal sealed class PlaneShooter : PieceObserver
{
    /// <summary>Share of the longest step below which what is left to a time is not worth a step.</summary>
    private const double ShortestStep = 1e-3;

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
        BallState state = _simulator.LaunchAt(from, velocity, spin, 0);
        double last = AimContext.LongestFlight - (1e-9 * longestStep);
        bool ended = false;
        _log.Clear();
        long watched = 0;
        double end = _wantsThrough ? throughTime : targetTime;
        double step = StepTo(end, longestStep);
        while (!ended && state.Time < last && _log.Steps + watched < AimContext.MostPieces)
        {
            // A step that nobody watches is the fastest; one that crosses a plane and has more than one piece is taken again, watched.
            BallState before = state;
            long pieces = _log.Steps;
            ended = _simulator.StepToImpact(ref state, step, _log);
            bool whole = !ended && _log.Steps == pieces + 1;
            if (whole && _wantsThrough && !_through.Crossed)
            {
                _through.FindNear(in before, in state);
            }

            if (whole && _target.FindNear(in before, in state))
            {
                ended = !_wantsThrough || _through.Crossed;
            }
            else if (!Crosses(in state))
            {
                ended |= GivesUp(state.Position, state.Velocity);
            }
            else if (whole)
            {
                ended = Add(PathPiece.Cubic(in before, in state));
            }
            else
            {
                state = before;
                _watched.Clear();
                ended = _simulator.StepToImpact(ref state, step, _watched);
                watched += _watched.Steps;
            }

            if (state.Time > end - (ShortestStep * longestStep))
            {
                end = targetTime - state.Time > ShortestStep * longestStep ? targetTime : double.PositiveInfinity;
                step = StepTo(end - state.Time, longestStep);
            }
        }

        _context.CountSimulation(_log.Steps + watched);
    }

    /// <summary>The length of equal steps that end with a time.</summary>
    private static double StepTo(double time, double longest) =>
        time > ShortestStep * longest && time < double.PositiveInfinity ? time / Math.Ceiling((time / longest) - 1e-6) : longest;

    public override bool Add(in PathPiece piece)
    {
        if (_wantsThrough && !_through.Crossed)
        {
            _through.Find(in piece);
        }

        if (_target.Find(in piece))
        {
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
        Lowest = Math.Min(Lowest, position.Y);
        return position.Y < _floor && velocity.Y < 0;
    }
}
