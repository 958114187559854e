using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>The general solver, used if <see cref="DirectAim"/> finds no kick; any quantity may be unknown.</summary>
/// <remarks>
/// If the closed form is too far from a solution, the Levenberg–Marquardt method starts from scans over all directions. For five balls in a storm,
/// omitting the scan at a given speed loses 8 kicks; the scan for the slowest kick, 26 slower kicks; the scan at a given time, 4; the scan with a
/// waypoint, 14 of 176 (<c>football lab answers --only known --count 300</c>).
/// </remarks>
internal sealed class GeneralAim
{
    private const int N = ShootingProblem.Most;

    /// <summary>The number of elevations and azimuths in a scan at a given speed, and the number of its starts to use.</summary>
    private const int Rows = 13;
    private const int Columns = 12;
    private const int MostStarts = 8;

    /// <summary>The range of times for closed-form kicks, relative to the time of the slowest kick, and the number of bisections.</summary>
    private const double Earliest = 0.1;
    private const double Latest = 8;
    private const int Halvings = 7;

    /// <summary>The elevation, in rad, above which spin may bring a ball to the target from another direction.</summary>
    private const double Steep = 0.8;

    /// <summary>The size of scans with free speed, and the ratio of their speeds.</summary>
    private const int FreeRows = 9;
    private const int FreeColumns = 10;
    private const int MostFreeStarts = 4;
    private const int Scans = 3;
    private const double SlowerScan = 0.7;

    /// <summary>The ratio of horizontal wind speed to kick speed above which the speed may have several local minima.</summary>
    private const double Drift = 1.25;

    /// <summary>The time of a roll, relative to that at its initial speed.</summary>
    private const double RollTime = 1.3;

    /// <summary>The further starts of a roll: their number, the angle between their directions, in rad, and their time, relative to the first.</summary>
    private const int RollStarts = 6;
    private const double RollTurn = 0.5;
    private const double LongRoll = 1.6;

    private readonly AimContext _context;
    private readonly ShootingProblem _problem;
    private readonly DirectionScan _scan;
    private readonly SolutionCurve _curve;
    private readonly double[] _x = new double[N];

    public GeneralAim(AimContext context)
    {
        _context = context;
        _problem = context.Shooting;
        _scan = new DirectionScan(_problem);
        _curve = new SolutionCurve(_problem);
    }

    private enum Choice
    {
        First,
        Earliest,
        Latest,
        Slowest,
    }

    /// <summary>Finds the kick at a given speed that hits the target.</summary>
    /// <returns>True if a kick was found and confirmed by measurement.</returns>
    public bool WithSpeed(AimRequest request, double speed, AimArc arc, double top, double side, out AimSolution solution)
    {
        // 1. Start from the closed form on the requested arc, then on the other arc. 2. If the air dominates, or the arc is uncertain, use the
        // earliest or latest hit in a scan over all directions. Leave half of the budget for later searches.
        solution = default;
        if (_context.IsHalfSpent)
        {
            return false;
        }

        _problem.Begin(request, speed, through: false);
        bool found = FromModels(speed, arc, top, side, ref solution, out bool isDoubtful);
        if (found && !isDoubtful && !_problem.IsRuledByAir)
        {
            return true;
        }

        _scan.Clear();
        _scan.Fly(Rows, Columns, speed, top, side);
        return Follow(MostStarts, arc == AimArc.Low ? Choice.Earliest : Choice.Latest, leavesHalf: true, ref solution, ref found);
    }

    /// <summary>Finds the kick at a given speed that hits the target, starting from a nearby kick.</summary>
    public bool From(AimRequest request, double speed, in Kick kick, double time, out AimSolution solution)
    {
        _problem.Begin(request, speed, through: false);
        Put(_problem, _x, in kick, speed, time);
        return _problem.Hit(_x, out solution);
    }

    /// <summary>Finds the kick along the ground at a given speed that hits the target.</summary>
    /// <param name="request">The request.</param>
    /// <param name="speed">The speed, in m/s.</param>
    /// <param name="top">The topspin, in rad/s.</param>
    /// <param name="side">The sidespin, in rad/s.</param>
    /// <param name="isThorough">True to start from other directions too: wind or slope may carry a slow ball a long way.</param>
    /// <param name="solution">The kick.</param>
    /// <returns>True if a kick was found and confirmed by measurement.</returns>
    public bool Roll(AimRequest request, double speed, double top, double side, bool isThorough, out AimSolution solution)
    {
        // Start from the time at the mean speed of a roll. If the closed form is too far off, go on with a measured Jacobian.
        _problem.Begin(request, speed, through: false, rolls: true);
        double time = RollTime * _problem.Way / speed;
        solution = default;
        bool found = FromModel(time, speed, top, side, ref solution) || _problem.Hit(_x, out solution);
        for (int i = 0; i < RollStarts && isThorough && !found && !_context.IsHalfSpent; i++)
        {
            double turn = ((i / 2) + 1) * (i % 2 == 0 ? RollTurn : -RollTurn);
            Model(Math.Min(LongRoll * time, AimContext.LongestFlight), top, side);
            _x[ShootingProblem.Azimuth] += turn;
            _x[ShootingProblem.LogSpeed] = Elementary.Log(speed);
            found = _problem.Hit(_x, out solution);
        }

        return found;
    }

    /// <summary>Finds the kick that reaches the target at a given time, in flight or along the ground, no faster than requested.</summary>
    /// <remarks>If there is none, the solution is a kick that comes close.</remarks>
    /// <returns>True if a kick was found and confirmed by measurement.</returns>
    public bool AtTime(AimRequest request, double time, out AimSolution solution)
    {
        // 1. Start from the closed-form flight. It solves Lambert's problem for a ball, and changes smoothly with time. 2. Try a roll. 3. If the
        // result is not at a bound, or if paths bend, other kicks may exist: start from scans.
        BeginAtTime(request, rolls: false);
        if (FromModel(time, out solution))
        {
            return true;
        }

        AimSolution closest = _problem.Solution(_x);
        bool isBound = _problem.IsAtBound(_x);
        if (_problem.CanRoll(request))
        {
            BeginAtTime(request, rolls: true);
            if (FromModel(time, out solution) || FromScans(request, time, Choice.First, ref solution, found: false))
            {
                return true;
            }
        }

        // The kick is unique if it is at a bound, the scene is the same in all directions, the air does not dominate, and no spin turns the ball back.
        bool turnsBack = request.TopSpin != 0 && closest.Kick.Elevation > Steep;
        if (!isBound || _problem.IsRuledByAir || !_context.IsEvenAround || turnsBack)
        {
            BeginAtTime(request, rolls: false);
            if ((turnsBack && FromBehind(time, out solution)) || FromScans(request, time, Choice.First, ref solution, found: false))
            {
                return true;
            }
        }

        solution = closest;
        return false;
    }

    /// <summary>Sets a value that requires kicks to arrive within 0.1 ms of the given time.</summary>
    public bool IsTimely
    {
        set => _problem.IsTimely = value;
    }

    /// <summary>Finds the kick that flies or rolls to the target in a given time, or a close one, no faster than requested.</summary>
    /// <remarks>A flight starts from the closed form, and then from a hit at another time, if one is known. A roll, which bends more, starts from the hit.</remarks>
    public AimSolution AtTime(AimRequest request, double time, bool rolls, in AimSolution near)
    {
        BeginAtTime(request, rolls);
        bool found = rolls ? FromHit(time, in near, out AimSolution solution) : FromModel(time, out solution);
        AimSolution other = default;
        return !found && (rolls ? FromModel(time, out other) : FromHit(time, in near, out other)) ? other : solution;
    }

    /// <summary>Solves from a hit at another time.</summary>
    private bool FromHit(double time, in AimSolution hit, out AimSolution solution)
    {
        solution = hit;
        if (!(hit.Time > 0))
        {
            return false;
        }

        Put(_problem, _x, in hit.Kick, hit.Speed, time);
        return _problem.Hit(_x, out solution);
    }

    /// <summary>Finds the slowest kick that flies to the target, no faster than requested.</summary>
    /// <returns>True if a kick was found and confirmed by measurement.</returns>
    public bool Slowest(AimRequest request, out AimSolution solution)
    {
        // 1. Start from the slowest closed-form kick, or at the bound if this kick is outside the elevation bounds. 2. Follow the curve of hits to
        // the minimum speed. 3. Scan if other minima may exist.
        Begin(request, rolls: false);
        bool found = FromSlowestModel(request, out solution);
        solution.Vectors(out Vector3d velocity, out _);
        bool isOnlyOne = found && !_problem.IsRuledByAir && _context.Scene.Air.Wind.Horizontal.Length < Drift * velocity.Horizontal.Length;
        return isOnlyOne || FromScans(request, null, Choice.Slowest, ref solution, found);
    }

    private bool FromSlowestModel(AimRequest request, out AimSolution solution)
    {
        // Within the bounds, hold the time of the slowest closed-form kick. At a bound, hold the elevation.
        double time = SlowestOfModel(request.TopSpin, request.SideSpin, request.Speed, out _);
        double elevation = ElevationOf(Model(time, request.TopSpin, request.SideSpin));
        double bound = _problem.Clamp(ShootingProblem.Elevation, elevation);
        int held = bound == elevation ? ShootingProblem.LogTime : ShootingProblem.Elevation;
        if (bound != elevation)
        {
            Model(TimeOfModel(time, elevation > bound, request.TopSpin, request.SideSpin, 0, bound), request.TopSpin, request.SideSpin);
            _x[ShootingProblem.Elevation] = bound;
        }

        // Three unknowns remain for three residuals.
        _problem.Free(held, false);
        bool found = _problem.Solver.Solve(_x, isMeasured: true);
        _problem.Free(held, true);
        solution = _problem.Solution(_x);
        return found && Descended(out solution);
    }

    /// <summary>Follows the curve of hits from one hit to the slowest kick; only the final kick is measured.</summary>
    private bool Descended(out AimSolution solution)
    {
        solution = _problem.Solution(_x);
        _curve.Descend(_x, ref solution);
        return _problem.IsMeasuredHit(_x, out solution);
    }

    /// <summary>Returns the arc of a hit: low if a longer flight needs a slower kick, high if it needs a faster one.</summary>
    public AimArc ArcOf(AimRequest request, in AimSolution hit)
    {
        Begin(request, rolls: false);
        Put(_problem, _x, in hit.Kick, hit.Speed, hit.Time);
        return _curve.SlowsWithTime(_x) ? AimArc.Low : AimArc.High;
    }

    /// <summary>Sets the unknowns to a kick, clamped to their bounds.</summary>
    public static void Put(ShootingProblem problem, double[] x, in Kick kick, double speed, double time)
    {
        x[ShootingProblem.Elevation] = problem.Clamp(ShootingProblem.Elevation, kick.Elevation);
        x[ShootingProblem.Azimuth] = kick.Azimuth;
        x[ShootingProblem.LogSpeed] = Elementary.Log(speed);
        x[ShootingProblem.Top] = problem.IsFree(ShootingProblem.Top) ? problem.Clamp(ShootingProblem.Top, kick.Top) : kick.Top;
        x[ShootingProblem.Side] = problem.IsFree(ShootingProblem.Side) ? problem.Clamp(ShootingProblem.Side, kick.Side) : kick.Side;
        x[ShootingProblem.LogTime] = Elementary.Log(Math.Max(time, 1e-3));
    }

    /// <summary>Begins a search for a kick with free speed.</summary>
    private void Begin(AimRequest request, bool rolls)
    {
        _problem.Begin(request, request.Speed, through: false, rolls);
        _problem.Free(ShootingProblem.LogSpeed, true);
        _problem.BoundSpeed(request.Speed);
    }

    private void BeginAtTime(AimRequest request, bool rolls)
    {
        Begin(request, rolls);
        _problem.Free(ShootingProblem.LogTime, false);
    }

    /// <summary>Solves from the closed-form kick.</summary>
    private bool FromModel(double time, out AimSolution solution)
    {
        Model(time, _problem.Request.TopSpin, _problem.Request.SideSpin);
        return _problem.Hit(_x, out solution, isMeasured: true);
    }

    /// <summary>Solves from the closed-form kick in the opposite direction: a steep kick that backspin brings back.</summary>
    private bool FromBehind(double time, out AimSolution solution)
    {
        Model(time, _problem.Request.TopSpin, _problem.Request.SideSpin);
        _x[ShootingProblem.Azimuth] += Math.PI;
        return _problem.Hit(_x, out solution);
    }

    /// <summary>Solves from the closed-form kicks at a given speed: first the one on the requested arc, then the other.</summary>
    /// <param name="speed">The speed, in m/s.</param>
    /// <param name="arc">The arc.</param>
    /// <param name="top">The topspin, in rad/s.</param>
    /// <param name="side">The sidespin, in rad/s.</param>
    /// <param name="solution">The kick.</param>
    /// <param name="isDoubtful">True if there may be another kick on the requested arc.</param>
    private bool FromModels(double speed, AimArc arc, double top, double side, ref AimSolution solution, out bool isDoubtful)
    {
        // As the time of flight increases, the required speed first falls (low arc) and then rises (high arc).
        isDoubtful = false;
        double slowest = SlowestOfModel(top, side, speed, out double least);
        if (!(least < speed))
        {
            return FromModel(slowest, speed, top, side, ref solution);
        }

        double chosen = TimeOfModel(slowest, arc == AimArc.Low, top, side, speed, null);
        double other = TimeOfModel(slowest, arc != AimArc.Low, top, side, speed, null);
        if (FromModel(chosen, speed, top, side, ref solution))
        {
            isDoubtful = Math.Abs(Elementary.Log(solution.Time / chosen)) > Math.Abs(Elementary.Log(solution.Time / other));
            return true;
        }

        return FromModel(other, speed, top, side, ref solution);
    }

    /// <summary>Returns the approximate time of the slowest closed-form kick.</summary>
    private double SlowestOfModel(double top, double side, double fastest, out double speed)
    {
        // In vacuum, the slowest kick over the distance d takes a time t with t² = 2 d/g. Start there, and move to the vertex of a parabola in log t.
        double way = _problem.Way;
        double fall = Math.Abs(_context.Upward) > 1e-3 ? Math.Sqrt(2.0 * way / Math.Abs(_context.Upward)) : double.PositiveInfinity;
        double time = Math.Min(Math.Max(fall, 1.2 * way / fastest), AimContext.LongestFlight);
        speed = 0;
        for (double width = 0.3; width > 0.1; width *= 0.5)
        {
            // Fit a parabola through three times. If it has no minimum, move in the direction in which it falls.
            double ratio = Elementary.Exp(width);
            double below = Model(time / ratio, top, side).Length;
            speed = Model(time, top, side).Length;
            double above = Model(time * ratio, top, side).Length;
            double curvature = (above - (2.0 * speed) + below) / (width * width);
            double slope = (above - below) / (2.0 * width);
            double move = curvature > 0 ? -slope / curvature : slope > 0 ? -width : width;
            time = Math.Min(time * Elementary.Exp(Math.Min(Math.Max(move, -0.6), 0.6)), AimContext.LongestFlight);
        }

        return time;
    }

    /// <summary>Returns the time, before or after that of the slowest kick, at which a closed-form kick has a given speed or elevation.</summary>
    private double TimeOfModel(double slowest, bool isEarlier, double top, double side, double speed, double? elevation)
    {
        double near = slowest;
        double far = isEarlier ? Earliest * slowest : Math.Min(Latest * slowest, AimContext.LongestFlight);
        for (int i = 0; i < Halvings; i++)
        {
            // Bisect in the logarithm of the time: on each side of the slowest kick, the speed is monotonic.
            double middle = Math.Sqrt(near * far);
            Vector3d velocity = Model(middle, top, side);
            bool isNear = elevation is { } bound ? ElevationOf(in velocity) > bound == isEarlier : velocity.Length < speed;
            (near, far) = isNear ? (middle, far) : (near, middle);
        }

        return Math.Sqrt(near * far);
    }

    private Vector3d Model(double time, double top, double side) => _problem.Model(time, top, side, _x);

    private static double ElevationOf(in Vector3d velocity) => Elementary.Atan2(velocity.Y, velocity.Horizontal.Length);

    private bool FromModel(double time, double speed, double top, double side, ref AimSolution solution)
    {
        Model(time, top, side);
        _x[ShootingProblem.LogSpeed] = Elementary.Log(speed);
        return _problem.Hit(_x, out solution, isMeasured: true);
    }

    /// <summary>Solves from scans at several speeds.</summary>
    private bool FromScans(AimRequest request, double? time, Choice choice, ref AimSolution solution, bool found)
    {
        double speed = request.Speed;
        for (int i = 0; i < Scans && !(found && choice == Choice.First); i++, speed *= SlowerScan)
        {
            _scan.Clear();
            _scan.Fly(FreeRows, FreeColumns, speed, request.TopSpin, request.SideSpin, time);
            Follow(MostFreeStarts, choice, leavesHalf: false, ref solution, ref found);
        }

        return found;
    }

    /// <summary>Solves from the starts of a scan.</summary>
    private bool Follow(int most, Choice choice, bool leavesHalf, ref AimSolution solution, ref bool found)
    {
        for (int start = 0; start < Math.Min(most, _scan.Count) && !(leavesHalf ? _context.IsHalfSpent : _context.IsSpent); start++)
        {
            _scan.Start(start, _x);
            if (!_problem.Hit(_x, out AimSolution one))
            {
                continue;
            }

            if (choice == Choice.Slowest && Descended(out AimSolution slower))
            {
                one = slower;
            }

            bool isBetter = choice == Choice.Slowest ? one.Speed < solution.Speed : choice == Choice.Latest ? one.Time > solution.Time : one.Time < solution.Time;
            solution = !found || isBetter ? one : solution;
            found = true;
            if (choice == Choice.First)
            {
                break;
            }
        }

        return found;
    }
}
