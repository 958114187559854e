namespace Football.Physics;

/// <summary>
/// Least squares for a shooting problem by the method of Levenberg and Marquardt, within bounds: an unknown that would leave them is held there. From far starts it
/// goes downhill, near a solution it is Newton's method; where there are more unknowns than equations it goes to the nearest solution.
/// </summary>
internal sealed class LevenbergMarquardt
{
    private const int N = ShootingProblem.Unknowns;
    private const int MostIterations = 25;
    private const int MostTries = 5;
    private const double FirstDamping = 1e-3;
    private const double LeastDamping = 1e-9;

    /// <summary>Largest change of an angle or a logarithm in one iteration.</summary>
    private const double LargestChange = 0.5;

    /// <summary>After an iteration that leaves less than this of the squares, the Jacobian is updated, not measured again.</summary>
    private const double Quick = 0.05;

    /// <summary>An iteration that leaves more of the squares than this is a slow one; so many slow ones in a row, and there is no solution near.</summary>
    private const double Slow = 0.6;
    private const int MostSlow = 3;

    private readonly ShootingProblem _problem;
    private readonly double[] _system = new double[N * (N + 1)];
    private readonly double[] _change = new double[N];
    private readonly double[] _weight = new double[N];
    private readonly double[] _next = new double[N];
    private readonly double[] _nextResiduals = new double[ShootingProblem.MostEquations];
    private readonly bool[] _held = new bool[N];

    public LevenbergMarquardt(ShootingProblem problem) => _problem = problem;

    /// <summary>The residuals of the solution.</summary>
    public double[] Residuals { get; } = new double[ShootingProblem.MostEquations];

    /// <summary>How they move with the unknowns, a row for each.</summary>
    public double[] Jacobian { get; } = new double[ShootingProblem.MostEquations * N];

    /// <summary>Whether what a search leads to is measured.</summary>
    public bool Measures { get; set; } = true;

    /// <summary>Solves from a start.</summary>
    /// <param name="x">The unknowns: the start, and then the best that was found.</param>
    /// <param name="isMeasured">Whether the Jacobian of the start is known.</param>
    /// <returns>Whether that is a hit.</returns>
    private bool Solve(double[] x, bool isMeasured)
    {
        // 1. A flight: the residuals. 2. The Jacobian: measured, or while steps help well, by Broyden's update. 3. A step, damped more until it helps.
        // 4. Given up after slow steps in a row: there is no solution near.
        _problem.Fly(x, Residuals);
        double cost = Squares(Residuals);
        double damping = FirstDamping;
        int slow = 0;
        bool measures = !isMeasured;
        _problem.TimeColumns(x, Jacobian);
        for (int i = 0; i < MostIterations && !_problem.IsSpent; i++)
        {
            if (_problem.IsHit(Residuals))
            {
                return true;
            }

            if (measures)
            {
                _problem.Measure(x, Residuals, Jacobian);
            }

            double before = cost;
            bool improved = Improve(x, ref cost, ref damping);
            if (!improved && measures)
            {
                return false;
            }

            measures = !(cost < Quick * before);
            slow = cost > Slow * before ? slow + 1 : 0;
            if (slow == MostSlow)
            {
                return false;
            }
        }

        return _problem.IsHit(Residuals);
    }

    /// <summary>Solves from a start, and measures what that leads to.</summary>
    /// <param name="x">The unknowns: the start, and then the best that was found.</param>
    /// <param name="solution">The solution.</param>
    /// <param name="isMeasured">Whether the Jacobian of the start is known.</param>
    /// <returns>Whether that truly hits.</returns>
    public bool Hit(double[] x, out AimSolution solution, bool isMeasured = false)
    {
        bool hits = Solve(x, isMeasured);
        solution = _problem.Solution(x);
        return hits && (!Measures || _problem.IsMeasuredHit(x, out solution));
    }

    /// <summary>Takes a step that leaves less of the squares, damped as much as that needs.</summary>
    private bool Improve(double[] x, ref double cost, ref double damping)
    {
        for (int k = 0; k < MostTries; k++)
        {
            if (Step(x, damping))
            {
                _problem.Fly(_next, _nextResiduals);
                double next = Squares(_nextResiduals);
                if (next < cost)
                {
                    cost = next;
                    Update(x);
                    Array.Copy(_next, x, N);
                    Array.Copy(_nextResiduals, Residuals, _nextResiduals.Length);
                    damping = Math.Max(0.1 * damping, LeastDamping);
                    return true;
                }
            }

            damping *= 10;
        }

        // What is measured next is measured around the kick that was flown last.
        _problem.Fly(x, Residuals);
        return false;
    }

    /// <summary>The step (JᵀJ + λ diag JᵀJ) Δx = −Jᵀr of the unknowns that are free, and not at a bound that it would leave.</summary>
    private bool Step(double[] x, double damping)
    {
        // What no residual depends on is held too: the azimuth of a kick straight up.
        for (int k = 0; k < N; k++)
        {
            _held[k] = !_problem.IsFree[k] || Product(k, k) == 0;
        }

        for (int attempt = 0; attempt < 3; attempt++)
        {
            Assemble(damping);
            if (!Linear.Solve(_system, _change, N))
            {
                return false;
            }

            // A step that turns too far is shortened as a whole, so that it keeps its direction.
            double largest = LargestChange;
            for (int k = 0; k < N; k++)
            {
                largest = k is ShootingProblem.Top or ShootingProblem.Side ? largest : Math.Max(largest, Math.Abs(_change[k]));
            }

            bool holds = false;
            for (int k = 0; k < N; k++)
            {
                double wanted = x[k] + (_change[k] * LargestChange / largest);
                _next[k] = _held[k] ? x[k] : _problem.Clamp(k, wanted);
                // At a bound that it would leave: held there, and the others are solved for again.
                bool stuck = !_held[k] && _next[k] == x[k] && wanted != x[k];
                _held[k] |= stuck;
                holds |= stuck;
            }

            if (!holds)
            {
                return true;
            }
        }

        return true;
    }

    /// <summary>Broyden's update, in units of the unknowns in which each counts by what it does: W = diag JᵀJ.</summary>
    private void Update(double[] x)
    {
        double squared = 0;
        for (int k = 0; k < N; k++)
        {
            _change[k] = _next[k] - x[k];
            _weight[k] = _change[k] == 0 ? 0 : Product(k, k);
            squared += _change[k] * _weight[k] * _change[k];
        }

        for (int i = 0; i < _problem.Equations; i++)
        {
            Broyden.Update(Jacobian, i * N, N, _change, _weight, squared, _nextResiduals[i] - Residuals[i]);
        }

        _problem.TimeColumns(_next, Jacobian);
    }

    private void Assemble(double damping)
    {
        for (int a = 0; a < N; a++)
        {
            int row = a * (N + 1);
            for (int b = 0; b < N; b++)
            {
                _system[row + b] = a == b && _held[a] ? 1 : _held[a] || _held[b] ? 0 : Product(a, b);
            }

            double sum = 0;
            for (int i = 0; i < _problem.Equations && !_held[a]; i++)
            {
                sum -= Jacobian[(i * N) + a] * Residuals[i];
            }

            _system[row + a] *= _held[a] ? 1 : 1 + damping;
            _system[row + N] = sum;
        }
    }

    private double Product(int a, int b)
    {
        double sum = 0;
        for (int i = 0; i < _problem.Equations; i++)
        {
            sum += Jacobian[(i * N) + a] * Jacobian[(i * N) + b];
        }

        return sum;
    }

    private double Squares(double[] r)
    {
        double sum = 0;
        for (int i = 0; i < _problem.Equations; i++)
        {
            sum += r[i] * r[i];
        }

        return sum;
    }
}
