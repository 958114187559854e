namespace Football.Physics;

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
