namespace FootballPhysics.Aiming;

/// <summary>The general search for a kick that passes a waypoint: from a nearby kick, then from scans with several spins.</summary>
internal sealed class ThroughAim(AimContext context)
{
    /// <summary>The number of elevations, azimuths and spins in the scans for a kick with a waypoint.</summary>
    private const int ThroughRows = 5;
    private const int ThroughColumns = 6;
    private const int Spins = 9;

    private readonly AimContext _context = context;
    private readonly ShootingProblem _problem = context.Shooting;
    private readonly DirectionScan _scan = new(context.Shooting);
    private readonly double[] _x = new double[ShootingProblem.Most];

    /// <summary>Finds the kick that passes the waypoint and hits the target; everything except its speed is free.</summary>
    /// <returns>True if a kick was found and confirmed by measurement.</returns>
    public bool Find(AimRequest request, in Kick near, out AimSolution solution)
    {
        // 1. Start from the nearby kick. 2. Start from scans with several spins, closest first. If a search ends near both points, continue with the
        // target only.
        _problem.Begin(request, request.Speed, through: true);
        GeneralAim.Put(_problem, _x, in near, request.Speed, 1);
        _problem.Approach(_x);
        if (_problem.Hit(_x, out solution))
        {
            return true;
        }

        bool passes = Near(out solution);
        _scan.Clear();
        for (int spin = 0; spin < Spins; spin++)
        {
            // Try no spin, strong spin about one axis, and strong spin about both axes.
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

    /// <summary>Continues with the target only if a search ended close to both points.</summary>
    /// <remarks>
    /// If angles and spins have nearly the same effect, they form a valley in which the search would converge too slowly.
    /// </remarks>
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
}
