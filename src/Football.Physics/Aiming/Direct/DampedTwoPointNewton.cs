namespace Football.Physics;

/// <summary>
/// Newton's method for a two-point kick far from its start: Jacobians are measured, and a step is shortened until the misses shrink.
/// </summary>
internal sealed class DampedTwoPointNewton
{
    private const int N = TwoPointProblem.Size;
    private const int MostIterations = 14;

    /// <summary>How often a step is shortened, and to which share of it.</summary>
    private const int MostShortenings = 5;
    private const double Shortening = 0.4;

    private readonly TwoPointProblem _problem;
    private readonly TwoPointJacobian _jacobian;
    private readonly TwoPointStep _step = new();
    private readonly double[] _r = new double[N];
    private readonly double[] _nextX = new double[N];
    private readonly double[] _nextR = new double[N];

    public DampedTwoPointNewton(TwoPointProblem problem, TwoPointJacobian jacobian)
    {
        _problem = problem;
        _jacobian = jacobian;
    }

    /// <summary>Solves from a start.</summary>
    /// <param name="x">The unknowns: the start, and then the best that was found.</param>
    /// <returns>Whether both points are passed, or the target and, at the limits of the spins, the point as closely as they allow.</returns>
    public bool Solve(double[] x)
    {
        _step.Reset();
        if (!_problem.Fly(x, _r))
        {
            return false;
        }

        for (int i = 0; i < MostIterations && !_problem.IsSpent; i++)
        {
            double asked = _step.ThroughAsked(_r);
            if (_problem.Miss <= _problem.Tolerance && asked <= _problem.ThroughTolerance)
            {
                return _problem.StaysClear(x);
            }

            if (!_jacobian.Measure(_problem, x, _r) || !_step.Solve(_problem, _jacobian, x, _r, out _) || !Advance(x))
            {
                return false;
            }
        }

        return false;
    }

    private bool Advance(double[] x)
    {
        double before = Size(_r);
        double share = 1;
        for (int k = 0; k <= MostShortenings; k++)
        {
            for (int i = 0; i < N; i++)
            {
                _nextX[i] = x[i] + (share * _step.Change[i]);
            }

            if (_problem.Fly(_nextX, _nextR) && Size(_nextR) < before)
            {
                Array.Copy(_nextX, x, N);
                Array.Copy(_nextR, _r, N);
                return true;
            }

            share *= Shortening;
        }

        return false;
    }

    /// <summary>The misses that are to shrink, m.</summary>
    private double Size(double[] r)
    {
        double through = _step.ThroughAsked(r);
        double left = r[TwoPointProblem.TargetLeft];
        double up = r[TwoPointProblem.TargetUp];
        return Math.Sqrt((left * left) + (up * up) + (through * through));
    }
}
