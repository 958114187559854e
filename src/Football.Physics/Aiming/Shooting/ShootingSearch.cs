namespace Football.Physics;

/// <summary>The search for a kick of a given speed that knows nothing: a scan over all directions, and from what comes close there the method of Levenberg and Marquardt.</summary>
internal sealed class ShootingSearch
{
    private const int N = ShootingProblem.Unknowns;

    /// <summary>Elevations and azimuths of a scan, and its starts that are followed.</summary>
    private const int Rows = 13;
    private const int Columns = 12;
    private const int MostStarts = 8;

    private readonly ShootingProblem _problem;
    private readonly LevenbergMarquardt _solver;
    private readonly DirectionScan _scan;
    private readonly double[] _x = new double[N];

    public ShootingSearch(ShootingProblem problem, LevenbergMarquardt solver, DirectionScan scan)
    {
        _problem = problem;
        _solver = solver;
        _scan = scan;
    }

    /// <summary>Searches.</summary>
    /// <param name="request">What the kick is to do.</param>
    /// <param name="speed">Its speed, m/s.</param>
    /// <param name="arc">Whether the one that is there first is wanted, or the last.</param>
    /// <param name="top">Its topspin, rad/s.</param>
    /// <param name="side">Its sidespin, rad/s.</param>
    /// <param name="solution">The kick.</param>
    /// <returns>Whether there is one, measured.</returns>
    public bool WithSpeed(AimRequest request, double speed, AimArc arc, double top, double side, out AimSolution solution)
    {
        solution = default;
        if (_problem.IsHalfSpent)
        {
            return false;
        }

        _problem.Begin(request, speed, through: false);
        _scan.Clear();
        _scan.Fly(Rows, Columns, speed, top, side);
        bool found = false;
        for (int start = 0; start < Math.Min(MostStarts, _scan.Count) && !_problem.IsHalfSpent; start++)
        {
            _scan.Start(start, _x);
            if (_solver.Hit(_x, out AimSolution one) && (!found || (arc == AimArc.Low ? one.Time < solution.Time : one.Time > solution.Time)))
            {
                solution = one;
                found = true;
            }
        }

        return found;
    }
}
