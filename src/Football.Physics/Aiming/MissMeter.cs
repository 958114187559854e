namespace Football.Physics;

/// <summary>Measures by what a kick misses a target that may move, and a point on the way, before its first impact: in steps that leave no doubt.</summary>
internal sealed class MissMeter : PieceObserver
{
    private readonly AimContext _context;
    private readonly Simulator _simulator;
    private readonly StepLog _log = new();
    private readonly StepLog _unwatched = new();
    private readonly bool _stillAir;
    private Vector3d _target;
    private Vector3d _targetVelocity;
    private Vector3d? _through;
    private double _best;
    private double _bestThrough;
    private double _time;
    private double _start;
    private Vector3d _position;
    private int _blocker;
    private AimRequest? _measured;
    private Vector3d _measuredVelocity;
    private Vector3d _measuredSpin;
    private MeasuredMiss _miss;

    /// <param name="context">What the searches share.</param>
    /// <param name="simulator">The scene.</param>
    public MissMeter(AimContext context, Simulator simulator)
    {
        _context = context;
        _simulator = simulator;
        _stillAir = simulator.Scene.Air.IsStill;
        _log.Observer = this;
    }

    public override bool WantsEndAcceleration => true;

    /// <summary>The name of what is in the way.</summary>
    public string? NameOf(int thing) => _simulator.NameOf(thing);

    /// <summary>Forgets the last measurement: what is in the scene may have moved.</summary>
    public void Forget() => _measured = null;

    /// <summary>Flies a kick and measures; what was measured last is not flown again.</summary>
    public MeasuredMiss Measure(AimRequest request, in Vector3d velocity, in Vector3d spin)
    {
        if (!ReferenceEquals(request, _measured) || velocity != _measuredVelocity || spin != _measuredSpin)
        {
            _miss = Fly(request, in velocity, in spin);
            (_measured, _measuredVelocity, _measuredSpin) = (request, velocity, spin);
        }

        return _miss;
    }

    private MeasuredMiss Fly(AimRequest request, in Vector3d velocity, in Vector3d spin)
    {
        BallState state = _simulator.LaunchAt(request.From, velocity, spin, request.KickTime);

        // On the clock of the scene the target has been on its way since time 0.
        _targetVelocity = request.TargetVelocity;
        _target = AimContext.Raised(_simulator, request.Target) - (request.KickTime * _targetVelocity);
        _through = request.Through is { } way ? AimContext.Raised(_simulator, way) : null;
        _start = request.KickTime;
        _time = _start;
        _blocker = MeasuredMiss.NoThing;
        _position = state.Position;
        _best = (_position - _target - (_start * _targetVelocity)).LengthSquared;
        _bestThrough = _through is { } point ? (_position - point).LengthSquared : 0;
        Fly(ref state, Step(in velocity, in spin));
        return new MeasuredMiss(Math.Sqrt(_best), _through is null ? null : Math.Sqrt(_bestThrough), _time - _start, in _position, _blocker);
    }

    /// <summary>Flies a kick until a time or its first impact, and measures how far from the target it is then.</summary>
    public MeasuredMiss MeasureAt(AimRequest request, in Vector3d velocity, in Vector3d spin, double time)
    {
        BallState state = _simulator.LaunchAt(request.From, velocity, spin, request.KickTime);
        _unwatched.Clear();
        _blocker = MeasuredMiss.NoThing;
        _simulator.Run(ref state, Step(in velocity, in spin), time, StopAt.Impact, _unwatched, null);
        LookForBlocker(_unwatched);
        double after = state.Time - request.KickTime;
        Vector3d target = AimContext.Raised(_simulator, request.Target) + (after * request.TargetVelocity);
        return new MeasuredMiss(Vector3d.Distance(state.Position, in target), null, after, state.Position, _blocker);
    }

    private double Step(in Vector3d velocity, in Vector3d spin) => MeasuringStep.Of(_simulator, _context.Upward, velocity.Length, spin.Length);

    /// <summary>Flies to the first impact, and looks closely only at steps in which the ball passes a point.</summary>
    private void Fly(ref BallState state, double timeStep)
    {
        bool ended = false;
        long pieces = 0;
        double last = _start + AimContext.LongestFlight - (1e-9 * timeStep);
        while (!ended && state.Time < last && pieces < AimContext.MostPieces)
        {
            BallState before = state;
            double step = Math.Min(timeStep, _start + AimContext.LongestFlight - state.Time);
            _unwatched.Clear();
            if (state.Motion == MotionState.Airborne)
            {
                ended = _simulator.StepToImpact(ref state, step, _unwatched);
                pieces += _unwatched.Steps;
                if (!ended && !Passes(in before, in state))
                {
                    LookForBlocker(_unwatched);
                    TakeEnd(in state);
                    continue;
                }
            }

            state = before;
            _log.Clear();
            ended = _simulator.StepToImpact(ref state, step, _log);
            pieces += _log.Steps;
            LookForBlocker(_log);
        }
    }

    /// <summary>Keeps the first thing but the ground that the ball has met.</summary>
    private void LookForBlocker(StepLog log)
    {
        for (int i = 0; i < log.Events.Count && _blocker == MeasuredMiss.NoThing; i++)
        {
            BallEvent happened = log.Events[i];
            _blocker = happened.Thing > 0 && happened.Kind is BallEventKind.Impact or BallEventKind.Net ? happened.Thing : MeasuredMiss.NoThing;
        }
    }

    /// <summary>Whether a ball that came closer to the target, or the point on the way, leaves it again.</summary>
    private bool Passes(in BallState before, in BallState after) =>
        Passes(in before, in after, in _target, in _targetVelocity) || (_through is { } point && Passes(in before, in after, in point, Vector3d.Zero));

    private static bool Passes(in BallState before, in BallState after, in Vector3d point, in Vector3d velocity) =>
        Vector3d.Dot(before.Position - point - (before.Time * velocity), before.Velocity - velocity) < 0
        && Vector3d.Dot(after.Position - point - (after.Time * velocity), after.Velocity - velocity) > 0;

    private void TakeEnd(in BallState state)
    {
        double squared = (state.Position - _target - (state.Time * _targetVelocity)).LengthSquared;
        if (squared < _best)
        {
            _best = squared;
            _time = state.Time;
            _position = state.Position;
        }

        if (_through is { } point)
        {
            _bestThrough = Math.Min(_bestThrough, (state.Position - point).LengthSquared);
        }
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

/// <summary>The measured closest approach of a kick before its first impact.</summary>
internal readonly struct MeasuredMiss
{
    /// <summary>Nothing is in the way.</summary>
    public const int NoThing = -1;

    public MeasuredMiss(double distance, double? throughDistance, double time, in Vector3d position, int blocker = NoThing)
    {
        Distance = distance;
        ThroughDistance = throughDistance;
        Time = time;
        Position = position;
        Blocker = blocker;
    }

    /// <summary>Distance from the target, m.</summary>
    public double Distance { get; }

    /// <summary>Distance from the point on the way, m; null without one.</summary>
    public double? ThroughDistance { get; }

    /// <summary>When the ball is closest to the target, s.</summary>
    public double Time { get; }

    /// <summary>Where it is then, m.</summary>
    public Vector3d Position { get; }

    /// <summary>The first thing but the ground that the ball meets on its way, as events number them; <see cref="NoThing"/> where it meets none.</summary>
    public int Blocker { get; }
}

/// <summary>The step of a flight that leaves no doubt by what it misses a target: its own error is far below a millimetre.</summary>
internal static class MeasuringStep
{
    /// <summary>Step of an ordinary flight, s; and of one that the air rules, that spins faster than it flies, or in a storm.</summary>
    private const double Ordinary = 0.02;
    private const double Fine = 0.005;

    /// <summary>Wind of a storm, m/s.</summary>
    private const double Storm = 25;

    /// <summary>The air rules where drag or lift are so much stronger than gravity.</summary>
    private const double Ruling = 3;

    /// <summary>The step for a kick, s.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy, m/s².</param>
    /// <param name="speed">Speed of the kick, m/s.</param>
    /// <param name="spinRate">Its spin, rad/s.</param>
    public static double Of(Simulator simulator, double upward, double speed, double spinRate) =>
        IsRuledByAir(simulator, upward, speed, spinRate) || simulator.Scene.Air.Wind.Length > Storm
            || simulator.Scene.Ball.Radius * spinRate > speed ? Fine : Ordinary;

    /// <summary>Whether, at a speed, drag or lift are so much stronger than gravity that ways bend into loops, or end in the air.</summary>
    public static bool IsRuledByAir(Simulator simulator, double upward, double speed, double spinRate)
    {
        double most = speed + simulator.Scene.Air.Wind.Length;
        simulator.AirFactors(most, spinRate, out double drag, out double lift);
        return most * Math.Max(drag, Math.Abs(lift)) > Ruling * Math.Abs(upward);
    }
}
