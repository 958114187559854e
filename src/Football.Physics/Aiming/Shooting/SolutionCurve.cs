namespace FootballPhysics.Aiming;

/// <summary>
/// The kicks that hit a target, with their speed free, are a curve in elevation, azimuth, speed and time. It is followed by pseudo-arclength continuation: a step along
/// its tangent, and back to it on the shortest way; so it does not matter where it turns back in one of them.
/// </summary>
internal sealed class SolutionCurve
{
    private const int N = ShootingProblem.Most;
    private const int MostSteps = 40;
    private const double FirstStep = 0.08;
    private const double LargestStep = 0.4;
    private const double SmallestStep = 4e-3;

    /// <summary>A slope of the speed whose sign a Jacobian by updates tells.</summary>
    private const double ClearSlope = 0.1;

    /// <summary>By this share of its speed a slower kick need not be sought.</summary>
    private const double LittleSlower = 1e-5;

    private static readonly int[] s_unknowns = [ShootingProblem.Elevation, ShootingProblem.Azimuth, ShootingProblem.LogSpeed, ShootingProblem.LogTime];

    private readonly ShootingProblem _problem;
    private readonly LeastSquares _solver;
    private readonly double[] _next = new double[N];
    private readonly double[] _tangent = new double[4];
    private readonly double[] _last = new double[4];

    public SolutionCurve(ShootingProblem problem)
    {
        _problem = problem;
        _solver = problem.Solver;
    }

    /// <summary>Follows the curve to slower kicks, until they are slower no more or hit no more.</summary>
    public void Descend(double[] x, ref AimSolution solution)
    {
        // Where the Jacobian by updates tells clearly that the slower ones are not allowed, it need not be measured.
        double step = FirstStep;
        double before = Tangent(measures: false, x);
        if (before < -ClearSlope && !Goes(x, step))
        {
            return;
        }

        before = Tangent(measures: true, x);
        // 1. A step along the tangent, and back to the curve. 2. Shorter where that is no hit, or no slower. 3. Else the tangent there: where the speed rises along it the
        // least lies behind. 4. The next step is to where the slope is zero, or ends where that is worth nothing.
        for (int i = 0; i < MostSteps && step > SmallestStep && !_problem.IsSpent; i++)
        {
            if (!Goes(x, step))
            {
                return;
            }

            if (!_solver.Solve(_next, isMeasured: true) || !(_problem.Solution(_next).Speed < solution.Speed))
            {
                step *= 0.4;
                continue;
            }

            solution = _problem.Solution(_next);
            Array.Copy(_next, x, N);
            Array.Copy(_tangent, _last, _last.Length);
            double after = Tangent(measures: true, x);
            double turned = 0;
            for (int k = 0; k < _last.Length; k++)
            {
                turned += _last[k] * _tangent[k];
            }

            // The slope of the speed is about linear in the way: the next step is to its root, before or behind.
            double slope = turned < 0 ? -after : after;
            double toRoot = slope > before ? step * Math.Abs(after) / (slope - before) : LargestStep;
            if (0.5 * toRoot * Math.Abs(after) < LittleSlower)
            {
                return;
            }

            step = Math.Min(Math.Min(2.0 * step, LargestStep), Math.Max(toRoot, 0.25 * step));
            before = after;
        }
    }

    /// <summary>Takes a step along the tangent.</summary>
    /// <returns>False where a bound is in the way: the slower ones lie beyond it.</returns>
    private bool Goes(double[] x, double step)
    {
        Array.Copy(x, _next, N);
        for (int k = 0; k < s_unknowns.Length; k++)
        {
            int unknown = s_unknowns[k];
            _next[unknown] = _problem.Clamp(unknown, x[unknown] + (step * _tangent[k]));
            if (_next[unknown] == x[unknown] && _tangent[k] != 0)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>True when the kicks of the curve are the slower, the longer they take.</summary>
    public bool SlowsWithTime(double[] x)
    {
        _problem.Fly(x, _solver.Residuals);
        Tangent(measures: true, x);
        return _tangent[3] > 0;
    }

    /// <summary>The unit tangent, towards slower kicks.</summary>
    /// <returns>How the logarithm of the speed changes along it; not above 0.</returns>
    private double Tangent(bool measures, double[] x)
    {
        if (measures)
        {
            _solver.Measure(x);
        }

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

        // Towards slower kicks, whichever way the minors point.
        double length = Math.Sqrt(squared) * (_tangent[2] > 0 ? -1 : 1);
        for (int k = 0; k < 4; k++)
        {
            _tangent[k] = length != 0 ? _tangent[k] / length : 0;
        }

        return _tangent[2];
    }

    private Vector3d Column(int unknown) => new(_solver.Jacobian[unknown], _solver.Jacobian[N + unknown], _solver.Jacobian[(2 * N) + unknown]);
}
