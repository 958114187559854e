namespace FootballPhysics.Aiming;

/// <summary>
/// The general way to aim, where <see cref="DirectAim"/> does not lead to a kick: any of its numbers may be unknown, and what a closed form is too far from is sought
/// from scans over all directions by the method of Levenberg and Marquardt.
/// </summary>
/// <remarks>
/// What the scans are for (<c>football lab answers --only known --count 300</c>): without that of a given speed 8 kicks of five balls in a storm are lost, without that of the
/// slowest 26 slower ones, without that for a time 4, without that through two points 14 of 176.
/// </remarks>
internal sealed class GeneralAim
{
    private const int N = ShootingProblem.Most;

    /// <summary>Elevations and azimuths of a scan for a given speed, and its starts that are followed.</summary>
    private const int Rows = 13;
    private const int Columns = 12;
    private const int MostStarts = 8;

    /// <summary>Times of kicks in closed form that are looked at, as shares of that of the slowest, and how often the way between two is halved.</summary>
    private const double Earliest = 0.1;
    private const double Latest = 8;
    private const int Halvings = 7;

    /// <summary>Above this elevation, rad, spin may bring a ball to the target that was kicked elsewhere.</summary>
    private const double Steep = 0.8;

    /// <summary>Rows of a scan where the speed is free, and its speeds as shares of the fastest.</summary>
    private const int FreeRows = 9;
    private const int FreeColumns = 10;
    private const int MostFreeStarts = 4;
    private const int Scans = 3;
    private const double SlowerScan = 0.7;

    /// <summary>Elevations, azimuths and spins of the scans for a kick through two points.</summary>
    private const int ThroughRows = 5;
    private const int ThroughColumns = 6;
    private const int Spins = 9;

    /// <summary>Speeds of the wind and of the kick, both horizontally, above whose ratio there may be several kicks that are slower than their neighbours.</summary>
    private const double Drift = 1.25;

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

    private enum Wanted
    {
        First,
        Earliest,
        Latest,
        Slowest,
    }

    /// <summary>The kick of a speed that hits the target.</summary>
    /// <returns>Whether there is one, measured.</returns>
    public bool WithSpeed(AimRequest request, double speed, AimArc arc, double top, double side, out AimSolution solution)
    {
        // 1. From the closed form on the wanted arc, else on the other. 2. Where the air rules, or that led to the other arc, from a scan over all directions: the
        // earliest of its hits, or the last. It leaves half of the flights to who comes after.
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
        return Follow(MostStarts, arc == AimArc.Low ? Wanted.Earliest : Wanted.Latest, leavesHalf: true, ref solution, ref found);
    }

    /// <summary>The kick of a speed that hits the target, from one that is close.</summary>
    public bool From(AimRequest request, double speed, in Kick kick, double time, out AimSolution solution)
    {
        _problem.Begin(request, speed, through: false);
        Put(in kick, speed, time);
        return _problem.Hit(_x, out solution);
    }

    /// <summary>The kick that is at the target at a time, in flight or along the ground, no faster than the request; where there is none, what comes close.</summary>
    /// <returns>Whether there is one, measured.</returns>
    public bool AtTime(AimRequest request, double time, out AimSolution solution)
    {
        // 1. From the flight in closed form: Lambert's problem for a ball, whose solution changes smoothly with the time. 2. Along the ground.
        // 3. Where that ended within the bounds, or ways bend, there may be another: from scans.
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
            if (FromModel(time, out solution) || FromScans(request, time, Wanted.First, ref solution, found: false))
            {
                return true;
            }
        }

        // On a bound, in still air that does not rule, without a spin that turns the ball back, there is no other kick to look for.
        bool turnsBack = request.TopSpin != 0 && closest.Kick.Elevation > Steep;
        if (!isBound || _problem.IsRuledByAir || !_context.Scene.Air.IsStill || turnsBack)
        {
            BeginAtTime(request, rolls: false);
            if ((turnsBack && FromBehind(time, out solution)) || FromScans(request, time, Wanted.First, ref solution, found: false))
            {
                return true;
            }
        }

        solution = closest;
        return false;
    }

    /// <summary>True if the next searches must find kicks that are at the target when due, to a tenth of a millisecond.</summary>
    public bool IsTimely
    {
        set => _problem.IsTimely = value;
    }

    /// <summary>The kick that flies to the target in a time, no faster than the request, or comes close: from the closed form alone.</summary>
    public AimSolution FlightAtTime(AimRequest request, double time)
    {
        BeginAtTime(request, rolls: false);
        return FromModel(time, out AimSolution solution) ? solution : _problem.Solution(_x);
    }

    /// <summary>The slowest kick that flies to the target, no faster than the request.</summary>
    /// <returns>Whether there is one, measured.</returns>
    public bool Slowest(AimRequest request, out AimSolution solution)
    {
        // 1. From the slowest in closed form, or the one on the bound of the elevations beyond which that lies. 2. Along the curve of the kicks that hit to
        // where the speed is least. 3. A scan where there may be others.
        Begin(request, rolls: false);
        bool found = FromSlowestModel(request, out solution);
        solution.Vectors(out Vector3d velocity, out _);
        bool isOnlyOne = found && !_problem.IsRuledByAir && _context.Scene.Air.Wind.Horizontal.Length < Drift * velocity.Horizontal.Length;
        return isOnlyOne || FromScans(request, null, Wanted.Slowest, ref solution, found);
    }

    private bool FromSlowestModel(AimRequest request, out AimSolution solution)
    {
        // Within the bounds the time is held, at that of the slowest in closed form; on a bound the elevation is.
        double time = SlowestOfModel(request.TopSpin, request.SideSpin, request.Speed, out _);
        double elevation = ElevationOf(Model(time, request.TopSpin, request.SideSpin));
        double bound = _problem.Clamp(ShootingProblem.Elevation, elevation);
        int held = bound == elevation ? ShootingProblem.LogTime : ShootingProblem.Elevation;
        if (bound != elevation)
        {
            Model(TimeOfModel(time, elevation > bound, request.TopSpin, request.SideSpin, 0, bound), request.TopSpin, request.SideSpin);
            _x[ShootingProblem.Elevation] = bound;
        }

        // Three unknowns for three residuals.
        _problem.Free(held, false);
        bool found = _problem.Solver.Solve(_x, isMeasured: true);
        _problem.Free(held, true);
        solution = _problem.Solution(_x);
        return found && Descended(out solution);
    }

    /// <summary>The slowest kick beside one that hits: that alone is measured.</summary>
    private bool Descended(out AimSolution solution)
    {
        solution = _problem.Solution(_x);
        _curve.Descend(_x, ref solution);
        return _problem.IsMeasuredHit(_x, out solution);
    }

    /// <summary>On which arc a kick that hits a target is: whether one that takes longer is slower or faster.</summary>
    public AimArc ArcOf(AimRequest request, in AimSolution hit)
    {
        Begin(request, rolls: false);
        Put(in hit.Kick, hit.Speed, hit.Time);
        return _curve.SlowsWithTime(_x) ? AimArc.Low : AimArc.High;
    }

    /// <summary>The kick that passes the point on the way, and hits the target; all but its speed is free.</summary>
    /// <returns>Whether there is one, measured.</returns>
    public bool Through(AimRequest request, in Kick near, out AimSolution solution)
    {
        // 1. From the kick nearby. 2. From scans with several spins, the closest starts first; one that ends near both points goes on to the target alone.
        _problem.Begin(request, request.Speed, through: true);
        Put(in near, request.Speed, 1);
        _problem.Approach(_x);
        if (_problem.Hit(_x, out solution))
        {
            return true;
        }

        bool passes = Near(out solution);
        _scan.Clear();
        for (int spin = 0; spin < Spins; spin++)
        {
            // Without, much of one kind, and much of both.
            double top = spin is 0 or 3 or 4 ? 0 : spin is 1 or 5 or 6 ? -0.6 : 0.6;
            double side = spin is 0 or 1 or 2 ? 0 : spin is 3 or 5 or 7 ? -0.6 : 0.6;
            _scan.Fly(ThroughRows, ThroughColumns, request.Speed, top * request.MaximumTopSpin, side * request.MaximumSideSpin);
        }

        for (int start = 0; start < _scan.Count && !_context.IsSpent; start++)
        {
            _scan.Start(start, _x);
            if (_problem.Hit(_x, out AimSolution one))
            {
                solution = one;
                return true;
            }

            if (!passes && Near(out one))
            {
                solution = one;
                passes = true;
            }
        }

        return passes;
    }

    /// <summary>
    /// Goes on to the target alone where a search ended close to both points: angles and spins that do almost the same make a valley, along which it comes closer and
    /// closer, but too slowly.
    /// </summary>
    private bool Near(out AimSolution solution)
    {
        solution = default;
        double tolerance = _problem.Request.WaypointTolerance;
        double squares = 0;
        foreach (double residual in _problem.Solver.Residuals)
        {
            squares += residual * residual;
        }

        if (!(squares < tolerance * tolerance))
        {
            return false;
        }

        _problem.AskThrough(false);
        bool hits = _problem.Hit(_x, out solution) && solution.ThroughMiss <= tolerance;
        _problem.AskThrough(true);
        return hits;
    }

    /// <summary>Makes a kick the unknowns, as far as their bounds allow.</summary>
    private void Put(in Kick kick, double speed, double time)
    {
        _x[ShootingProblem.Elevation] = _problem.Clamp(ShootingProblem.Elevation, kick.Elevation);
        _x[ShootingProblem.Azimuth] = kick.Azimuth;
        _x[ShootingProblem.LogSpeed] = Elementary.Log(speed);
        _x[ShootingProblem.Top] = _problem.IsFree(ShootingProblem.Top) ? _problem.Clamp(ShootingProblem.Top, kick.Top) : kick.Top;
        _x[ShootingProblem.Side] = _problem.IsFree(ShootingProblem.Side) ? _problem.Clamp(ShootingProblem.Side, kick.Side) : kick.Side;
        _x[ShootingProblem.LogTime] = Elementary.Log(Math.Max(time, 1e-3));
    }

    /// <summary>Asks for a kick whose speed is free.</summary>
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

    /// <summary>From the kick in closed form.</summary>
    private bool FromModel(double time, out AimSolution solution)
    {
        Model(time, _problem.Request.TopSpin, _problem.Request.SideSpin);
        return _problem.Hit(_x, out solution, isMeasured: true);
    }

    /// <summary>From the kick in closed form turned round: a steep one that backspin brings back.</summary>
    private bool FromBehind(double time, out AimSolution solution)
    {
        Model(time, _problem.Request.TopSpin, _problem.Request.SideSpin);
        _x[ShootingProblem.Azimuth] += Math.PI;
        return _problem.Hit(_x, out solution);
    }

    /// <summary>From the kicks in closed form that have a speed: that of the wanted arc, else that of the other.</summary>
    /// <param name="speed">The speed, m/s.</param>
    /// <param name="arc">The arc.</param>
    /// <param name="top">Topspin, rad/s.</param>
    /// <param name="side">Sidespin, rad/s.</param>
    /// <param name="solution">The kick.</param>
    /// <param name="isDoubtful">Whether there may be another on the wanted arc.</param>
    private bool FromModels(double speed, AimArc arc, double top, double side, ref AimSolution solution, out bool isDoubtful)
    {
        // Over the time that a kick takes the speed that it needs falls, and rises again: the low arc and the high one.
        isDoubtful = false;
        double slowest = SlowestOfModel(top, side, speed, out double least);
        if (!(least < speed))
        {
            return FromModel(slowest, speed, top, side, ref solution);
        }

        double wanted = TimeOfModel(slowest, arc == AimArc.Low, top, side, speed, null);
        double other = TimeOfModel(slowest, arc != AimArc.Low, top, side, speed, null);
        if (FromModel(wanted, speed, top, side, ref solution))
        {
            isDoubtful = Math.Abs(Elementary.Log(solution.Time / wanted)) > Math.Abs(Elementary.Log(solution.Time / other));
            return true;
        }

        return FromModel(other, speed, top, side, ref solution);
    }

    /// <summary>The time of the slowest kick in closed form, about.</summary>
    private double SlowestOfModel(double top, double side, double fastest, out double speed)
    {
        // Without air it is t² = 2 d/g; from there to the vertex of a parabola over the logarithm of the time.
        double way = _problem.Way;
        double fall = Math.Abs(_context.Upward) > 1e-3 ? Math.Sqrt(2.0 * way / Math.Abs(_context.Upward)) : double.PositiveInfinity;
        double time = Math.Min(Math.Max(fall, 1.2 * way / fastest), AimContext.LongestFlight);
        speed = 0;
        for (double width = 0.3; width > 0.1; width *= 0.5)
        {
            // A parabola through three times; where it has no least, on in the direction that falls.
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

    /// <summary>When, before or after the slowest, a kick in closed form has a speed, or an elevation.</summary>
    private double TimeOfModel(double slowest, bool isEarlier, double top, double side, double speed, double? elevation)
    {
        double near = slowest;
        double far = isEarlier ? Earliest * slowest : Math.Min(Latest * slowest, AimContext.LongestFlight);
        for (int i = 0; i < Halvings; i++)
        {
            // Bisection in the logarithm of the time: on either side of the slowest the speed changes one way.
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

    /// <summary>From scans at several speeds.</summary>
    private bool FromScans(AimRequest request, double? time, Wanted wanted, ref AimSolution solution, bool found)
    {
        double speed = request.Speed;
        for (int i = 0; i < Scans && !(found && wanted == Wanted.First); i++, speed *= SlowerScan)
        {
            _scan.Clear();
            _scan.Fly(FreeRows, FreeColumns, speed, request.TopSpin, request.SideSpin, time);
            Follow(MostFreeStarts, wanted, leavesHalf: false, ref solution, ref found);
        }

        return found;
    }

    /// <summary>Follows the starts of a scan.</summary>
    private bool Follow(int most, Wanted wanted, bool leavesHalf, ref AimSolution solution, ref bool found)
    {
        for (int start = 0; start < Math.Min(most, _scan.Count) && !(leavesHalf ? _context.IsHalfSpent : _context.IsSpent); start++)
        {
            _scan.Start(start, _x);
            if (!_problem.Hit(_x, out AimSolution one))
            {
                continue;
            }

            if (wanted == Wanted.Slowest && Descended(out AimSolution slower))
            {
                one = slower;
            }

            bool isBetter = wanted == Wanted.Slowest ? one.Speed < solution.Speed : wanted == Wanted.Latest ? one.Time > solution.Time : one.Time < solution.Time;
            solution = !found || isBetter ? one : solution;
            found = true;
            if (wanted == Wanted.First)
            {
                break;
            }
        }

        return found;
    }
}
