using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>Finds the kick that hits a target, optionally past a waypoint.</summary>
/// <remarks>Create one per scene and reuse it: searches do not allocate. Not thread-safe.</remarks>
public sealed partial class Aimer
{
    /// <summary>The miss, in m, below which the long steps may have overlooked a hit.</summary>
    private const double NearMiss = 0.05;

    /// <summary>The relative error of a miss that was computed in long steps.</summary>
    private const double Astray = 0.01;

    /// <summary>The maximum time, in s, by which a ball may touch the ground before it is due at its target.</summary>
    private const double LargestDelay = 1e-4;

    /// <summary>The number of spins tried on each side of the requested spin, along each axis.</summary>
    private const int SpinRings = 4;

    /// <summary>The elevation below which a kick that does not descend to its target is on the low arc, in rad.</summary>
    private const double FlatKick = 0.5;

    private readonly AimContext _context;
    private readonly DirectAim _direct;
    private readonly DirectTwoPointAim _directTwoPoint;
    private readonly GeneralAim _general;

    /// <summary>Compiles a scene for aiming.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public Aimer(Scene? scene = null)
        : this(new Simulator(scene))
    {
    }

    /// <summary>Creates an aimer for a compiled scene.</summary>
    /// <param name="simulator">The scene; searches use RK4, independent of its settings.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    public Aimer(Simulator simulator)
    {
        _context = new AimContext(simulator ?? throw new ArgumentNullException(nameof(simulator)));
        _general = new GeneralAim(_context);
        _direct = new DirectAim(_context, _general);
        _directTwoPoint = new DirectTwoPointAim(_context, _direct);
    }

    /// <summary>Finds a kick.</summary>
    /// <param name="request">The request.</param>
    /// <param name="measure">True to measure the miss of the kick; false to return the solver's own estimate.</param>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names the field, the value and the range.</exception>
    public AimResult Find(AimRequest request, bool measure = true)
    {
        // 1. Search with long steps, and measure the miss. 2. If search and measurement disagree, repeat with short steps. 3. If the kick is blocked,
        // try the other arc and, if the spin is free, other spins.
        Begin(request);
        AimSolution solution = Search(request);
        AimResult result = Report(request, in solution, measure);

        // The flight differs from the search and no obstacle explains the difference: the long steps were too inaccurate.
        bool blocked = result.Status == AimStatus.Blocked;
        bool astray = result.Miss > ((1.0 + Astray) * solution.Miss) + (Astray * NearMiss);
        if (!result.HitsTarget && !blocked && (solution.Status == AimStatus.Hit || solution.Miss < NearMiss || astray))
        {
            // A kick that grazes the jump in the drag law takes a different path with finer steps: search again with short steps.
            _context.Steps = AimSteps.Short;
            AimSolution fine = Search(request);
            AimResult finer = Report(request, in fine, measure);
            _context.Steps = AimSteps.Long;
            result = finer.HitsTarget || !(result.Miss < finer.Miss) ? finer : Report(request, in solution, measure);
        }

        return result.Status == AimStatus.Blocked && request.Waypoint is null ? Around(request, in result, measure) : result;
    }

    /// <summary>Finds the slowest kick that hits a target.</summary>
    /// <param name="request">The request, without a waypoint; its speed is the maximum allowed.</param>
    /// <returns>The kick; its velocity contains its speed. Out of reach if a bound excludes every kick up to that speed.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or the request has a waypoint.</exception>
    public AimResult FindSlowest(AimRequest request)
    {
        // Search with long steps, then with short ones. If neither finds a kick, the fastest kick determines the status.
        Begin(request);
        RefuseThrough(request);
        if (!Slowest(request, out AimSolution solution))
        {
            _context.Steps = AimSteps.Short;
            if (!Slowest(request, out solution))
            {
                // The flights of one speed do not exclude slower kicks: with a lower bound on the elevation, the fastest one may fly over the target.
                _context.Steps = AimSteps.Long;
                solution = _direct.Find(request);
                solution.Reason = solution.Reason == AimReason.BetweenBounds ? AimReason.NoneFound : solution.Reason;
            }

            _context.Steps = AimSteps.Long;
        }

        return Report(request, in solution, measure: true);
    }

    /// <summary>Finds the kick that reaches a target at a given time.</summary>
    /// <param name="request">The request, without a waypoint; its speed is the maximum allowed.</param>
    /// <param name="time">The time of arrival, in s after the kick; above 0, at most 30.</param>
    /// <returns>The kick; its velocity contains its speed. Out of reach if the target is farther or higher than any kick can be at this time.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="request"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range, or the request has a waypoint.</exception>
    public AimResult FindAtTime(AimRequest request, double time)
    {
        Begin(request);
        RefuseThrough(request);
        Check.Within(nameof(time), time, 0, AimContext.LongestFlight, exclusiveLow: true);
        AimResult result = AtTime(request, time);
        if (result.Status == AimStatus.NotConverged && !_context.IsSpent)
        {
            // A kick that grazes the jump in the drag law requires short steps: search again.
            _context.Steps = AimSteps.Short;
            result = AtTime(request, time);
            _context.Steps = AimSteps.Long;
        }

        return result;
    }

    /// <summary>Runs every kind of search once, so that the code is compiled before your game needs it.</summary>
    /// <exception cref="InvalidOperationException">A custom force is not finite.</exception>
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

        // One request per code path: low, high, too slow, waypoint, along the ground, slowest, fixed arrival time.
        AimResult high = Find(request with { Arc = AimArc.High });
        Find(request with { Speed = 8 });
        Find(request with { Waypoint = new Vector3d(1, contact + 2, -9) });
        Find(request with { Target = new Vector3d(0, contact, -15), MaximumElevationDegrees = 0 });
        FindSlowest(request);
        FindAtTime(request, high.Time);
    }

    /// <summary>Searches for an unblocked kick on the other arc and, if the spin is free, with other spins on both arcs, nearest first.</summary>
    private AimResult Around(AimRequest request, in AimResult blocked, bool measure)
    {
        // Try the other arc with the requested spin first. Then try rings of spins around that spin, nearest first, on both arcs.
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
        // Search for the slowest flight, and for a roll, which may be even slower.
        bool flies = _general.Slowest(request, out solution);
        if (_context.Shooting.CanRoll(request) && _direct.SlowestRoll(request, flies ? solution.Speed : request.Speed, out AimSolution roll))
        {
            solution = roll;
            return true;
        }

        return flies;
    }

    private AimSolution Search(AimRequest request)
    {
        if (request.Waypoint is null)
        {
            return _direct.Find(request);
        }

        // The spins are free, so a bound for the spins of one search says nothing about the others.
        AimSolution solution = _directTwoPoint.Find(request);
        solution.Reason = solution.Status == AimStatus.OutOfReach ? new EnergyBound(_context, request).Reason : solution.Reason;
        return solution;
    }

    private AimResult With(AimRequest request, AimArc arc, double top, double side, bool measure)
    {
        AimSolution solution = _direct.Find(request, request.Speed, arc, top, side);
        return Report(request, in solution, measure);
    }

    /// <summary>Returns a point on a square ring of spins around the requested spin, clamped to the allowed range.</summary>
    private static void SpinOnRing(AimRequest request, int ring, int place, out double top, out double side)
    {
        // Start with sidespin, because sidespin usually bends a kick around an obstacle. Ring n has 8 n points, on four edges.
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
            // The kick is within tolerance but arrives too early: solve again for a closer kick, which arrives on time.
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
            solution.Reason = new EnergyBound(_context, request).ReasonAt(time);
        }

        solution.Vectors(out Vector3d velocity, out Vector3d spin);
        bool there = IsThere(request, in velocity, in spin, time, out MeasuredMiss measured, out isEarly);
        AimReason reason = there ? AimReason.Hit : Missed(in solution, in measured);
        return Result(request, isEarly && reason == AimReason.Deviates ? AimReason.TooEarly : reason, in solution, in velocity, in spin, in measured);
    }

    /// <summary>True if a kick hits the target at a given time. A kick that passes the target at a different time is not a hit.</summary>
    private bool IsThere(AimRequest request, in Vector3d velocity, in Vector3d spin, double time, out MeasuredMiss measured, out bool isEarly)
    {
        measured = _context.Miss.Measure(request, in velocity, in spin, time);
        isEarly = measured.Distance <= request.Tolerance && !(time - measured.Time <= LargestDelay);
        return measured.Distance <= request.Tolerance && !isEarly;
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

    /// <summary>Validates a request, and begins the search.</summary>
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

    /// <summary>Measures a kick, and determines its status.</summary>
    /// <param name="request">The request.</param>
    /// <param name="solution">The kick.</param>
    /// <param name="measure">True to measure the kick even if its estimate would suffice.</param>
    /// <param name="passes">True if the kick must pass the waypoint.</param>
    internal AimResult Report(AimRequest request, in AimSolution solution, bool measure, bool passes)
    {
        solution.Vectors(out Vector3d velocity, out Vector3d spin);

        // If no obstacle can block the kick, use the solver's own estimate.
        if (!measure && !_context.MayBlock && solution.Miss < double.PositiveInfinity)
        {
            double? throughMiss = request.Waypoint is null ? null : solution.ThroughMiss;
            var estimated = new MeasuredMiss(solution.Miss, throughMiss, solution.Time, request.Target);
            return Result(request, Judge(request, solution.Reason, in estimated, passes), in solution, in velocity, in spin, in estimated);
        }

        MeasuredMiss measured = _context.Miss.Measure(request, in velocity, in spin);

        // The measured miss alone decides whether the kick hits. The method's reason only explains a miss.
        AimReason reason = _context.Frame(request).IsDegenerate ? AimReason.NoDirection
            : measured.Distance <= request.Tolerance ? Judge(request, AimReason.Hit, in measured, passes)
            : Missed(in solution, in measured);
        return Result(request, reason, in solution, in velocity, in spin, in measured);
    }

    /// <summary>Returns the reason for a kick whose measured flight misses: an expected hit is either blocked by an object, or deviates.</summary>
    private static AimReason Missed(in AimSolution solution, in MeasuredMiss measured) =>
        solution.Reason != AimReason.Hit ? solution.Reason : measured.Blocker == MeasuredFlight.NoThing ? AimReason.Deviates : AimReason.InTheWay;

    /// <summary>Downgrades a hit that misses the waypoint.</summary>
    private static AimReason Judge(AimRequest request, AimReason reason, in MeasuredMiss measured, bool passes) =>
        reason == AimReason.Hit && passes && !(measured.ThroughDistance <= request.WaypointTolerance) ? AimReason.PastWaypoint : reason;

    private AimResult Result(
        AimRequest request, AimReason reason, in AimSolution solution, in Vector3d velocity, in Vector3d spin, in MeasuredMiss measured)
    {
        // The thesis' methods count their own iterations. Save the counters now, because later flights are not part of the search.
        reason = reason == AimReason.NoneFound && _context.IsSpent ? AimReason.Spent : reason;
        int iterations = solution.Iterations > 0 ? solution.Iterations : _context.Iterations;
        int simulations = _context.Simulations;

        // Rolls, misses, and flat kicks at a target of at least the same height count as the low arc. Otherwise, the sign of d speed/d time determines the arc.
        TargetFrame frame = _context.Frame(request);
        bool rolls = _context.StaysDown(in frame.From, in velocity);
        bool hits = reason is AimReason.Hit or AimReason.PastWaypoint;
        bool flat = rolls || (solution.Kick.Elevation < FlatKick && frame.Target.Y >= frame.From.Y);
        AimArc arc = solution.Arc ?? (flat || !hits ? AimArc.Low : _general.ArcOf(request, in solution));
        string? blocker = reason == AimReason.InTheWay ? _context.Miss.NameOf(measured.Blocker) : null;
        return new AimResult(reason, in velocity, in spin, in measured, arc, rolls, iterations, simulations, blocker);
    }
}
