namespace Football.Physics;

/// <summary>The search for a two-point kick that the closed form is too far from: from many kicks, in all directions and with many spins.</summary>
internal sealed class TwoPointSearch
{
    private const int N = ShootingProblem.Unknowns;

    /// <summary>Elevations, azimuths and spins that are tried.</summary>
    private const int Rows = 5;
    private const int Columns = 6;
    private const int Spins = 9;

    private readonly ShootingProblem _problem;
    private readonly LevenbergMarquardt _solver;
    private readonly DirectionScan _scan;
    private readonly double[] _x = new double[N];

    public TwoPointSearch(ShootingProblem problem, LevenbergMarquardt solver, DirectionScan scan)
    {
        _problem = problem;
        _solver = solver;
        _scan = scan;
    }

    /// <summary>Searches.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="near">A kick to begin with.</param>
    /// <param name="solution">The kick that passes both points.</param>
    /// <returns>Whether there is one, measured.</returns>
    public bool Find(AimRequest request, in Kick near, out AimSolution solution)
    {
        _problem.Begin(request, request.Speed, through: true);
        _x[ShootingProblem.Elevation] = _problem.Clamp(ShootingProblem.Elevation, near.Elevation);
        _x[ShootingProblem.Azimuth] = near.Azimuth;
        _x[ShootingProblem.LogSpeed] = Elementary.Log(request.Speed);
        _x[ShootingProblem.Top] = _problem.Clamp(ShootingProblem.Top, near.Top);
        _x[ShootingProblem.Side] = _problem.Clamp(ShootingProblem.Side, near.Side);
        _problem.Approach(_x);
        if (_solver.Hit(_x, out solution))
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
            _scan.Fly(Rows, Columns, request.Speed, top * request.MaximumTopSpin, side * request.MaximumSideSpin);
        }

        for (int start = 0; start < _scan.Count && !_problem.IsSpent; start++)
        {
            _scan.Start(start, _x);
            if (_solver.Hit(_x, out AimSolution one))
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
    /// <param name="solution">The kick.</param>
    /// <returns>Whether it hits the target, and passes the other point within its tolerance.</returns>
    private bool Near(out AimSolution solution)
    {
        solution = default;
        double tolerance = _problem.Request.ThroughTolerance;
        double squares = 0;
        foreach (double residual in _solver.Residuals)
        {
            squares += residual * residual;
        }

        if (!(squares < tolerance * tolerance))
        {
            return false;
        }

        _problem.AskThrough(false);
        bool hits = _solver.Hit(_x, out solution) && solution.ThroughMiss <= tolerance;
        _problem.AskThrough(true);
        return hits;
    }
}
