namespace Football.Physics;

/// <summary>The search for the slowest kick, and for the one that is there at a time, that knows nothing: from scans over all directions.</summary>
internal sealed class CurveSearch
{
    private const int N = ShootingProblem.Unknowns;

    /// <summary>Elevations and azimuths of a scan, its starts that are followed, and the speeds of scans as shares of the fastest.</summary>
    private const int Rows = 9;
    private const int Columns = 10;
    private const int MostStarts = 4;
    private const int Scans = 3;
    private const double SlowerScan = 0.7;

    private readonly ShootingProblem _problem;
    private readonly DirectionScan _scan;
    private readonly LevenbergMarquardt _solver;
    private readonly SolutionCurve _curve;
    private readonly double[] _x = new double[N];

    public CurveSearch(ShootingProblem problem, DirectionScan scan, LevenbergMarquardt solver)
    {
        _problem = problem;
        _scan = scan;
        _solver = solver;
        _curve = new SolutionCurve(problem, solver);
    }

    /// <summary>The slowest kick.</summary>
    /// <param name="request">What it is to do; its speed is the fastest allowed.</param>
    /// <param name="solution">The kick.</param>
    /// <returns>Whether there is one, measured.</returns>
    public bool Slowest(AimRequest request, out AimSolution solution)
    {
        Begin(request);
        solution = default;
        bool found = false;
        double speed = request.Speed;
        for (int i = 0; i < Scans; i++, speed *= SlowerScan)
        {
            _scan.Clear();
            _scan.Fly(Rows, Columns, speed, request.TopSpin, request.SideSpin);
            for (int start = 0; start < Math.Min(MostStarts, _scan.Count) && !_problem.IsSpent; start++)
            {
                _scan.Start(start, _x);
                if (!_solver.Hit(_x, out AimSolution one))
                {
                    continue;
                }

                _curve.Descend(_x, ref one);
                if (!found || one.Speed < solution.Speed)
                {
                    solution = one;
                    found = true;
                }
            }
        }

        return found;
    }

    /// <summary>The kick that is at the target at a time.</summary>
    /// <param name="request">What it is to do; its speed is the fastest allowed.</param>
    /// <param name="time">The time, s.</param>
    /// <param name="solution">The kick.</param>
    /// <returns>Whether there is one, measured.</returns>
    public bool AtTime(AimRequest request, double time, out AimSolution solution)
    {
        Begin(request);
        _problem.IsFree[ShootingProblem.LogTime] = false;
        solution = default;
        double speed = request.Speed;
        for (int i = 0; i < Scans; i++, speed *= SlowerScan)
        {
            _scan.Clear();
            _scan.Fly(Rows, Columns, speed, request.TopSpin, request.SideSpin, time);
            for (int start = 0; start < Math.Min(MostStarts, _scan.Count) && !_problem.IsSpent; start++)
            {
                _scan.Start(start, _x);
                if (_solver.Hit(_x, out solution))
                {
                    return true;
                }
            }
        }

        return false;
    }

    private void Begin(AimRequest request)
    {
        _problem.Begin(request, request.Speed, through: false);
        _problem.IsFree[ShootingProblem.LogSpeed] = true;
        _problem.Most[ShootingProblem.LogSpeed] = Elementary.Log(request.Speed);
    }
}
