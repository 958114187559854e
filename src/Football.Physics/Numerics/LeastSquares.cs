namespace FootballPhysics.Numerics;

/// <summary>A problem with bounded unknowns; a solution makes its residuals zero.</summary>
internal interface ILeastSquares
{
    /// <summary>The maximum number of unknowns, which is the number of columns of the Jacobian.</summary>
    int Unknowns { get; }

    /// <summary>The number of residuals.</summary>
    int Equations { get; }

    /// <summary>True if the budget of evaluations is used up.</summary>
    bool IsSpent { get; }

    /// <summary>True if an unknown is free.</summary>
    bool IsFree(int unknown);

    /// <summary>Clamps an unknown to its bounds.</summary>
    double Clamp(int unknown, double value);

    /// <summary>Returns the largest change of an unknown in one iteration, beyond which the Jacobian is not valid.</summary>
    double LargestChange(int unknown);

    /// <summary>Returns the difference that measures a column of the Jacobian; 0 if the column is known in closed form.</summary>
    double Difference(int unknown);

    /// <summary>Computes the residuals.</summary>
    /// <returns>False if there are none, such as those of a flight that ends too early.</returns>
    bool Evaluate(double[] x, double[] r);

    /// <summary>Sets the closed-form columns for the last evaluation.</summary>
    void KnownColumns(double[] x, double[] j);

    /// <summary>True if the residuals are small enough.</summary>
    bool IsHit(double[] r);
}

/// <summary>Least squares by the Levenberg–Marquardt method, within bounds.</summary>
/// <remarks>
/// An unknown that would leave its bounds is held there. Far from a solution the method moves downhill; near one it becomes Newton's method. With
/// more unknowns than equations, it finds the nearest solution.
/// </remarks>
internal sealed class LeastSquares
{
    private const int MostIterations = 25;
    private const int MostTries = 5;

    /// <summary>The initial and the minimum damping.</summary>
    /// <remarks>
    /// With an initial value of 1e-5, four kicks with a waypoint are lost instead of two (<c>football lab answers --only known --count 1000</c>).
    /// </remarks>
    private const double FirstDamping = 1e-3;
    private const double LeastDamping = 1e-9;

    /// <summary>The ratio of squares below which an iteration updates the Jacobian instead of measuring it again.</summary>
    /// <remarks>
    /// At 0.05 a bank shot takes a fifth more flights (<c>football lab bankshots --requests 60</c>), and no more known kicks are found (<c>football
    /// lab answers --only known --count 1000</c>).
    /// </remarks>
    private const double Quick = 0.2;

    /// <summary>The ratio of squares above which an iteration is slow, and the number of slow ones in a row that end the search.</summary>
    private const double Slow = 0.6;
    private const int MostSlow = 3;

    private readonly ILeastSquares _problem;
    private readonly double[] _system;
    private readonly double[] _change;
    private readonly double[] _weight;
    private readonly double[] _next;
    private readonly double[] _nextResiduals;
    private readonly bool[] _held;

    /// <param name="problem">The problem.</param>
    /// <param name="equations">The maximum number of residuals.</param>
    public LeastSquares(ILeastSquares problem, int equations)
    {
        int n = problem.Unknowns;
        _problem = problem;
        _system = new double[n * (n + 1)];
        _change = new double[n];
        _weight = new double[n];
        _next = new double[n];
        _held = new bool[n];
        _nextResiduals = new double[equations];
        Residuals = new double[equations];
        Jacobian = new double[equations * n];
    }

    /// <summary>The residuals of the solution.</summary>
    public double[] Residuals { get; }

    /// <summary>The Jacobian of the residuals, one row per residual.</summary>
    public double[] Jacobian { get; }

    /// <summary>The number of iterations so far.</summary>
    public int Iterations { get; set; }

    private int N => _problem.Unknowns;

    /// <summary>Solves from a start.</summary>
    /// <param name="x">The unknowns: the start, and then the best solution found.</param>
    /// <param name="isMeasured">True if the Jacobian of the start is known.</param>
    /// <returns>True if the solution is a hit.</returns>
    public bool Solve(double[] x, bool isMeasured = false)
    {
        // 1. Compute the residuals. 2. Measure the Jacobian, or apply Broyden's update while steps improve well. 3. Take a step; increase the damping
        // until it improves. 4. Give up after several slow steps: no solution is near.
        if (!_problem.Evaluate(x, Residuals))
        {
            return false;
        }

        double cost = Squares(Residuals);
        double damping = FirstDamping;
        int slow = 0;
        bool measures = !isMeasured;
        _problem.KnownColumns(x, Jacobian);
        for (int i = 0; i < MostIterations && !_problem.IsSpent; i++)
        {
            if (_problem.IsHit(Residuals))
            {
                return true;
            }

            // Without residuals at a neighbouring point, no difference quotient exists.
            if (measures && !Measure(x))
            {
                return false;
            }

            Iterations++;
            double before = cost;
            bool improved = Improve(x, ref cost, ref damping);

            // Even a freshly measured Jacobian gives no improvement: this is a local minimum.
            if (!improved && measures)
            {
                return false;
            }

            // Update the Jacobian while steps improve well; measure it again after a poor step.
            measures = !(cost < Quick * before);
            slow = cost > Slow * before ? slow + 1 : 0;
            if (slow == MostSlow)
            {
                return false;
            }
        }

        return _problem.IsHit(Residuals);
    }

    /// <summary>Measures the Jacobian at the last evaluation by differences.</summary>
    public bool Measure(double[] x)
    {
        _problem.KnownColumns(x, Jacobian);
        Array.Copy(x, _next, N);
        for (int k = 0; k < N; k++)
        {
            double difference = _problem.Difference(k);
            if (!_problem.IsFree(k) || difference == 0)
            {
                continue;
            }

            // Use a backward difference if a bound is in the way.
            double beside = x[k] + difference;
            _next[k] = _problem.Clamp(k, beside) == beside ? beside : x[k] - difference;
            if (!_problem.Evaluate(_next, _nextResiduals))
            {
                return false;
            }

            for (int i = 0; i < _problem.Equations; i++)
            {
                Jacobian[(i * N) + k] = (_nextResiduals[i] - Residuals[i]) / (_next[k] - x[k]);
            }

            _next[k] = x[k];
        }

        return true;
    }

    /// <summary>Takes a step that reduces the squares, with as much damping as necessary.</summary>
    private bool Improve(double[] x, ref double cost, ref double damping)
    {
        // More damping shortens the step and turns it downhill. A point without residuals counts as worse.
        for (int k = 0; k < MostTries; k++)
        {
            if (Step(x, damping) && _problem.Evaluate(_next, _nextResiduals))
            {
                // Accept an improvement and reduce the damping, so that the next step is closer to a Newton step.
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

        // Restore the evaluation at the current point, because the next measurement is relative to it.
        _problem.Evaluate(x, Residuals);
        return false;
    }

    /// <summary>Solves (JᵀJ + λ diag JᵀJ) Δx = −Jᵀr for the unknowns that are free and do not push against a bound.</summary>
    private bool Step(double[] x, double damping)
    {
        // Also hold an unknown that has no effect, such as the azimuth of a vertical kick.
        for (int k = 0; k < N; k++)
        {
            _held[k] = !_problem.IsFree(k) || Product(k, k) == 0;
        }

        for (int attempt = 0; attempt < 3; attempt++)
        {
            Assemble(damping);
            if (!Linear.Solve(_system, _change, N))
            {
                return false;
            }

            // If any change is too large, shorten the whole step, so that it keeps its direction.
            double share = 1;
            for (int k = 0; k < N; k++)
            {
                share = Math.Max(share, Math.Abs(_change[k]) / _problem.LargestChange(k));
            }

            bool holds = false;
            for (int k = 0; k < N; k++)
            {
                double wanted = x[k] + (_change[k] / share);
                _next[k] = _held[k] ? x[k] : _problem.Clamp(k, wanted);
                // Fix an unknown that would exceed its bound, and solve again for the others.
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

    /// <summary>Applies Broyden's update, with each unknown weighted by its effect: W = diag JᵀJ.</summary>
    private void Update(double[] x)
    {
        // Use the change after clamping, not the computed one. Then set closed-form columns again, because an update would degrade them.
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

        _problem.KnownColumns(_next, Jacobian);
    }

    private void Assemble(double damping)
    {
        // A held unknown has the equation 1 Δx = 0, so that the system keeps its size.
        for (int a = 0; a < N; a++)
        {
            int row = a * (N + 1);
            for (int b = 0; b < N; b++)
            {
                _system[row + b] = a == b && _held[a] ? 1 : _held[a] || _held[b] ? 0 : Product(a, b);
            }

            // J is the Jacobian, r the residuals, λ the damping, and Δx the step.
            // (JᵀJ + λ diag JᵀJ) Δx = −Jᵀr: each unknown is damped on its own scale.
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
