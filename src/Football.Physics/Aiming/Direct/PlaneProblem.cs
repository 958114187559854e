namespace FootballPhysics.Aiming;

/// <summary>
/// The boundary-value problem of a kick of given speed: which elevation and azimuth make it cross the vertical plane through the target in the target itself, and, where it is to
/// pass a point on the way, which spins with them make it cross the plane of that in that.
/// </summary>
internal sealed class PlaneProblem
{
    /// <summary>Most unknowns, and most equations.</summary>
    public const int Most = 4;

    public const int Elevation = 0;
    public const int Azimuth = 1;
    public const int Top = 2;
    public const int Side = 3;

    public const int ThroughLeft = 0;
    public const int ThroughUp = 1;
    public const int TargetLeft = 2;
    public const int TargetUp = 3;

    /// <summary>A miss distance at the point on the way well below any tolerance worth having, m.</summary>
    public const double FineThrough = 1e-2;

    private readonly AimContext _context;
    private TargetFrame _frame;
    private Vector3d _targetVelocity;
    private double _step;
    private double _firstStep;
    private FittedFlight _fitted;
    private double _drag;
    private PlaneCrossing _atTarget;
    private PlaneCrossing _atThrough;
    private double _guessedTime;
    private double _guessedThroughTime;
    private double _throughTime;

    public PlaneProblem(AimContext context) => _context = context;

    public AimRequest Request { get; private set; } = new();

    public ref readonly TargetFrame Frame => ref _frame;

    public ElevationBounds Bounds { get; private set; }

    /// <summary>Speed of the kicks, m/s.</summary>
    public double Speed { get; private set; }

    /// <summary>The spins of the kicks, where only their angles are sought.</summary>
    public Kick Spins { get; private set; }

    /// <summary>True when they are to pass a point on the way.</summary>
    public bool HasThrough { get; private set; }

    /// <summary>The point on the way, m.</summary>
    public Vector3d Through { get; private set; }

    /// <summary>Its horizontal distance towards the target, m.</summary>
    public double ThroughDistance { get; private set; }

    /// <summary>Miss distance at the target within which the search ends, m.</summary>
    public double Tolerance { get; private set; }

    /// <summary>Tolerance at the point on the way, m.</summary>
    public double ThroughTolerance { get; private set; }

    /// <summary>True when kicks are flown in short steps, because longer ones were wrong.</summary>
    public bool IsFine => _context.Steps.AreShort;

    /// <summary>When the last kick was at the target, s.</summary>
    public double Time { get; private set; }

    /// <summary>Sets the problem for a target.</summary>
    public void Set(AimRequest request, double speed, double top, double side)
    {
        Request = request;
        Speed = speed;
        Spins = new Kick { Top = top, Side = side };
        HasThrough = false;
        _targetVelocity = request.TargetVelocity;
        _frame = _context.Frame(request);
        Bounds = ElevationBounds.Of(request);
        Tolerance = AimContext.Sharp(request.Tolerance);
        _step = _context.Steps.HitWithin(Tolerance);
        _firstStep = _context.Steps.RehearsedWithin(Tolerance);
        _context.Planes.Aim(in _frame, in _targetVelocity);
    }

    /// <summary>Sets the problem for the point on the way and the target of a request.</summary>
    /// <returns>False where the point does not lie on the way to the target.</returns>
    public bool SetThrough(AimRequest request)
    {
        Set(request, request.Speed, 0, 0);
        HasThrough = true;
        _targetVelocity = Vector3d.Zero;
        Through = AimContext.Raised(_context.Game, request.Waypoint.GetValueOrDefault());
        ThroughDistance = Vector3d.Dot(Through - _frame.From, in _frame.Forward);
        ThroughTolerance = AimContext.Sharp(request.WaypointTolerance, FineThrough);
        _context.Planes.Aim(in _frame, in _targetVelocity);
        _context.Planes.AimThrough(Through, in _frame.Forward);
        return _frame.Distance > 1e-6 && ThroughDistance > 1e-3 * _frame.Distance && ThroughDistance < 0.999 * _frame.Distance;
    }

    /// <summary>The kick that unknowns stand for.</summary>
    public Kick KickOf(double[] x) => new()
    {
        Elevation = x[Elevation],
        Azimuth = x[Azimuth],
        Top = HasThrough ? x[Top] : Spins.Top,
        Side = HasThrough ? x[Side] : Spins.Side,
    };

    /// <summary>Miss distance at the target, m.</summary>
    public static double MissOf(double[] r) => Math.Sqrt((r[TargetLeft] * r[TargetLeft]) + (r[TargetUp] * r[TargetUp]));

    /// <summary>Miss distance at the point on the way, m.</summary>
    public static double ThroughMissOf(double[] r) => Math.Sqrt((r[ThroughLeft] * r[ThroughLeft]) + (r[ThroughUp] * r[ThroughUp]));

    /// <summary>A first kick, from the flight in closed form.</summary>
    /// <returns>False where that does not reach the target.</returns>
    public bool Guess(double[] x)
    {
        _fitted = default;
        if (HasThrough)
        {
            _drag = TwoPointGuess.Make(_context, this, x, out _guessedThroughTime, out _guessedTime);
            ForgetRehearsals();
            return true;
        }

        // The mean drag over the way gives a first time; the closed form then turns direction and time together.
        FlatFire model = _context.Model(Speed, Spins.SpinRate, _frame.Distance);
        Vector3d toTarget = _frame.Target - _frame.From;
        Vector3d direction = toTarget / toTarget.Length;
        Vector3d wind = _context.Scene.Air.Wind;
        Kick spins = Spins;
        double time = _frame.Distance / Speed * (1.0 + (0.5 * model.Drag * _frame.Distance));
        bool reached = model.Solve(in toTarget, wind - _targetVelocity, in wind, Speed, in spins, ref direction, ref time);
        Kick kick = _frame.Turned(Spins, in direction, Bounds);
        x[Elevation] = kick.Elevation;
        x[Azimuth] = kick.Azimuth;
        _drag = model.Drag;
        _guessedTime = time;
        ForgetRehearsals();
        return reached;
    }

    /// <summary>Goes back to the times of the guess.</summary>
    public void ForgetRehearsals() => (_throughTime, Time) = (_guessedThroughTime, _guessedTime);

    /// <summary>Flies a kick to its planes as it would fly in air that is fitted to about its own spin.</summary>
    /// <returns>False where it does not reach them.</returns>
    public bool Rehearse(double[] x, double[] r)
    {
        Kick kick = KickOf(x);
        kick.Vectors(Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        double spinRate = kick.SpinRate;
        if (!_fitted.Fits(spinRate))
        {
            _fitted.Fit(_context, (velocity - _context.Scene.Air.Wind).Length, spinRate, _drag, Time);
        }

        _fitted.Begin(in _frame.From, in velocity, in spin);
        _atThrough = new PlaneCrossing(Through, Vector3d.Zero, in _frame.Forward);
        _atTarget = new PlaneCrossing(in _frame.Target, in _targetVelocity, in _frame.Forward);
        return (!HasThrough || _fitted.Fly(_throughTime, ref _atThrough)) && _fitted.Fly(Time, ref _atTarget) && TakeCrossings(r);
    }

    /// <summary>Flies a kick to its planes.</summary>
    /// <param name="x">The unknowns.</param>
    /// <param name="r">The residuals.</param>
    /// <param name="isRehearsed">Whether it is to show no more than how far a rehearsed kick is off.</param>
    /// <returns>False where it does not reach them.</returns>
    public bool Fly(double[] x, double[] r, bool isRehearsed)
    {
        KickOf(x).Vectors(Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        PlaneShooter planes = _context.Planes;
        planes.Fly(in _frame.From, in velocity, in spin, isRehearsed ? _firstStep : _step, HasThrough ? _throughTime : 0, Time);
        _context.CountIteration();
        _atThrough = planes.Through;
        _atTarget = planes.Target;
        return (!HasThrough || _atThrough.Crossed) && _atTarget.Crossed && TakeCrossings(r);
    }

    /// <summary>How the last crossing of the plane of the point on the way moves with the angles of its kick.</summary>
    public CrossingJacobian JacobianAtThrough(double[] x) => Jacobian(KickOf(x), in _atThrough);

    /// <summary>Jacobian of the crossing of the target's plane.</summary>
    public CrossingJacobian JacobianAtTarget(double[] x) => Jacobian(KickOf(x), in _atTarget);

    /// <summary>True when the last flight to the target leaves the ground and stays above it, so that no impact comes first.</summary>
    public bool StaysClear(double[] x, double[] r)
    {
        // One that stays on the ground from its start rolls: that is another problem.
        Elementary.SinCos(x[Elevation], out double sine, out _);
        double lowest = Math.Min(_context.Planes.Lowest, _frame.Target.Y + (Time * _targetVelocity.Y) + r[TargetUp]);
        return !_context.StaysDown(in _frame.From, Speed * sine) && lowest >= _context.Game.ContactHeight - 1e-9;
    }

    private CrossingJacobian Jacobian(in Kick kick, in PlaneCrossing crossing) =>
        CrossingJacobian.Of(in kick, in crossing, in _frame, _context.Scene.Air.Wind, _context.Upward);

    /// <summary>Takes the residuals, and when to look for the next crossings.</summary>
    private bool TakeCrossings(double[] r)
    {
        Time = _atTarget.Time;
        r[TargetLeft] = Vector3d.Dot(_atTarget.Offset, in _frame.Left);
        r[TargetUp] = _atTarget.Offset.Y;
        if (HasThrough)
        {
            _throughTime = _atThrough.Time;
            r[ThroughLeft] = Vector3d.Dot(_atThrough.Offset, in _frame.Left);
            r[ThroughUp] = _atThrough.Offset.Y;
        }

        return true;
    }
}
