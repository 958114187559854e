using FootballPhysics.Numerics;

namespace FootballPhysics.Aiming;

/// <summary>Follows the curve of kicks that hit a target with free speed, in elevation, azimuth, speed and time.</summary>
/// <remarks>
/// It uses pseudo-arclength continuation: a step along the tangent, then the shortest correction back to the curve. So the curve may turn back in
/// any of the unknowns.
/// </remarks>
internal sealed class SolutionCurve(ShootingProblem problem)
{
    private const int N = ShootingProblem.Most;
    private const int MostSteps = 40;
    private const double FirstStep = 0.08;
    private const double LargestStep = 0.4;
    private const double SmallestStep = 4e-3;

    /// <summary>The slope of the speed above which an updated Jacobian reliably determines its sign.</summary>
    private const double ClearSlope = 0.1;

    /// <summary>The relative reduction of the speed that is not worth another step.</summary>
    private const double LittleSlower = 1e-5;

    private static readonly int[] s_unknowns = [ShootingProblem.Elevation, ShootingProblem.Azimuth, ShootingProblem.LogSpeed, ShootingProblem.LogTime];

    private readonly ShootingProblem _problem = problem;
    private readonly LeastSquares _solver = problem.Solver;
    private readonly double[] _next = new double[N];
    private readonly double[] _tangent = new double[4];
    private readonly double[] _last = new double[4];

    /// <summary>Follows the curve to slower kicks, until the speed is minimal or the kicks no longer hit.</summary>
    public void Descend(double[] x, ref AimSolution solution)
    {
        // The updated Jacobian clearly shows that slower kicks are out of bounds: skip the measurement.
        double step = FirstStep;
        double before = Tangent(measures: false, x);
        if (before < -ClearSlope && !Goes(x, step))
        {
            return;
        }

        before = Tangent(measures: true, x);
        // 1. Step along the tangent, and correct back to the curve. 2. If the step yields no hit, or no slower kick, shorten it. 3. Otherwise,
        // compute the tangent there: if it points back, the minimum has been passed. 4. Step to the zero of the slope, or stop if the gain is
        // negligible.
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

            // The slope of the speed is almost linear in the arc length: step to its root, forwards or backwards.
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
    /// <returns>False if a bound is in the way, so that slower kicks lie beyond it.</returns>
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

    /// <summary>True if a longer time means a slower kick at this point of the curve.</summary>
    public bool SlowsWithTime(double[] x)
    {
        _problem.Evaluate(x, _solver.Residuals);
        Tangent(measures: true, x);
        return _tangent[3] > 0;
    }

    /// <summary>Computes the unit tangent towards slower kicks.</summary>
    /// <returns>The derivative of the logarithm of the speed along it; at most 0.</returns>
    private double Tangent(bool measures, double[] x)
    {
        if (measures)
        {
            _solver.Measure(x);
        }

        double squared = 0;
        for (int k = 0; k < 4; k++)
        {
            // The minors of a 3 × 4 matrix give its null vector.
            Vector3d a = Column(s_unknowns[k == 0 ? 1 : 0]);
            Vector3d b = Column(s_unknowns[k <= 1 ? 2 : 1]);
            Vector3d c = Column(s_unknowns[k <= 2 ? 3 : 2]);
            double minor = Vector3d.Dot(in a, Vector3d.Cross(in b, in c));
            _tangent[k] = k % 2 == 0 ? minor : -minor;
            squared += minor * minor;
        }

        // Orient the null vector towards slower kicks.
        double length = Math.Sqrt(squared) * (_tangent[2] > 0 ? -1 : 1);
        for (int k = 0; k < 4; k++)
        {
            _tangent[k] = length != 0 ? _tangent[k] / length : 0;
        }

        return _tangent[2];
    }

    private Vector3d Column(int unknown) => new(_solver.Jacobian[unknown], _solver.Jacobian[N + unknown], _solver.Jacobian[(2 * N) + unknown]);
}
