namespace FootballPhysics.Aiming;

/// <summary>A problem whose unknowns, within bounds, are to leave nothing of its residuals.</summary>
internal interface ILeastSquares
{
    /// <summary>How many unknowns there are at most: as many columns has the Jacobian.</summary>
    int Unknowns { get; }

    /// <summary>How many residuals there are.</summary>
    int Equations { get; }

    /// <summary>True when no more may be flown.</summary>
    bool IsSpent { get; }

    /// <summary>True when an unknown is free.</summary>
    bool IsFree(int unknown);

    /// <summary>An unknown within its bounds.</summary>
    double Clamp(int unknown, double value);

    /// <summary>The largest change of an unknown in one iteration: beyond it a Jacobian tells nothing.</summary>
    double LargestChange(int unknown);

    /// <summary>The change by which its column of the Jacobian is measured; 0 where it is known in closed form.</summary>
    double Difference(int unknown);

    /// <summary>The residuals.</summary>
    /// <returns>False where there are none: a flight does not get that far.</returns>
    bool Fly(double[] x, double[] r);

    /// <summary>Sets the columns that are known in closed form, for what was flown last.</summary>
    void KnownColumns(double[] x, double[] j);

    /// <summary>True when residuals are small enough.</summary>
    bool IsHit(double[] r);
}

/// <summary>
/// Least squares by the method of Levenberg and Marquardt, within bounds: an unknown that would leave them is held there. From far starts it goes downhill, near a solution
/// it is Newton's method; where there are more unknowns than equations it goes to the nearest solution.
/// </summary>
internal sealed class LeastSquares
{
    private const int MostIterations = 25;
    private const int MostTries = 5;

    /// <summary>With 1e-5 four kicks through two points are lost in place of two (<c>football lab answers --only known --count 1000</c>).</summary>
    private const double FirstDamping = 1e-3;
    private const double LeastDamping = 1e-9;

    /// <summary>
    /// After an iteration that leaves less than this of the squares, the Jacobian is updated, not measured again: at 0.05 a kick in legs takes a fifth more flights
    /// (<c>football lab bankshots --requests 60</c>), and no more known kicks are found (<c>football lab answers --only known --count 1000</c>).
    /// </summary>
    private const double Quick = 0.2;

    /// <summary>An iteration that leaves more of the squares than this is a slow one; so many slow ones in a row, and there is no solution near.</summary>
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
    /// <param name="equations">How many residuals it has at most.</param>
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

    /// <summary>How they move with the unknowns, a row for each.</summary>
    public double[] Jacobian { get; }

    /// <summary>Iterations so far.</summary>
    public int Iterations { get; set; }

    private int N => _problem.Unknowns;

    /// <summary>Solves from a start.</summary>
    /// <param name="x">The unknowns: the start, and then the best that was found.</param>
    /// <param name="isMeasured">Whether the Jacobian of the start is known.</param>
    /// <returns>Whether that is a hit.</returns>
    public bool Solve(double[] x, bool isMeasured = false)
    {
        // 1. A flight: the residuals. 2. The Jacobian: measured, or while steps help well, by Broyden's update. 3. A step, damped more until it helps.
        // 4. Given up after slow steps in a row: there is no solution near.
        if (!_problem.Fly(x, Residuals))
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

            // A kick beside this one that does not get there says nothing of a slope.
            if (measures && !Measure(x))
            {
                return false;
            }

            Iterations++;
            double before = cost;
            bool improved = Improve(x, ref cost, ref damping);

            // Not even along a Jacobian that is measured here: there is no way down.
            if (!improved && measures)
            {
                return false;
            }

            // Updated as long as steps are quick; measured again once one is not.
            measures = !(cost < Quick * before);
            slow = cost > Slow * before ? slow + 1 : 0;
            if (slow == MostSlow)
            {
                return false;
            }
        }

        return _problem.IsHit(Residuals);
    }

    /// <summary>Measures the Jacobian around what was flown last, by differences.</summary>
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

            // To the other side where a bound is in the way.
            double beside = x[k] + difference;
            _next[k] = _problem.Clamp(k, beside) == beside ? beside : x[k] - difference;
            if (!_problem.Fly(_next, _nextResiduals))
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

    /// <summary>Takes a step that leaves less of the squares, damped as much as that needs.</summary>
    private bool Improve(double[] x, ref double cost, ref double damping)
    {
        // More damping makes a step shorter, and turns it downhill. A flight that does not get to its end is no better than one that misses by more.
        for (int k = 0; k < MostTries; k++)
        {
            if (Step(x, damping) && _problem.Fly(_next, _nextResiduals))
            {
                // Taken where it helps; the next one is damped less, and so nearer to Newton's.
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
            _held[k] = !_problem.IsFree(k) || Product(k, k) == 0;
        }

        for (int attempt = 0; attempt < 3; attempt++)
        {
            Assemble(damping);
            if (!Linear.Solve(_system, _change, N))
            {
                return false;
            }

            // A step that turns too far is shortened as a whole, so that it keeps its direction.
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
        // The change is that within the bounds, not the one that was solved for. Columns in closed form are set anew: an update would only blur them.
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
        // A held unknown has a row and a column of its own, 1 Δx = 0: the size of the system stays.
        for (int a = 0; a < N; a++)
        {
            int row = a * (N + 1);
            for (int b = 0; b < N; b++)
            {
                _system[row + b] = a == b && _held[a] ? 1 : _held[a] || _held[b] ? 0 : Product(a, b);
            }

            // (JᵀJ + λ diag JᵀJ) Δx = −Jᵀr: damping by each unknown's own scale.
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
