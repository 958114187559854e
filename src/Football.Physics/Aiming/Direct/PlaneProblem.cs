namespace FootballPhysics.Aiming;

/// <summary>The boundary-value problem of a kick at a given speed: elevation and azimuth for a target, plus spins for a waypoint.</summary>
/// <remarks>
/// The kick must cross the target's vertical plane at the target itself, and the waypoint's plane at the waypoint.
/// </remarks>
internal sealed class PlaneProblem(AimContext context)
{
    /// <summary>The maximum number of unknowns and of equations.</summary>
    public const int Most = 4;

    public const int Elevation = 0;
    public const int Azimuth = 1;
    public const int Top = 2;
    public const int Side = 3;

    public const int ThroughLeft = 0;
    public const int ThroughUp = 1;
    public const int TargetLeft = 2;
    public const int TargetUp = 3;

    /// <summary>The miss that a search aims for at the waypoint, in m; well below any useful tolerance.</summary>
    public const double FineThrough = 1e-2;

    private readonly AimContext _context = context;
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

    public AimRequest Request { get; private set; } = new();

    public ref readonly TargetFrame Frame => ref _frame;

    public ElevationBounds Bounds { get; private set; }

    /// <summary>The speed of the kicks, in m/s.</summary>
    public double Speed { get; private set; }

    /// <summary>The spins of the kicks if only the angles are unknown.</summary>
    public Kick Spins { get; private set; }

    /// <summary>True if the kicks must pass a waypoint.</summary>
    public bool HasThrough { get; private set; }

    /// <summary>The waypoint, in m.</summary>
    public Vector3d Through { get; private set; }

    /// <summary>The horizontal distance of the waypoint towards the target, in m.</summary>
    public double ThroughDistance { get; private set; }

    /// <summary>The miss at the target at which the search ends, in m.</summary>
    public double Tolerance { get; private set; }

    /// <summary>The miss of a flight over the ground that counts as a hit, in m.</summary>
    public double HitMiss { get; private set; }

    /// <summary>The tolerance at the waypoint, in m.</summary>
    public double ThroughTolerance { get; private set; }

    /// <summary>True if kicks fly in short steps because longer ones were inaccurate.</summary>
    public bool IsFine => _context.Steps.AreShort;

    /// <summary>The time at which the last kick reached the target, in s.</summary>
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
        HitMiss = AimContext.Sharp(request.Tolerance);
        Tolerance = _context.Sharp(in _frame, request.Tolerance);
        _step = _context.Steps.HitWithin(Tolerance);
        _firstStep = _context.Steps.RehearsedWithin(Tolerance);
        _context.Planes.Aim(in _frame, in _targetVelocity);
    }

    /// <summary>Sets the problem for the waypoint and target of a request.</summary>
    /// <returns>False if the waypoint is not between ball and target.</returns>
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

    /// <summary>Returns the kick for the unknowns.</summary>
    public Kick KickOf(double[] x) => new()
    {
        Elevation = x[Elevation],
        Azimuth = x[Azimuth],
        Top = HasThrough ? x[Top] : Spins.Top,
        Side = HasThrough ? x[Side] : Spins.Side,
    };

    /// <summary>Returns the miss at the target, in m.</summary>
    public static double MissOf(double[] r) => Math.Sqrt((r[TargetLeft] * r[TargetLeft]) + (r[TargetUp] * r[TargetUp]));

    /// <summary>Returns the miss at the waypoint, in m.</summary>
    public static double ThroughMissOf(double[] r) => Math.Sqrt((r[ThroughLeft] * r[ThroughLeft]) + (r[ThroughUp] * r[ThroughUp]));

    /// <summary>Makes a first guess from the closed-form flight.</summary>
    /// <returns>False if the closed form does not reach the target.</returns>
    public bool Guess(double[] x)
    {
        _fitted = default;
        if (HasThrough)
        {
            _drag = TwoPointGuess.Make(_context, this, x, out _guessedThroughTime, out _guessedTime);
            ForgetRehearsals();
            return true;
        }

        // Estimate the time from the mean drag; the closed form then solves for direction and time together.
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

    /// <summary>Resets the times to those of the guess.</summary>
    public void ForgetRehearsals() => (_throughTime, Time) = (_guessedThroughTime, _guessedTime);

    /// <summary>Simulates a kick to its planes in air fitted to about its own spin.</summary>
    /// <returns>False if it does not reach them.</returns>
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

    /// <summary>Simulates a kick to its planes.</summary>
    /// <param name="x">The unknowns.</param>
    /// <param name="r">The residuals.</param>
    /// <param name="isRehearsed">True if the flight only measures the error of a rehearsed kick.</param>
    /// <returns>False if it does not reach them.</returns>
    public bool Fly(double[] x, double[] r, bool isRehearsed)
    {
        KickOf(x).Vectors(Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        PlaneShooter planes = _context.Planes;
        planes.Fly(in _frame.From, in _frame.Orientation, in velocity, in spin, isRehearsed ? _firstStep : _step, HasThrough ? _throughTime : 0, Time);
        _context.CountIteration();
        _atThrough = planes.Through;
        _atTarget = planes.Target;
        return (!HasThrough || _atThrough.Crossed) && _atTarget.Crossed && TakeCrossings(r);
    }

    /// <summary>Returns the derivative of the last crossing of the waypoint's plane with respect to the kick's angles.</summary>
    public CrossingJacobian JacobianAtThrough(double[] x) => Jacobian(KickOf(x), in _atThrough);

    /// <summary>Returns the derivative of the crossing of the target's plane.</summary>
    public CrossingJacobian JacobianAtTarget(double[] x) => Jacobian(KickOf(x), in _atTarget);

    /// <summary>True if the last flight leaves the ground and stays above it up to the target.</summary>
    public bool StaysClear(double[] x, double[] r)
    {
        // A kick that stays on the ground is a roll, which other code solves.
        Vector3d end = _frame.Target + (Time * _targetVelocity) + (r[TargetLeft] * _frame.Left) + new Vector3d(0, r[TargetUp], 0);
        return !_context.StaysDown(in _frame, KickOf(x), Speed) && Math.Min(_context.Planes.Lowest, _context.Clearance(in end)) >= -1e-9;
    }

    private CrossingJacobian Jacobian(in Kick kick, in PlaneCrossing crossing) =>
        CrossingJacobian.Of(in kick, in crossing, in _frame, _context.Scene.Air.Wind, _context.Upward);

    /// <summary>Stores the residuals, and the times at which to expect the next crossings.</summary>
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
