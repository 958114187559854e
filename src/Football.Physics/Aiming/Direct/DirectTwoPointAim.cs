namespace FootballPhysics.Aiming;

/// <summary>
/// The library's own solver for a point on the way and a target: Newton's method in four unknowns, spins within their limits. Where it does not converge, the target comes
/// first: it is hit with the spins that came nearest.
/// </summary>
internal sealed class DirectTwoPointAim
{
    /// <summary>Below this elevation, rad, a kick whose spin is at its limit is the only one.</summary>
    private const double FlatKick = 0.5;

    /// <summary>A spin of this share of its limit is at it.</summary>
    private const double NearLimit = 1.0 - 1e-9;

    private readonly AimContext _context;
    private readonly DirectAim _direct;
    private readonly GeneralAim _general;
    private readonly PlaneProblem _problem;
    private readonly PlaneNewton _newton;

    public DirectTwoPointAim(AimContext context, DirectAim direct, GeneralAim general)
    {
        _general = general;
        _context = context;
        _direct = direct;
        _problem = new PlaneProblem(context);
        _newton = new PlaneNewton(_problem);
    }

    public AimSolution Find(AimRequest request)
    {
        // A point that is not on the way to the target is left out, but in a wind, which may carry the ball by it.
        if (!_problem.SetThrough(request))
        {
            AimSolution alone = _direct.Find(request);
            alone.ThroughMiss = double.NaN;
            return !_context.Scene.Air.IsStill && _general.Through(request, in alone.Kick, out AimSolution turned) ? turned : alone;
        }

        AimSolution solution = Newton();
        if (Suffices(in solution))
        {
            return solution;
        }

        // From elsewhere there may be one that the closed form is too far from.
        return _general.Through(request, in solution.Kick, out AimSolution other) ? other : solution.Status == AimStatus.Hit ? solution : TargetFirst(in solution);
    }

    private bool Suffices(in AimSolution solution) =>
        (Passes(in solution) && !_context.Steps.AreShort) || (solution.Status == AimStatus.Hit && IsOnlyOne(in solution.Kick));

    private bool Passes(in AimSolution solution) =>
        solution.Status == AimStatus.Hit && solution.ThroughMiss <= _problem.Request.WaypointTolerance;

    /// <summary>In still air, where the spin of a flat kick is at its limit, no other passes the point more closely.</summary>
    private bool IsOnlyOne(in Kick kick)
    {
        AimRequest request = _problem.Request;
        return kick.Elevation < FlatKick && _context.Scene.Air.IsStill && !_context.IsRuledByAir(request.Speed, kick.SpinRate)
            && (Math.Abs(kick.Top) >= request.MaximumTopSpin * NearLimit || Math.Abs(kick.Side) >= request.MaximumSideSpin * NearLimit);
    }

    /// <summary>The target alone, with the spins that came nearest to both, or else with as much lift as is allowed.</summary>
    private AimSolution TargetFirst(in AimSolution nearest)
    {
        AimRequest request = _problem.Request;
        AimSolution single = _direct.Find(request, request.Speed, request.Arc, nearest.Kick.Top, nearest.Kick.Side);
        single.ThroughMiss = ThroughMissOf(in single.Kick);
        if (single.Status != AimStatus.Hit)
        {
            // Those spins may bring it down too early: once more with all the lift that is allowed.
            AimSolution lifted = _direct.Find(request, request.Speed, request.Arc, -request.MaximumTopSpin, 0);
            if (lifted.Status == AimStatus.Hit || lifted.Miss < single.Miss)
            {
                lifted.ThroughMiss = ThroughMissOf(in lifted.Kick);
                return lifted;
            }
        }

        return single;
    }

    /// <summary>By what a kick for the target alone misses the point on the way, m: it is flown to tell.</summary>
    private double ThroughMissOf(in Kick kick)
    {
        _problem.SetThrough(_problem.Request);
        double[] x = _newton.X;
        (x[PlaneProblem.Elevation], x[PlaneProblem.Azimuth], x[PlaneProblem.Top], x[PlaneProblem.Side]) = (kick.Elevation, kick.Azimuth, kick.Top, kick.Side);
        return _problem.Fly(x, _newton.R, false) ? PlaneProblem.ThroughMissOf(_newton.R) : double.NaN;
    }

    /// <summary>The kick by Newton's method.</summary>
    private AimSolution Newton()
    {
        bool hits = _newton.Solve() && _problem.StaysClear(_newton.X, _newton.R);
        return new AimSolution
        {
            Status = hits ? AimStatus.Hit : AimStatus.NotConverged,
            Kick = _problem.KickOf(_newton.X),
            Forward = _problem.Frame.Forward,
            Speed = _problem.Speed,
            Miss = _newton.Miss,
            ThroughMiss = _newton.ThroughMiss,
            Time = _newton.Time,
        };
    }
}
