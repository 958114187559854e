namespace FootballPhysics.Aiming;

/// <summary>Finds kicks: which one, at this speed and spin, hits that point; which one passes a wall here and lands there.</summary>
/// <remarks>Made once for a scene and used again; a search allocates nothing. Not for several threads at once.</remarks>
public sealed partial class Aimer
{
    /// <summary>A miss that longer steps may have made of a hit, m.</summary>
    private const double NearMiss = 0.05;

    /// <summary>Share of a miss by which long steps may be wrong about it.</summary>
    private const double Astray = 0.01;

    /// <summary>How much earlier than asked a ball may touch the ground at its target, s.</summary>
    private const double LargestDelay = 1e-4;

    /// <summary>How many spins are tried on each side of the one that was asked for, along each axis.</summary>
    private const int SpinRings = 4;

    /// <summary>Below this elevation, rad, a kick that does not descend to its target is on the low arc.</summary>
    private const double FlatKick = 0.5;

    private readonly AimContext _context;
    private readonly DirectAim _direct;
    private readonly DirectTwoPointAim _directTwoPoint;
    private readonly GeneralAim _general;

    /// <summary>Compiles a scene for aiming.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public Aimer(Scene? scene = null)
        : this(new Simulator(scene))
    {
    }

    /// <summary>For the balls of a compiled scene.</summary>
    /// <param name="simulator">The scene; whatever its settings, kicks are sought with RK4.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public Aimer(Simulator simulator)
    {
        _context = new AimContext(simulator ?? throw new ArgumentNullException(nameof(simulator)));
        _general = new GeneralAim(_context);
        _direct = new DirectAim(_context, _general);
        _directTwoPoint = new DirectTwoPointAim(_context, _direct, _general);
    }

    /// <summary>Finds a kick.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="measure">Whether to measure the miss of the kick that was found; without it the result has the solver's own estimate.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public AimResult Find(AimRequest request, bool measure = true)
    {
        // 1. The search in long steps, and the true miss of what it found. 2. Where that is not what the search said, once more in short steps. 3. What is blocked: the
        // other arc, and other spins where they are free.
        Begin(request);
        AimSolution solution = Search(request);
        AimResult result = Report(request, in solution, measure);

        // Where the flight is not what the search said, and nothing in its way explains that, its long steps were at fault.
        bool blocked = result.Status == AimStatus.Blocked;
        bool astray = result.Miss > ((1.0 + Astray) * solution.Miss) + (Astray * NearMiss);
        if (!result.HitsTarget && !blocked && (solution.Status == AimStatus.Hit || solution.Miss < NearMiss || astray))
        {
            // A kick that grazes the drag law's jump goes elsewhere in finer steps: once more in those.
            _context.Steps = AimSteps.Short;
            AimSolution fine = Search(request);
            AimResult finer = Report(request, in fine, measure);
            _context.Steps = AimSteps.Long;
            result = finer.HitsTarget || !(result.Miss < finer.Miss) ? finer : Report(request, in solution, measure);
        }

        return result.Status == AimStatus.Blocked && request.Waypoint is null ? Around(request, in result, measure) : result;
    }

    /// <summary>Finds the slowest kick that hits a target.</summary>
    /// <param name="request">What the kick is to do; its speed is the fastest allowed. Without a point on the way.</param>
    /// <returns>The kick, with its speed in its velocity; out of reach where even the fastest one does not get there.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or a point on the way is given.</exception>
    public AimResult FindSlowest(AimRequest request)
    {
        // In long steps, in short ones, and where there is none, what the fastest does is the verdict.
        Begin(request);
        RefuseThrough(request);
        if (!Slowest(request, out AimSolution solution))
        {
            _context.Steps = AimSteps.Short;
            if (!Slowest(request, out solution))
            {
                _context.Steps = AimSteps.Long;
                solution = _direct.Find(request);
            }

            _context.Steps = AimSteps.Long;
        }

        return Report(request, in solution, measure: true);
    }

    /// <summary>Finds the kick that is at a target at a given time.</summary>
    /// <param name="request">What the kick is to do; its speed is the fastest allowed. Without a point on the way.</param>
    /// <param name="time">When to be there, s after the kick; above 0, at most 30.</param>
    /// <returns>The kick, with its speed in its velocity; out of reach where no speed up to the fastest gets there then.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or a point on the way is given.</exception>
    public AimResult FindAtTime(AimRequest request, double time)
    {
        Begin(request);
        RefuseThrough(request);
        Check.Within(nameof(time), time, 0, AimContext.LongestFlight, exclusiveLow: true);
        AimResult result = AtTime(request, time);
        if (result.Status == AimStatus.NotConverged && !_context.IsSpent)
        {
            // It grazes the drag law's jump: once more in finer steps.
            _context.Steps = AimSteps.Short;
            result = AtTime(request, time);
            _context.Steps = AimSteps.Long;
        }

        return result;
    }

    /// <summary>Finds kicks of every kind that nobody plays, so that no frame of a game has to compile the code of a search.</summary>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite.</exception>
    public void WarmUp()
    {
        Vector3d from = _context.Game.OnGround(0, 0);
        double contact = from.Y;
        var request = new AimRequest
        {
            From = from,
            Target = new Vector3d(1, contact + 1, -18),
            TopSpin = -10,
            SideSpin = 20,
            MaximumElevationDegrees = 80,
        };
        Find(request);

        // One request for each road of the search: low, high, too slow, through a point, along the ground, slowest, at a time.
        AimResult high = Find(request with { Arc = AimArc.High });
        Find(request with { Speed = 8 });
        Find(request with { Waypoint = new Vector3d(1, contact + 2, -9) });
        Find(request with { Target = new Vector3d(0, contact, -15), MaximumElevationDegrees = 0 });
        FindSlowest(request);
        FindAtTime(request, high.Time);
    }

    /// <summary>The other arc, and where the spin may be chosen other spins on both, nearest first: what is a hit there is not blocked.</summary>
    private AimResult Around(AimRequest request, in AimResult blocked, bool measure)
    {
        // With its own spin on the other arc first; then rings of spins about its own, from the nearest on, on both arcs.
        AimArc other = request.Arc == AimArc.Low ? AimArc.High : AimArc.Low;
        AimResult found = With(request, other, request.TopSpin, request.SideSpin, measure);
        for (int ring = 1; ring <= SpinRings && request.SpinIsFree && !found.HitsTarget; ring++)
        {
            for (int place = 0; place < 16 * ring && !found.HitsTarget; place++)
            {
                SpinOnRing(request, ring, place / 2, out double top, out double side);
                found = With(request, place % 2 == 0 ? request.Arc : other, top, side, measure);
            }
        }

        return found.HitsTarget ? found : blocked;
    }

    private bool Slowest(AimRequest request, out AimSolution solution)
    {
        // In the air, and along the ground where that is slower still.
        bool flies = _general.Slowest(request, out solution);
        if (_context.Shooting.CanRoll(request) && _direct.SlowestRoll(request, flies ? solution.Speed : request.Speed, out AimSolution roll))
        {
            solution = roll;
            return true;
        }

        return flies;
    }

    private AimSolution Search(AimRequest request) => request.Waypoint is null ? _direct.Find(request) : _directTwoPoint.Find(request);

    private AimResult With(AimRequest request, AimArc arc, double top, double side, bool measure)
    {
        AimSolution solution = _direct.Find(request, request.Speed, arc, top, side);
        return Report(request, in solution, measure);
    }

    /// <summary>A place on the square ring of that size about the spin that was asked for, corner included; within what is allowed.</summary>
    private static void SpinOnRing(AimRequest request, int ring, int place, out double top, out double side)
    {
        // Sidespin first: it is what mostly goes round.
        // A square ring of 8 n places, by its four edges.
        int along = (place % (2 * ring)) - ring;
        int edge = place / (2 * ring);
        int x = edge switch { 0 => ring, 1 => -ring, 2 => -along, _ => along };
        int y = edge switch { 0 => along, 1 => -along, 2 => ring, _ => -ring };
        side = Within(request.SideSpin + (request.MaximumSideSpin * x / SpinRings), request.MaximumSideSpin);
        top = Within(request.TopSpin + (request.MaximumTopSpin * y / SpinRings), request.MaximumTopSpin);
    }

    private static double Within(double spin, double most) => Math.Min(Math.Max(spin, -most), most);

    private AimResult AtTime(AimRequest request, double time)
    {
        AimResult result = AtTime(request, time, out bool isEarly);
        if (isEarly)
        {
            // Within the tolerance, but the ball comes down before it is due: a closer kick does not.
            _general.IsTimely = true;
            result = AtTime(request, time, out _);
            _general.IsTimely = false;
        }

        return result;
    }

    private AimResult AtTime(AimRequest request, double time, out bool isEarly)
    {
        if (!_general.AtTime(request, time, out AimSolution solution))
        {
            // Why there is none: the search ran out of flights, or has seen all there is.
            solution.Status = _context.IsSpent ? AimStatus.NotConverged : AimStatus.OutOfReach;
        }

        // A kick that passes the target at another time is no hit.
        solution.Vectors(out Vector3d velocity, out Vector3d spin);
        MeasuredMiss measured = _context.Miss.Measure(request, in velocity, in spin, time);
        isEarly = measured.Distance <= request.Tolerance && !(time - measured.Time <= LargestDelay);
        bool there = measured.Distance <= request.Tolerance && !isEarly;
        AimStatus status = there ? AimStatus.Hit : Missed(in solution, in measured);
        return Result(request, status, in solution, in velocity, in spin, in measured);
    }

    private static void RefuseThrough(AimRequest request)
    {
        if (request.Waypoint is not null)
        {
            throw Check.Conflict("aim.waypoint", "aim.waypoint cannot be combined with a search for the speed. Leave it unset.");
        }
    }

    /// <summary>The compiled scenes and flights of the search.</summary>
    internal AimContext Context => _context;

    /// <summary>Checks a request before anything is done for it.</summary>
    internal void Begin(AimRequest request)
    {
        if (request is null)
        {
            throw new ArgumentNullException(nameof(request));
        }

        request.Validate();
        _context.Begin(request.MaximumIterations);
    }

    private AimResult Report(AimRequest request, in AimSolution solution, bool measure) => Report(request, in solution, measure, request.Waypoint is not null);

    /// <summary>Measures a kick that was found, and says what it is.</summary>
    /// <param name="request">What it is to do.</param>
    /// <param name="solution">The kick.</param>
    /// <param name="measure">Whether to measure it, where its estimate could be taken instead.</param>
    /// <param name="passes">Whether it was to pass the point on the way.</param>
    internal AimResult Report(AimRequest request, in AimSolution solution, bool measure, bool passes)
    {
        solution.Vectors(out Vector3d velocity, out Vector3d spin);

        // The solver's own estimate, where nothing can be in the way.
        if (!measure && !_context.HasThings && solution.Miss < double.PositiveInfinity)
        {
            double? throughMiss = request.Waypoint is null ? null : solution.ThroughMiss;
            var estimated = new MeasuredMiss(solution.Miss, throughMiss, solution.Time, request.Target);
            return Result(request, Judge(request, solution.Status, in estimated, passes), in solution, in velocity, in spin, in estimated);
        }

        MeasuredMiss measured = _context.Miss.Measure(request, in velocity, in spin);

        // The measured miss decides; a method may only say why there is none.
        AimStatus status = _context.Frame(request).IsDegenerate ? AimStatus.Degenerate
            : measured.Distance <= request.Tolerance ? Judge(request, AimStatus.Hit, in measured, passes)
            : Missed(in solution, in measured);
        return Result(request, status, in solution, in velocity, in spin, in measured);
    }

    /// <summary>The status of a kick whose measured flight misses: a supposed hit needs finer steps, or something is in the way.</summary>
    private static AimStatus Missed(in AimSolution solution, in MeasuredMiss measured) =>
        solution.Status != AimStatus.Hit ? solution.Status : measured.Blocker == MeasuredFlight.NoThing ? AimStatus.NotConverged : AimStatus.Blocked;

    /// <summary>A hit that misses the point on the way is one of the target only.</summary>
    private static AimStatus Judge(AimRequest request, AimStatus status, in MeasuredMiss measured, bool passes) =>
        status == AimStatus.Hit && passes && !(measured.ThroughDistance <= request.WaypointTolerance) ? AimStatus.WaypointMissed : status;

    private AimResult Result(
        AimRequest request, AimStatus status, in AimSolution solution, in Vector3d velocity, in Vector3d spin, in MeasuredMiss measured)
    {
        // The thesis' methods have iterations of their own; what is looked at from here on is no part of the search.
        int iterations = solution.Iterations > 0 ? solution.Iterations : _context.Iterations;
        int simulations = _context.Simulations;

        // The arc: low for a roll, a flat kick to a target no lower, and what does not hit; else the slope of the speed over the time tells.
        TargetFrame frame = _context.Frame(request);
        bool rolls = _context.StaysDown(in frame.From, velocity.Y);
        bool hits = status is AimStatus.Hit or AimStatus.WaypointMissed;
        bool flat = rolls || (solution.Kick.Elevation < FlatKick && frame.Target.Y >= frame.From.Y);
        AimArc arc = solution.Arc ?? (flat || !hits ? AimArc.Low : _general.ArcOf(request, in solution));
        string? blocker = status == AimStatus.Blocked ? _context.Miss.NameOf(measured.Blocker) : null;
        return new AimResult(status, in velocity, in spin, in measured, arc, rolls, iterations, simulations, blocker);
    }
}
