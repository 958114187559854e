namespace FootballPhysics.Thesis;

/// <summary>
/// The thesis' two-point method (4.3): the velocity is turned towards the point on the way, then the side spin, then the top spin is
/// scaled by how far the flight without and the flight with it pass the target's plane. Spins at their limit end it, and Method A
/// then hits the target from there.
/// </summary>
internal sealed class TwoPointAim
{
    /// <summary>The share of the limit that a spin starts with where none is given.</summary>
    private const double FirstSpin = 0.25;

    /// <summary>It ends this far inside the tolerance: up to 40 m/s the closest point between frames is further off the true one.</summary>
    private const double Margin = 0.5;

    /// <summary>It goes round in circles where so many iterations do not shrink the miss at the target to this share of the least so far.</summary>
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
            // No point between the ball and the target: the target alone.
            AimSolution alone = _bisection.Find(request);
            alone.Status = alone.Status == AimStatus.Hit ? AimStatus.Hit : AimStatus.Degenerate;
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

            // One flight tells both misses, and where to turn if they are too large.
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

            Turn(in through, _frames.Through);
        }

        var solution = new AimSolution
        {
            Status = bestMiss <= request.Tolerance ? AimStatus.Hit : AimStatus.NotConverged,
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

        // The target first: the single-target method with the spin as it is.
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

    /// <summary>Where a kick crosses the vertical plane through the target, or where it is closest if it does not get there.</summary>
    private Vector3d Crossing(in Kick kick)
    {
        // The plane's normal, towards the ball in the thesis, is turned forward here.
        kick.Vectors(_request.Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        _frames.FlyToPlane(in _frame.From, in velocity, in spin, in _frame.Target, in _frame.Forward);
        FrameApproach target = _frames.Target;
        return target.Crossed ? target.Crossing : target.Closest;
    }

    /// <summary>Turns the velocity by the angle between where the ball went and the point on the way.</summary>
    private void TurnTowardsThrough(in Vector3d through)
    {
        _kick.Vectors(_request.Speed, in _frame.Forward, out Vector3d velocity, out Vector3d spin);
        _frames.Fly(in _frame.From, in velocity, in spin, in through);
        Turn(in through, _frames.Target);
    }

    /// <summary>The turn itself, from a flight that watched the point on the way.</summary>
    private void Turn(in Vector3d through, FrameApproach approach)
    {
        _kick.Vectors(1.0, in _frame.Forward, out Vector3d direction, out _);
        if (approach.Miss > 0.01 * _request.WaypointTolerance
            && AngleCorrection.Turn(approach.Closest - _frame.From, through - _frame.From, ref direction))
        {
            _kick = _frame.Turned(in _kick, in direction, in _bounds);
        }
    }

    /// <summary>The new spin is ω · d₂/d₁, signed: d₁ from the crossing without the spin to the one with it, d₂ from there to the target (4.16, the right way up).</summary>
    /// <returns>False where the spin is at its limit.</returns>
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
            // Side spin bends to the left, top spin down.
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
