namespace FootballPhysics.Thesis;

/// <summary>The thesis' two-point method (4.3).</summary>
/// <remarks>
/// It rotates the velocity towards the waypoint, then scales the sidespin, then the topspin. The scale compares where flights with and without the spin cross the
/// target's plane. If a spin reaches its limit, Method A continues from there and hits the target.
/// </remarks>
internal sealed class TwoPointAim
{
    /// <summary>The initial spin, as a share of its limit, if the request gives none.</summary>
    private const double FirstSpin = 0.25;

    /// <summary>The share of the tolerance at which the search ends. Up to 40 m/s, the closest point between frames has a larger error here.</summary>
    private const double Margin = 0.5;

    /// <summary>The search stops after this many iterations that do not reduce the miss at the target to this share of the best so far.</summary>
    private const int MostIdle = 4;
    private const double Progress = 0.95;

    private readonly AimContext _context;
    private readonly FrameShooter _frames;
    private readonly AngleAim _angle;
    private readonly BisectionAim _bisection;
    private AimRequest _request = new();
    private TargetFrame _frame;
    private ElevationBounds _bounds;
    private Kick _kick;

    public TwoPointAim(AimContext context, FrameShooter frames, AngleAim angle, BisectionAim bisection)
    {
        _context = context;
        _frames = frames;
        _angle = angle;
        _bisection = bisection;
    }

    public AimSolution Find(AimRequest request)
    {
        Vector3d through = request.Waypoint.GetValueOrDefault();
        _request = request;
        _frame = _context.Frame(request);
        _bounds = ElevationBounds.Of(request);
        double throughDistance = Vector3d.Dot(through - _frame.From, in _frame.Forward);
        if (!(_frame.Distance > 1e-6 && throughDistance > 1e-6 && throughDistance < _frame.Distance))
        {
            // Without a waypoint between the ball and the target, aim at the target alone.
            AimSolution alone = _bisection.Find(request);
            alone.Reason = alone.Reason == AimReason.Hit ? AimReason.Hit : AimReason.NoOrder;
            return alone;
        }

        _kick = default;
        _kick = _frame.Turned(in _kick, through - _frame.From, in _bounds);
        bool saturated = false;
        int iterations = 0;
        int idle = 0;
        Kick best = _kick;
        double bestMiss = double.PositiveInfinity;
        double bestThroughMiss = double.PositiveInfinity;
        TurnTowardsThrough(in through);
        while (iterations < request.MaximumIterations)
        {
            iterations++;
            saturated |= !Scale(side: true, request.SideSpin, request.MaximumSideSpin);
            TurnTowardsThrough(in through);
            saturated |= !Scale(side: false, request.TopSpin, request.MaximumTopSpin);

            // One flight gives both misses, and the rotation if they are too large.
            _kick.Vectors(request.Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
            _frames.FlyThrough(in _frame.From, in velocity, in spin, in through, in _frame.Target);
            double targetMiss = _frames.Target.Miss;
            double throughMiss = _frames.Through.Miss;
            idle = targetMiss < Progress * bestMiss ? 0 : idle + 1;
            bool passes = throughMiss <= request.WaypointTolerance && targetMiss <= Margin * request.Tolerance;
            if (targetMiss < bestMiss || saturated || passes)
            {
                best = _kick;
                bestMiss = targetMiss;
                bestThroughMiss = throughMiss;
            }

            if (saturated || passes || idle == MostIdle)
            {
                break;
            }

            Turn(in through, velocity, _frames.Through);
        }

        var solution = new AimSolution
        {
            Reason = bestMiss <= request.Tolerance ? AimReason.Hit : AimReason.NoneFound,
            Kick = best,
            Forward = _frame.Forward,
            Speed = request.Speed,
            Miss = bestMiss,
            ThroughMiss = bestThroughMiss,
            Iterations = iterations,
        };
        if (bestMiss <= request.Tolerance)
        {
            return solution;
        }

        // The target has priority: use the single-target method with the current spin.
        AimSolution fallback = _angle.Refine(request, in best, Margin);
        if (fallback.Status != AimStatus.Hit)
        {
            AimSolution other = _bisection.Find(request, best.Top, best.Side);
            fallback = other.Status == AimStatus.Hit || other.Miss < fallback.Miss ? other : fallback;
        }

        fallback.ThroughMiss = bestThroughMiss;
        fallback.Iterations += iterations;
        return fallback;
    }

    /// <summary>Returns the point at which a kick crosses the vertical plane through the target, or its closest point if it does not get there.</summary>
    private Vector3d Crossing(in Kick kick)
    {
        // The thesis uses a normal towards the ball; here it points forward.
        kick.Vectors(_request.Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        _frames.FlyToPlane(in _frame.From, in velocity, in spin, in _frame.Target, in _frame.Forward);
        FrameApproach target = _frames.Target;
        return target.Crossed ? target.Crossing : target.Closest;
    }

    /// <summary>Rotates the velocity by the angle between the direction that the ball took and the waypoint.</summary>
    private void TurnTowardsThrough(in Vector3d through)
    {
        _kick.Vectors(_request.Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        _frames.Fly(in _frame.From, in velocity, in spin, in through);
        Turn(in through, velocity, _frames.Target);
    }

    /// <summary>Rotates a velocity by the angle from a flight that tracked the waypoint, and sets the angles of the kick to its direction.</summary>
    private void Turn(in Vector3d through, Vector3d direction, FrameApproach approach)
    {
        if (approach.Miss > 0.01 * _request.WaypointTolerance
            && AngleCorrection.Turn(approach.Closest - _frame.From, through - _frame.From, ref direction))
        {
            _kick = _frame.Turned(in _kick, in direction, in _bounds);
        }
    }

    /// <summary>Scales the spin to ω · d₂/d₁, signed (4.16, corrected).</summary>
    /// <remarks>d₁ is the shift of the crossing by the spin. d₂ is the distance from the crossing without the spin to the target.</remarks>
    /// <returns>False if the spin is at its limit.</returns>
    private bool Scale(bool side, double given, double limit)
    {
        if (!(limit > 0))
        {
            return false;
        }

        Kick without = _kick;
        double spin = side ? _kick.Side : _kick.Top;
        if (side)
        {
            without.Side = 0;
        }
        else
        {
            without.Top = 0;
        }

        Vector3d bare = Crossing(in without);
        Vector3d direction = side ? _frame.Left : Vector3d.Up;
        double wanted = Vector3d.Dot(_frame.Target - bare, in direction);
        if (spin == 0)
        {
            // Sidespin bends to the left, topspin downwards.
            double first = given != 0 ? Math.Abs(given) : FirstSpin * limit;
            spin = Math.Min(first, limit) * (wanted < 0 != side ? 1 : -1);
        }

        Kick with = _kick;
        Set(ref with, side, spin);
        Vector3d bent = Crossing(in with);
        double moved = Vector3d.Dot(bent - bare, in direction);
        double next = Math.Abs(moved) > 1e-9 ? spin * wanted / moved : 0;
        bool within = Math.Abs(next) < limit;
        Set(ref _kick, side, within ? next : next > 0 ? limit : -limit);
        return within;
    }

    private static void Set(ref Kick kick, bool side, double spin)
    {
        if (side)
        {
            kick.Side = spin;
        }
        else
        {
            kick.Top = spin;
        }
    }
}
