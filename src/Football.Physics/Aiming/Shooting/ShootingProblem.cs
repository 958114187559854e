namespace FootballPhysics.Aiming;

/// <summary>
/// The boundary-value problem of a kick in its most general form: the ball is to be at the target at a time, and perhaps at a point on the way before. Elevation,
/// azimuth, speed, spins and times are unknowns, each free within bounds or held; the gaps at those times are the residuals, which change smoothly with all of
/// them, however the way bends.
/// </summary>
internal sealed class ShootingProblem : KickObserver, ILeastSquares
{
    /// <summary>The unknowns: two angles, the logarithm of the speed, two spins, the logarithm of the time to the target, and the share of it to the point on the way.</summary>
    public const int Elevation = 0;
    public const int Azimuth = 1;
    public const int LogSpeed = 2;
    public const int Top = 3;
    public const int Side = 4;
    public const int LogTime = 5;
    public const int Share = 6;
    public const int Most = 7;

    /// <summary>Residuals: the gap at the target, and that at the point on the way.</summary>
    public const int MostEquations = 6;

    /// <summary>Step of a flight that the air rules, and longest step of a scan, s.</summary>
    /// <summary>The miss distance of a hit that is timely, m: a ball falls through it in less than the delay that is allowed.</summary>
    private const double TimelyMiss = 2e-5;

    private const double RuledByAirStep = 0.03;
    private const double ScanStep = 0.1;

    /// <summary>Changes of the unknowns by which the Jacobian is measured, and the largest of an angle or a logarithm in one iteration.</summary>
    private const double AngleDifference = 1e-4;
    private const double SpinDifference = 0.02;
    private const double Largest = 0.5;

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
    private Vector3d _arrival;
    private Vector3d _passing;
    private bool _passesThrough;
    private bool _rolls;
    private double _speed;
    private double _step;
    private double _scanStep;
    private double _squared;
    private double _time;
    private double _waySquared;
    private double _wayTime;

    /// <param name="context">What the searches share.</param>
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

    /// <summary>How many residuals there are.</summary>
    public int Equations => _passesThrough ? 6 : 3;

    /// <summary>Solves it.</summary>
    public LeastSquares Solver { get; }

    public int Unknowns => Most;

    /// <summary>True when nothing more can be searched.</summary>
    public bool IsSpent => _context.IsSpent;

    /// <summary>True when the air rules, so that there may be several kicks for one time.</summary>
    public bool IsRuledByAir { get; private set; }

    /// <summary>True if a hit must be so close that a ball that comes down at its target touches the ground there when due, not earlier.</summary>
    public bool IsTimely { get; set; }

    /// <summary>From the ball to the target, m.</summary>
    public double Way => Vector3d.Distance(_frame.From, in _frame.Target);

    /// <summary>Prepares for a target, and for the point on the way where the request has one; angles and times are free.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="speed">Its speed, m/s, unless that is made free.</param>
    /// <param name="through">Whether it is to pass the point on the way.</param>
    /// <param name="rolls">Whether it is to go along the ground.</param>
    public void Begin(AimRequest request, double speed, bool through, bool rolls = false)
    {
        Request = request;
        _rolls = rolls;
        _speed = speed;
        _frame = _context.Frame(request);
        _through = AimContext.Raised(_context.Game, request.Waypoint.GetValueOrDefault());
        double tolerance = Closeness(request);
        double spinRate = Math.Sqrt(through
            ? (request.MaximumTopSpin * request.MaximumTopSpin) + (request.MaximumSideSpin * request.MaximumSideSpin)
            : (request.TopSpin * request.TopSpin) + (request.SideSpin * request.SideSpin));

        // Where the air rules, ways bend within a step: shorter ones.
        bool ruled = IsRuledByAir = _context.IsRuledByAir(request.Speed, spinRate);
        _step = Math.Min(ruled ? RuledByAirStep : double.PositiveInfinity, _context.Steps.HitWithin(tolerance));
        _scanStep = ruled ? 0.5 * ScanStep : ScanStep;
        ElevationBounds bounds = ElevationBounds.Of(request);

        // Bounds of the unknowns; of a roll the elevation is held, and of a kick of given speed the speed.
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

    /// <summary>Asks for the point on the way, or for no more than the target.</summary>
    public void AskThrough(bool through)
    {
        _passesThrough = through;
        _isFree[Share] = through;
    }

    /// <summary>True when residuals are a hit, with room for what the steps of the flights are off.</summary>
    public bool IsHit(double[] r)
    {
        double tolerance = Closeness(Request);
        double through = AimContext.Sharp(Request.WaypointTolerance, PlaneProblem.FineThrough);
        return (r[0] * r[0]) + (r[1] * r[1]) + (r[2] * r[2]) <= tolerance * tolerance
            && (!_passesThrough || (r[3] * r[3]) + (r[4] * r[4]) + (r[5] * r[5]) <= through * through);
    }

    private double Closeness(AimRequest request) => IsTimely ? AimContext.Sharp(request.Tolerance, TimelyMiss) : AimContext.Sharp(request.Tolerance);

    /// <summary>The kick that unknowns stand for.</summary>
    public static Kick KickOf(double[] x) => new() { Elevation = x[Elevation], Azimuth = x[Azimuth], Top = x[Top], Side = x[Side] };

    /// <summary>Flies a kick.</summary>
    public bool Fly(double[] x, double[] r)
    {
        BallState state = Launch(x);
        double time = Elementary.Exp(x[LogTime]);
        double way = _passesThrough ? x[Share] * time : 0;
        // To the point on the way first, where there is one: its velocity there is the column of its time.
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
        Vector3d gap = state.Position - _frame.Target - (time * Request.TargetVelocity);
        Put(r, 0, _rolls ? gap.Horizontal : gap);
        return true;
    }

    /// <summary>True when a ball along the ground can hit the target of a request at all.</summary>
    public bool CanRoll(AimRequest request)
    {
        TargetFrame frame = _context.Frame(request);
        Elementary.SinCos(ElevationBounds.Of(request).Clamp(0), out double sine, out _);
        return _context.StaysDown(in frame.From, request.Speed * sine) && Math.Abs(frame.Target.Y - _context.Game.ContactHeight) < request.Tolerance
            && request.TargetVelocity.Y == 0 && frame.Distance > request.Tolerance;
    }

    /// <summary>The kick that is at the target at a time, in closed form, and the Jacobian there.</summary>
    /// <returns>Its velocity without bounds, m/s.</returns>
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
            // A ball that rolls slows down by friction, and by what its slide costs it first.
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
            // Through the air that the wind carries along, with the mean drag and lift of that way.
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

        // ∂p/∂v = b I + (a − b) û ûᵀ: it stretches differently along the way and across it.
        kick.Turns(Elementary.Exp(x[LogSpeed]), in _frame.Forward, out Vector3d byElevation, out Vector3d byAzimuth, out _);
        SetColumn(Solver.Jacobian, 0, Elevation, Stretched(in byElevation));
        SetColumn(Solver.Jacobian, 0, Azimuth, Stretched(in byAzimuth));
        SetColumn(Solver.Jacobian, 0, LogSpeed, Stretched(in velocity));
        return velocity;

        Vector3d Stretched(in Vector3d turn) => (across * turn) + ((along - across) * Vector3d.Dot(in turn, in direction) * direction);
    }

    /// <summary>True when the elevation or the speed is as low, or as high, as it may be.</summary>
    public bool IsAtBound(double[] x) =>
        x[Elevation] == _least[Elevation] || x[Elevation] == _most[Elevation] || x[LogSpeed] == _least[LogSpeed] || x[LogSpeed] == _most[LogSpeed];

    public bool IsFree(int unknown) => _isFree[unknown];

    /// <summary>Makes an unknown free, or holds it.</summary>
    public void Free(int unknown, bool isFree) => _isFree[unknown] = isFree;

    /// <summary>Bounds the speed, m/s.</summary>
    public void BoundSpeed(double fastest) => _most[LogSpeed] = Elementary.Log(fastest);

    public double LargestChange(int unknown) => unknown is Top or Side ? double.PositiveInfinity : Largest;

    public double Difference(int unknown) => unknown >= LogTime ? 0 : unknown is Top or Side ? SpinDifference : AngleDifference;

    /// <summary>The columns of the times, which the velocities tell.</summary>
    public void KnownColumns(double[] x, double[] j)
    {
        // p(e^τ): ∂p/∂τ = t v; on the way at s t: ∂p/∂τ = s t v, ∂p/∂s = t v
        double time = Elementary.Exp(x[LogTime]);
        SetColumn(j, 0, LogTime, time * _arrival);
        SetColumn(j, 0, Share, Vector3d.Zero);
        if (_passesThrough)
        {
            SetColumn(j, 3, LogTime, x[Share] * time * _passing);
            SetColumn(j, 3, Share, time * _passing);
        }
    }

    /// <summary>Flies a kick as far as it may come close, and sets its times to those of its closest approaches.</summary>
    /// <returns>The sum of the squares of what it misses by, m².</returns>
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

    public override double StepFrom(in BallState state, out bool watches)
    {
        watches = false;
        return _scanStep;
    }

    public override bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        // In long steps, as if each were straight, until the ball falls below both ends.
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

    /// <summary>Flies a kick to a time, and sets its time to that.</summary>
    /// <returns>The square of what it misses the target by then, m².</returns>
    public double GapAt(double[] x, double time)
    {
        x[LogTime] = Elementary.Log(time);
        Fly(x, _residuals);
        return (_residuals[0] * _residuals[0]) + (_residuals[1] * _residuals[1]) + (_residuals[2] * _residuals[2]);
    }

    /// <summary>An unknown within its bounds.</summary>
    public double Clamp(int unknown, double value) => Math.Min(Math.Max(value, _least[unknown]), _most[unknown]);

    /// <summary>Solves it from a start, and measures what that leads to.</summary>
    /// <param name="x">The unknowns: the start, and then the best that was found.</param>
    /// <param name="solution">The solution.</param>
    /// <param name="isMeasured">Whether the Jacobian of the start is known.</param>
    /// <returns>Whether that truly hits.</returns>
    public bool Hit(double[] x, out AimSolution solution, bool isMeasured = false)
    {
        bool hits = Solver.Solve(x, isMeasured);
        solution = Solution(x);
        return hits && IsMeasuredHit(x, out solution);
    }

    /// <summary>The solution that unknowns stand for, with its true misses.</summary>
    /// <returns>Whether it hits, and passes the point on the way.</returns>
    public bool IsMeasuredHit(double[] x, out AimSolution solution)
    {
        solution = Solution(x);
        solution.Vectors(out Vector3d velocity, out Vector3d spin);
        MeasuredMiss measured = _context.Miss.Measure(Request, in velocity, in spin, _isFree[LogTime] ? null : solution.Time);
        solution.Miss = measured.Distance;
        solution.ThroughMiss = measured.ThroughDistance ?? double.NaN;

        // What is in the way of the kick for a time is to be told.
        bool isBlocked = !_isFree[LogTime] && measured.Blocker != MeasuredFlight.NoThing;
        return (measured.Distance <= Request.Tolerance || isBlocked) && (!_passesThrough || measured.ThroughDistance <= Request.WaypointTolerance);
    }

    /// <summary>The solution that unknowns stand for.</summary>
    public AimSolution Solution(double[] x) => new()
    {
        Status = AimStatus.Hit,
        Kick = KickOf(x),
        Forward = _frame.Forward,
        Speed = _isFree[LogSpeed] ? Elementary.Exp(x[LogSpeed]) : _speed,
        Time = Elementary.Exp(x[LogTime]),
    };

    private BallState Launch(double[] x)
    {
        // The logarithm of the speed keeps it above zero, and makes a step a share of it.
        KickOf(x).Vectors(Elementary.Exp(x[LogSpeed]), in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        return (_rolls ? _grounded : _open).Launch(_frame.From, velocity, spin);
    }

    /// <summary>Closest approach of a step, as if it were straight.</summary>
    private static double Closest(in BallState before, in BallState after, in Vector3d point, in Vector3d velocity, out double time)
    {
        // Relative to the point, which may move: least of |start + part · way|².
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

/// <summary>A flight, or a roll, to a time.</summary>
internal sealed class TimedFlight : KickObserver
{
    /// <summary>Step of a roll, s, and of one that is fast enough to meet the drag law's jump, and that speed, m/s.</summary>
    private const double RollStep = 0.1;
    private const double FastRollStep = 0.02;
    private const double FastRoll = 11;

    private readonly KickFlight _kick;
    private double _step;
    private double _end;

    public TimedFlight(Simulator simulator) => _kick = new KickFlight(simulator, this);

    /// <summary>Flies on.</summary>
    /// <param name="state">The ball.</param>
    /// <param name="time">For how long, s.</param>
    /// <param name="longestStep">The longest step in the air, s.</param>
    /// <returns>Pieces of motion.</returns>
    public long Fly(ref BallState state, double time, double longestStep)
    {
        _step = time / Math.Ceiling(time / longestStep);
        _end = state.Time + time;
        _kick.Fly(ref state, _end - (1e-9 * time));
        return _kick.Pieces;
    }

    public override double StepFrom(in BallState state, out bool watches)
    {
        // In the air equal steps that end with the time; on the ground as long as the motion allows.
        watches = false;
        bool isFast = state.Motion == MotionState.Sliding || state.Velocity.LengthSquared > FastRoll * FastRoll;
        return state.Motion == MotionState.Airborne ? _step : Math.Min(isFast ? FastRollStep : RollStep, _end - state.Time);
    }

    public override bool Doubts(in BallState before, in BallState after, StepLog log, ref bool ended)
    {
        ended = after.Motion == MotionState.Rest;
        return false;
    }
}
