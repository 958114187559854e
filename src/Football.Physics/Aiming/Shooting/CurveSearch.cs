namespace Football.Physics;

/// <summary>The search for the slowest kick, and for the one that is there at a time, that knows nothing: from scans over all directions.</summary>
/// <remarks>
/// Without it 26 of 300 kicks in a storm are told to be the slowest that are not, and 4 are not found at their time; with it none
/// (<c>football lab answers --only known --count 300</c>).
/// </remarks>
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

/// <summary>
/// The kicks that hit a target, with their speed free, are a curve in elevation, azimuth, speed and time. It is followed by pseudo-arclength continuation: a step along
/// its tangent, and back to it on the shortest way; so it does not matter where it turns back in one of them.
/// </summary>
internal sealed class SolutionCurve
{
    private const int N = ShootingProblem.Unknowns;
    private const int MostSteps = 40;
    private const double FirstStep = 0.08;
    private const double LargestStep = 0.4;
    private const double SmallestStep = 4e-3;

    private static readonly int[] s_unknowns = [ShootingProblem.Elevation, ShootingProblem.Azimuth, ShootingProblem.LogSpeed, ShootingProblem.LogTime];

    private readonly ShootingProblem _problem;
    private readonly LevenbergMarquardt _solver;
    private readonly double[] _jacobian = new double[ShootingProblem.MostEquations * N];
    private readonly double[] _next = new double[N];
    private readonly double[] _tangent = new double[4];

    public SolutionCurve(ShootingProblem problem, LevenbergMarquardt solver)
    {
        _problem = problem;
        _solver = solver;
    }

    /// <summary>Follows the curve to slower kicks, until they are slower no more or hit no more.</summary>
    /// <param name="x">A kick on the curve; on return the slowest.</param>
    /// <param name="solution">The same.</param>
    public void Descend(double[] x, ref AimSolution solution)
    {
        double step = FirstStep;
        double before = Tangent(x);
        for (int i = 0; i < MostSteps && step > SmallestStep && !_problem.IsSpent; i++)
        {
            Array.Copy(x, _next, N);
            for (int k = 0; k < s_unknowns.Length; k++)
            {
                int unknown = s_unknowns[k];
                _next[unknown] = _problem.Clamp(unknown, x[unknown] + (step * _tangent[k]));
            }

            if (!_solver.Hit(_next, out AimSolution next) || !(next.Speed < solution.Speed))
            {
                step *= 0.4;
                continue;
            }

            solution = next;
            Array.Copy(_next, x, N);
            double after = Tangent(x);

            // The slope of the speed is about linear in the way: the next step is not to pass its root.
            double toRoot = after > before ? step * after / (before - after) : LargestStep;
            step = Math.Min(Math.Min(2.0 * step, LargestStep), Math.Max(toRoot, 0.25 * step));
            before = after;
        }
    }

    /// <summary>The unit tangent, towards slower kicks.</summary>
    /// <returns>How the logarithm of the speed changes along it; not above 0.</returns>
    private double Tangent(double[] x)
    {
        _problem.Measure(x, _solver.Residuals, _jacobian);
        double squared = 0;
        for (int k = 0; k < 4; k++)
        {
            // The null vector of a 3 × 4 matrix: its minors
            Vector3d a = Column(s_unknowns[k == 0 ? 1 : 0]);
            Vector3d b = Column(s_unknowns[k <= 1 ? 2 : 1]);
            Vector3d c = Column(s_unknowns[k <= 2 ? 3 : 2]);
            double minor = Vector3d.Dot(in a, Vector3d.Cross(in b, in c));
            _tangent[k] = k % 2 == 0 ? minor : -minor;
            squared += minor * minor;
        }

        double length = Math.Sqrt(squared) * (_tangent[2] > 0 ? -1 : 1);
        for (int k = 0; k < 4; k++)
        {
            _tangent[k] = length != 0 ? _tangent[k] / length : 0;
        }

        return _tangent[2];
    }

    private Vector3d Column(int unknown) => new(_jacobian[unknown], _jacobian[N + unknown], _jacobian[(2 * N) + unknown]);
}
