namespace FootballPhysics.Aiming;

/// <summary>The library's solver for a waypoint and a target: Newton's method in four unknowns, with limited spins.</summary>
/// <remarks>
/// If it does not converge, the target takes precedence: the kick hits the target with the spins that came closest to the waypoint.
/// </remarks>
internal sealed class DirectTwoPointAim
{
    /// <summary>The elevation below which a kick with a spin at its limit is unique, in rad.</summary>
    private const double FlatKick = 0.5;

    /// <summary>The share of its limit above which a spin counts as at the limit.</summary>
    private const double NearLimit = 1.0 - 1e-9;

    private readonly AimContext _context;
    private readonly DirectAim _direct;
    private readonly ThroughAim _general;
    private readonly PlaneProblem _problem;
    private readonly PlaneNewton _newton;

    public DirectTwoPointAim(AimContext context, DirectAim direct)
    {
        _general = new ThroughAim(context);
        _context = context;
        _direct = direct;
        _problem = new PlaneProblem(context);
        _newton = new PlaneNewton(_problem);
    }

    public AimSolution Find(AimRequest request)
    {
        // Ignore a waypoint that is not between ball and target, unless wind, a slope or a custom force may carry the ball past it.
        if (!_problem.SetThrough(request))
        {
            AimSolution alone = _direct.Find(request);
            alone.ThroughMiss = double.NaN;
            return !_context.IsEvenAround && _general.Find(request, in alone.Kick, out AimSolution turned) ? turned : alone;
        }

        AimSolution solution = Newton();
        if (Suffices(in solution))
        {
            return solution;
        }

        // The kick may be too far from the closed-form guess: use the general search.
        return _general.Find(request, in solution.Kick, out AimSolution other) ? other : solution.Status == AimStatus.Hit ? solution : TargetFirst(in solution);
    }

    private bool Suffices(in AimSolution solution) =>
        (Passes(in solution) && !_context.Steps.AreShort) || (solution.Status == AimStatus.Hit && IsOnlyOne(in solution.Kick));

    private bool Passes(in AimSolution solution) =>
        solution.Status == AimStatus.Hit && solution.ThroughMiss <= _problem.Request.WaypointTolerance;

    /// <summary>True if no other kick passes the waypoint more closely: in still air over level ground, for a flat kick with a spin at its limit.</summary>
    private bool IsOnlyOne(in Kick kick)
    {
        AimRequest request = _problem.Request;
        return kick.Elevation < FlatKick && _context.IsEvenAround && !_context.IsRuledByAir(request.Speed, kick.SpinRate)
            && (Math.Abs(kick.Top) >= request.MaximumTopSpin * NearLimit || Math.Abs(kick.Side) >= request.MaximumSideSpin * NearLimit);
    }

    /// <summary>Finds a kick for the target only, with the spins that came closest to both points or, if that fails, with the maximum lift.</summary>
    private AimSolution TargetFirst(in AimSolution nearest)
    {
        AimRequest request = _problem.Request;
        AimSolution single = _direct.Find(request, request.Speed, request.Arc, nearest.Kick.Top, nearest.Kick.Side);
        single.ThroughMiss = ThroughMissOf(in single.Kick);
        if (single.Status != AimStatus.Hit)
        {
            // These spins may bring the ball down too early, so try the maximum lift.
            AimSolution lifted = _direct.Find(request, request.Speed, request.Arc, -request.MaximumTopSpin, 0);
            if (lifted.Status == AimStatus.Hit || lifted.Miss < single.Miss)
            {
                lifted.ThroughMiss = ThroughMissOf(in lifted.Kick);
                return lifted;
            }
        }

        return single;
    }

    /// <summary>Simulates a kick, and returns its miss at the waypoint, in m.</summary>
    private double ThroughMissOf(in Kick kick)
    {
        _problem.SetThrough(_problem.Request);
        double[] x = _newton.X;
        (x[PlaneProblem.Elevation], x[PlaneProblem.Azimuth], x[PlaneProblem.Top], x[PlaneProblem.Side]) = (kick.Elevation, kick.Azimuth, kick.Top, kick.Side);
        return _problem.Fly(x, _newton.R, false) ? PlaneProblem.ThroughMissOf(_newton.R) : double.NaN;
    }

    /// <summary>Finds the kick by Newton's method.</summary>
    private AimSolution Newton()
    {
        bool hits = _newton.Solve() && _problem.StaysClear(_newton.X, _newton.R);
        return new AimSolution
        {
            Reason = hits ? AimReason.Hit : AimReason.NoneFound,
            Kick = _problem.KickOf(_newton.X),
            Forward = _problem.Frame.Forward,
            Speed = _problem.Speed,
            Miss = _newton.Miss,
            ThroughMiss = _newton.ThroughMiss,
            Time = _newton.Time,
        };
    }
}
