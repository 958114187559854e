using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>The boundary-value problem of a kick in its most general form: the ball must be at the target at a given time.</summary>
/// <remarks>
/// A waypoint before the target is optional. The unknowns are elevation, azimuth, speed, spins and times; each is free within bounds, or held. The
/// residuals are the gaps at those times. They change smoothly with all unknowns, even if the path bends.
/// </remarks>
internal sealed class ShootingProblem : IKickObserver, ILeastSquares
{
    /// <summary>
    /// The indices of the unknowns: two angles, log speed, two spins, log time to the target, and the waypoint's share of that time.
    /// </summary>
    public const int Elevation = 0;
    public const int Azimuth = 1;
    public const int LogSpeed = 2;
    public const int Top = 3;
    public const int Side = 4;
    public const int LogTime = 5;
    public const int Share = 6;
    public const int Most = 7;

    /// <summary>The maximum number of residuals: the gaps at the target and at the waypoint.</summary>
    public const int MostEquations = 6;

    /// <summary>The maximum miss of a timely hit, in m; a ball falls by this distance in less than the allowed time error.</summary>
    private const double TimelyMiss = 2e-5;

    /// <summary>The step of a flight dominated by air, and the longest step of a scan, in s.</summary>
    private const double RuledByAirStep = 0.03;
    private const double ScanStep = 0.1;

    /// <summary>The differences that measure the Jacobian, and the largest change of an angle or a logarithm in one iteration.</summary>
    private const double AngleDifference = 1e-4;
    private const double SpinDifference = 0.02;
    private const double Largest = 0.5;

    /// <summary>The maximum number of corrections by the measured miss, and the range of misses that are corrected, as multiples of the tolerance.</summary>
    private const int MostCorrections = 2;
    private const double Enough = 0.5;
    private const double TooFar = 20;

    private const double ShortestTime = 1e-3;
    private const double LeastShare = 0.01;

    private readonly AimContext _context;
    private readonly Simulator _open;
    private readonly Simulator _grounded;
    private readonly TimedFlight _flight;
    private readonly TimedFlight _roll;
    private readonly KickFlight _scan;
    private readonly bool[] _isFree = new bool[Most];
    private readonly double[] _least = new double[Most];
    private readonly double[] _most = new double[Most];
    private readonly double[] _residuals = new double[MostEquations];
    private TargetFrame _frame;
    private Vector3d _through;

    /// <summary>The measured position minus that of the search, in m, for the last correction; and the measured position relative to the target, in m.</summary>
    private Vector3d _defect;
    private Vector3d _measuredGap;
    private Vector3d _arrival;
    private Vector3d _passing;
    private bool _passesThrough;
    private bool _rolls;
    private double _speed;
    private double _step;
    private double _scanStep;
    private double _closeness;
    private ElevationBounds _bounds;
    private double _squared;
    private double _time;
    private double _waySquared;
    private double _wayTime;

    /// <param name="context">The data shared by the searches.</param>
    /// <param name="open">The scene without ground.</param>
    /// <param name="grounded">The scene.</param>
    public ShootingProblem(AimContext context, Simulator open, Simulator grounded)
    {
        _context = context;
        _open = open;
        _grounded = grounded;
        _flight = new TimedFlight(open);
        _roll = new TimedFlight(grounded);
        _scan = new KickFlight(open, this);
        Solver = new LeastSquares(this, MostEquations);
    }

    public AimRequest Request { get; private set; } = new();

    /// <summary>The number of residuals.</summary>
    public int Equations => _passesThrough ? 6 : 3;

    /// <summary>The least-squares solver.</summary>
    public LeastSquares Solver { get; }

    public int Unknowns => Most;

    /// <summary>True if the search budget is used up.</summary>
    public bool IsSpent => _context.IsSpent;

    /// <summary>True if the air dominates, so that several kicks may arrive at the same time.</summary>
    public bool IsRuledByAir { get; private set; }

    /// <summary>True if a hit must be so close that a descending ball does not touch the ground before it is due at its target.</summary>
    public bool IsTimely { get; set; }

    /// <summary>The distance from the ball to the target, in m.</summary>
    public double Way => Vector3d.Distance(_frame.From, in _frame.Target);

    /// <summary>Prepares for a target and, optionally, a waypoint; angles and times are free.</summary>
    /// <param name="request">The request.</param>
    /// <param name="speed">The speed of the kick, in m/s, unless it is made free.</param>
    /// <param name="through">True if the kick must pass the waypoint.</param>
    /// <param name="rolls">True for a kick along the ground.</param>
    public void Begin(AimRequest request, double speed, bool through, bool rolls = false)
    {
        Request = request;
        _defect = Vector3d.Zero;
        _rolls = rolls;
        _speed = speed;
        _frame = _context.Frame(request);
        _through = AimContext.Raised(_context.Game, request.Waypoint.GetValueOrDefault());
        _closeness = IsTimely ? AimContext.Sharp(request.Tolerance, TimelyMiss) : _context.Sharp(in _frame, request.Tolerance);
        double tolerance = _closeness;
        double spinRate = Math.Sqrt(through
            ? (request.MaximumTopSpin * request.MaximumTopSpin) + (request.MaximumSideSpin * request.MaximumSideSpin)
            : (request.TopSpin * request.TopSpin) + (request.SideSpin * request.SideSpin));

        // If the air dominates, paths bend within a step: use shorter steps.
        bool ruled = IsRuledByAir = _context.IsRuledByAir(request.Speed, spinRate);
        _step = Math.Min(ruled ? RuledByAirStep : double.PositiveInfinity, _context.Steps.HitWithin(tolerance));
        _scanStep = ruled ? 0.5 * ScanStep : ScanStep;
        ElevationBounds bounds = _bounds = ElevationBounds.Of(request);

        // Set the bounds of the unknowns. Hold the elevation for a roll, and the speed if the request contains it.
        Bound(Elevation, rolls ? bounds.Clamp(0) : bounds.Lowest, rolls ? bounds.Clamp(0) : bounds.Highest);
        Bound(Azimuth, double.NegativeInfinity, double.PositiveInfinity);
        Bound(LogSpeed, Elementary.Log(1e-3), Elementary.Log(Math.Min(Limits.Speed, 1.5 * request.Speed)));
        Bound(Top, -request.MaximumTopSpin, request.MaximumTopSpin);
        Bound(Side, -request.MaximumSideSpin, request.MaximumSideSpin);
        Bound(LogTime, Elementary.Log(ShortestTime), Elementary.Log(AimContext.LongestFlight));
        Bound(Share, LeastShare, 1.0 - LeastShare);
        _isFree[Elevation] = !rolls;
        _isFree[LogSpeed] = false;
        _isFree[Top] = through;
        _isFree[Side] = through;
        AskThrough(through);
    }

    /// <summary>Includes or excludes the waypoint.</summary>
    public void AskThrough(bool through)
    {
        _passesThrough = through;
        _isFree[Share] = through;
    }

    /// <summary>True if the residuals are small enough for a hit, with a margin for the error of the steps.</summary>
    public bool IsHit(double[] r)
    {
        double tolerance = _closeness;
        double through = AimContext.Sharp(Request.WaypointTolerance, PlaneProblem.FineThrough);
        return (r[0] * r[0]) + (r[1] * r[1]) + (r[2] * r[2]) <= tolerance * tolerance
            && (!_passesThrough || (r[3] * r[3]) + (r[4] * r[4]) + (r[5] * r[5]) <= through * through);
    }

    /// <summary>Returns the kick for the unknowns.</summary>
    public static Kick KickOf(double[] x) => new() { Elevation = x[Elevation], Azimuth = x[Azimuth], Top = x[Top], Side = x[Side] };

    /// <summary>Simulates a kick and computes its residuals.</summary>
    public bool Evaluate(double[] x, double[] r)
    {
        if (_rolls)
        {
            // A kick along the ground has the slope of the ground in its direction.
            x[Elevation] = AlongGround(x[Azimuth]);
        }

        BallState state = Launch(x);
        double time = Elementary.Exp(x[LogTime]);
        double way = _passesThrough ? x[Share] * time : 0;
        // First simulate to the waypoint: the velocity there is the column of the waypoint's time.
        TimedFlight flight = _rolls ? _roll : _flight;
        long pieces = 0;
        if (_passesThrough)
        {
            pieces = flight.Fly(ref state, way, _step);
            _passing = state.Velocity;
            Put(r, 3, state.Position - _through);
        }

        pieces += flight.Fly(ref state, time - way, _step);
        _context.CountSimulation(pieces);
        _arrival = state.Velocity - Request.TargetVelocity;
        Vector3d gap = state.Position + _defect - _frame.Target - (time * Request.TargetVelocity);
        Put(r, 0, _rolls ? gap.Horizontal : gap);
        return true;
    }

    /// <summary>True if a ball that rolls along the ground can hit the target of a request at all.</summary>
    public bool CanRoll(AimRequest request)
    {
        // On a slope, the elevation along the ground depends on the direction, so only the solver knows whether the bounds allow it.
        TargetFrame frame = _context.Frame(request);
        Kick flat = Kick.Of(request, ElevationBounds.Of(request).Clamp(0), 0);
        bool starts = _context.IsLevel ? _context.StaysDown(in frame, in flat, request.Speed) : _context.IsOnGround(in frame.From, request.Tolerance);
        return starts && _context.IsOnGround(in frame.Target, request.Tolerance) && request.TargetVelocity.Y == 0 && frame.Distance > request.Tolerance;
    }

    private double AlongGround(double azimuth) => _bounds.Clamp(_context.AlongGround(in _frame.From, KickVectors.Flat(azimuth, in _frame.Forward)));

    /// <summary>Sets the unknowns to the closed-form kick that reaches the target at a given time, and computes the Jacobian.</summary>
    /// <returns>The velocity before clamping, in m/s.</returns>
    public Vector3d Model(double time, double top, double side, double[] x)
    {
        Vector3d wind = _context.Scene.Air.Wind;
        Vector3d toTarget = _frame.Target + (time * Request.TargetVelocity) - _frame.From;
        var spins = new Kick { Top = top, Side = side };
        Vector3d velocity;
        Vector3d direction;
        double along;
        double across;
        if (_rolls)
        {
            // Rolling friction slows the ball, and the initial slide costs some speed.
            double slowing = _context.Scene.Ground.Material.RollingResistance * _context.Scene.Gravity;
            double length = Math.Max(toTarget.Horizontal.Length, 1e-3);
            double rolled = Math.Min(time, slowing > 0 ? Math.Sqrt(2.0 * length / slowing) : time);
            double speed = 1.2 * ((length / rolled) + (0.5 * slowing * rolled));
            direction = toTarget.Horizontal / length;
            velocity = speed * direction;
            (along, across) = (0.8 * rolled, length / speed);
        }
        else
        {
            // Use quantities relative to the air, with the mean drag and lift over the path.
            Vector3d air = toTarget - (time * wind);
            Vector3d flat = toTarget.Horizontal.Length > 0 ? toTarget.Horizontal / toTarget.Horizontal.Length : _frame.Forward;
            double spinRate = spins.SpinRate;
            Vector3d axis = spinRate > 0 ? new Vector3d(spins.Top * flat.Z, spins.Side, -(spins.Top * flat.X)) / spinRate : Vector3d.Zero;
            FlatFire model = _context.Model(Math.Max(air.Length / time, 1.0), spinRate, air.Length);
            velocity = model.Launch(in air, in axis, time, out direction, out along, out across) + wind;
        }

        Kick kick = _frame.Turned(in spins, in velocity, new ElevationBounds(_least[Elevation], _most[Elevation]));
        x[Elevation] = kick.Elevation;
        x[Azimuth] = kick.Azimuth;
        x[LogSpeed] = Clamp(LogSpeed, Elementary.Log(Math.Max(velocity.Length, 1e-3)));
        x[Top] = kick.Top;
        x[Side] = kick.Side;
        x[LogTime] = Clamp(LogTime, Elementary.Log(time));

        // The closest point p depends on the start velocity v by ∂p/∂v = b I + (a − b) û ûᵀ: a along the direction û of the path, b across it.
        kick.Turns(Elementary.Exp(x[LogSpeed]), in _frame.Forward, out Vector3d byElevation, out Vector3d byAzimuth, out _);
        SetColumn(Solver.Jacobian, 0, Elevation, Stretched(in byElevation));
        SetColumn(Solver.Jacobian, 0, Azimuth, Stretched(in byAzimuth));
        SetColumn(Solver.Jacobian, 0, LogSpeed, Stretched(in velocity));
        return velocity;

        Vector3d Stretched(in Vector3d turn) => (across * turn) + ((along - across) * Vector3d.Dot(in turn, in direction) * direction);
    }

    /// <summary>True if the elevation or the speed is at a bound.</summary>
    public bool IsAtBound(double[] x) =>
        x[Elevation] == _least[Elevation] || x[Elevation] == _most[Elevation] || x[LogSpeed] == _least[LogSpeed] || x[LogSpeed] == _most[LogSpeed];

    public bool IsFree(int unknown) => _isFree[unknown];

    /// <summary>Frees or holds an unknown.</summary>
    public void Free(int unknown, bool isFree) => _isFree[unknown] = isFree;

    /// <summary>Limits the speed, in m/s.</summary>
    public void BoundSpeed(double fastest) => _most[LogSpeed] = Elementary.Log(fastest);

    public double LargestChange(int unknown) => unknown is Top or Side ? double.PositiveInfinity : Largest;

    public double Difference(int unknown) => unknown >= LogTime ? 0 : unknown is Top or Side ? SpinDifference : AngleDifference;

    /// <summary>Sets the columns of the time unknowns, which follow from the velocities.</summary>
    public void KnownColumns(double[] x, double[] j)
    {
        // The unknowns are the logarithm τ of the time t, and the share s of it at the waypoint. At the target, the position p(t) has ∂p/∂τ = t v;
        // at the waypoint, p(s t) has ∂p/∂τ = s t v and ∂p/∂s = t v. v is the velocity there.
        double time = Elementary.Exp(x[LogTime]);
        SetColumn(j, 0, LogTime, time * _arrival);
        SetColumn(j, 0, Share, Vector3d.Zero);
        if (_passesThrough)
        {
            SetColumn(j, 3, LogTime, x[Share] * time * _passing);
            SetColumn(j, 3, Share, time * _passing);
        }
    }

    /// <summary>Simulates a kick while it may come closer, and sets its time unknowns to the times of its closest approaches.</summary>
    /// <returns>The sum of the squared misses, in m².</returns>
    public double Approach(double[] x)
    {
        BallState state = Launch(x);
        _squared = double.PositiveInfinity;
        _waySquared = double.PositiveInfinity;
        _wayTime = 0;
        _scan.Fly(ref state, AimContext.LongestFlight);
        _context.CountSimulation(_scan.Pieces);
        double time = Math.Max(_time, ShortestTime);
        x[LogTime] = Clamp(LogTime, Elementary.Log(time));
        x[Share] = Clamp(Share, _wayTime / time);
        return _squared;
    }

    public double StepFrom(in BallState state, out bool watches)
    {
        watches = false;
        return _scanStep;
    }

    public bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        // Use long steps, each treated as straight, until the ball falls well below both its start and the target.
        double time;
        if (_passesThrough)
        {
            double way = Closest(in before, in after, in _through, Vector3d.Zero, out time);
            (_waySquared, _wayTime) = way < _waySquared ? (way, time) : (_waySquared, _wayTime);
        }

        double squared = Closest(in before, in after, in _frame.Target, Request.TargetVelocity, out time) + (_passesThrough ? _waySquared : 0);
        (_squared, _time) = squared < _squared ? (squared, time) : (_squared, _time);
        ended = after.Position.Y < Math.Min(_frame.From.Y, _frame.Target.Y) - 1.0 && after.Velocity.Y < 0;
        return false;
    }

    /// <summary>Simulates a kick to a given time, and sets the time unknown to it.</summary>
    /// <returns>The squared miss at the target at this time, in m².</returns>
    public double GapAt(double[] x, double time)
    {
        x[LogTime] = Elementary.Log(time);
        Evaluate(x, _residuals);
        return (_residuals[0] * _residuals[0]) + (_residuals[1] * _residuals[1]) + (_residuals[2] * _residuals[2]);
    }

    /// <summary>Clamps an unknown to its bounds.</summary>
    public double Clamp(int unknown, double value) => Math.Min(Math.Max(value, _least[unknown]), _most[unknown]);

    /// <summary>Solves from a start, measures the result, and solves again for the difference from the measured flight.</summary>
    /// <param name="x">The unknowns: the start, and then the best solution found.</param>
    /// <param name="solution">The solution.</param>
    /// <param name="isMeasured">True if the Jacobian of the start is known.</param>
    /// <returns>True if the measured kick hits.</returns>
    public bool Hit(double[] x, out AimSolution solution, bool isMeasured = false)
    {
        // The measurement takes shorter steps, and its flight is the one that counts: add its difference to the flights of the search.
        _defect = Vector3d.Zero;
        bool hits = Solver.Solve(x, isMeasured);
        solution = Solution(x);
        bool isHit = hits && IsMeasuredHit(x, out solution);
        for (int i = 0; i < MostCorrections && hits && solution.Miss > Enough * Request.Tolerance && solution.Miss < TooFar * Request.Tolerance; i++)
        {
            _defect += _measuredGap - new Vector3d(Solver.Residuals[0], Solver.Residuals[1], Solver.Residuals[2]);
            hits = Solver.Solve(x, isMeasured: true);
            if (hits && IsMeasuredHit(x, out AimSolution corrected) && !(isHit && corrected.Miss > solution.Miss))
            {
                isHit = true;
                solution = corrected;
            }
        }

        return isHit;
    }

    /// <summary>Returns the solution for the unknowns, with its measured misses.</summary>
    /// <returns>True if it hits the target, and passes the waypoint.</returns>
    public bool IsMeasuredHit(double[] x, out AimSolution solution)
    {
        solution = Solution(x);
        solution.Vectors(out Vector3d velocity, out Vector3d spin);
        MeasuredMiss measured = _context.Miss.Measure(Request, in velocity, in spin, _isFree[LogTime] ? null : solution.Time);
        _measuredGap = measured.Position - _frame.Target - (measured.Time * Request.TargetVelocity);
        solution.Miss = measured.Distance;
        solution.ThroughMiss = measured.ThroughDistance ?? double.NaN;

        // If the arrival time is fixed, accept a blocked kick, so that the blocking object is reported.
        bool isBlocked = !_isFree[LogTime] && measured.Blocker != MeasuredFlight.NoThing;
        return (measured.Distance <= Request.Tolerance || isBlocked) && (!_passesThrough || measured.ThroughDistance <= Request.WaypointTolerance);
    }

    /// <summary>Returns the solution for the unknowns.</summary>
    public AimSolution Solution(double[] x) => new()
    {
        Reason = AimReason.Hit,
        Kick = KickOf(x),
        Forward = _frame.Forward,
        Speed = _isFree[LogSpeed] ? Elementary.Exp(x[LogSpeed]) : _speed,
        Time = Elementary.Exp(x[LogTime]),
    };

    private BallState Launch(double[] x)
    {
        // The logarithm keeps the speed positive, and makes steps proportional to it.
        KickOf(x).Vectors(Elementary.Exp(x[LogSpeed]), in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        return (_rolls ? _grounded : _open).Launch(_frame.From, velocity, spin, _frame.Orientation);
    }

    /// <summary>Returns the closest approach within a step, treated as straight.</summary>
    private static double Closest(in BallState before, in BallState after, in Vector3d point, in Vector3d velocity, out double time)
    {
        // Relative to the point, which may move: minimise |start + part · way|².
        Vector3d start = before.Position - point - (before.Time * velocity);
        Vector3d way = after.Position - point - (after.Time * velocity) - start;
        double squared = way.LengthSquared;
        double part = squared > 0 ? Math.Min(Math.Max(-Vector3d.Dot(in start, in way) / squared, 0), 1) : 0;
        time = before.Time + (part * (after.Time - before.Time));
        return (start + (part * way)).LengthSquared;
    }

    private void Bound(int unknown, double least, double most)
    {
        _isFree[unknown] = true;
        _least[unknown] = least;
        _most[unknown] = most;
    }

    private static void Put(double[] r, int at, in Vector3d value) => (r[at], r[at + 1], r[at + 2]) = (value.X, value.Y, value.Z);

    private static void SetColumn(double[] j, int row, int column, in Vector3d value)
    {
        j[(row * Most) + column] = value.X;
        j[((row + 1) * Most) + column] = value.Y;
        j[((row + 2) * Most) + column] = value.Z;
    }
}
