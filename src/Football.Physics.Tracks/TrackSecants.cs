using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The normal equations N = JᵀJ + prior, g = Jᵀr + …; the Jacobian consists of secants as wide as the uncertainty.</summary>
/// <remarks>
/// Paths have kinks where a ball just stops slipping in an impact, or just bounces once more; derivatives there are valid in a tiny range only.
/// </remarks>
internal sealed class TrackSecants
{
    /// <summary>Half the width of a secant, in standard deviations.</summary>
    private const double HalfWidth = 0.5;

    /// <summary>The widths of the first secants, in m, m/s, rad/s and as a factor; about the accuracy of a camera.</summary>
    private const double FirstPlace = 0.01;
    private const double FirstVelocity = 0.1;
    private const double FirstSpin = 2;
    private const double FirstFactor = 0.02;

    /// <summary>The largest half widths, in m, m/s, rad/s and as a factor: beyond them, a path differs too much for a derivative.</summary>
    private const double MostPlace = 0.5;
    private const double MostVelocity = 2;
    private const double MostSpin = 30;
    private const double MostFactor = 0.15;

    /// <summary>The index of the height, the parameter that the ground limits.</summary>
    private const int Height = 1;

    private const double OnGround = 1e-9;

    private readonly TrackPaths _paths;
    private readonly TrackModel _model;
    private readonly int _count;
    private readonly double[] _jacobian;
    private readonly double[] _normal;
    private readonly double[] _gradient;
    private readonly double[] _system;
    private readonly double[] _unit;
    private readonly double[] _changed;
    private readonly double[] _high;
    private readonly double[] _low;
    private double _floor;

    public TrackSecants(TrackPaths paths, TrackModel model)
    {
        _paths = paths;
        _model = model;
        _count = model.Count;
        _jacobian = new double[paths.Rows * _count];
        _normal = new double[_count * _count];
        _gradient = new double[_count];
        _system = new double[_count * (_count + 1)];
        _unit = new double[_count];
        _changed = new double[_count];
        _high = new double[paths.Rows];
        _low = new double[paths.Rows];
        Axes = new double[_count][];
        for (int i = 0; i < _count; i++)
        {
            Axes[i] = new double[_count];
            Axes[i][i] = Kind(i, FirstPlace, FirstVelocity, FirstSpin, FirstFactor);
        }
    }

    /// <summary>The vectors lⱼ of N⁻¹ = Σ lⱼ lⱼᵀ: parameter j moved by its deviation.</summary>
    /// <remarks>Later parameters are held, and earlier ones follow. The scene's factors come last, because they are the least certain.</remarks>
    public double[][] Axes { get; }

    /// <summary>Evaluates J and N with the axes of the last N, and then updates the axes.</summary>
    /// <returns>False if a parameter has no effect.</returns>
    public bool Evaluate(double[] values)
    {
        // 1. Raise the start, so that no secant begins in the ground. 2. Simulate both ends of each axis. 3. Compute J from the secants, N from J,
        // and the axes from N.
        double lift = 0;
        _floor = _model.Simulator(values).ContactHeight;
        for (int j = 0; j < _count; j++)
        {
            lift = Math.Max(lift, Share(Axes[j]) * Math.Abs(Axes[j][Height]));
        }

        // Both ends of every secant are above the ground.
        lift = Math.Max(0, _floor + lift - values[Height]);
        for (int j = 0; j < _count; j++)
        {
            double[] axis = Axes[j];
            double share = Share(axis);
            Follow(values, axis, share, lift, _high);
            Follow(values, axis, -share, lift, _low);

            // The secant is J lⱼ, and lⱼ only contains parameters up to j: compute column j of J from the earlier columns.
            for (int row = 0; row < _high.Length; row++)
            {
                int at = row * _count;
                double sum = 0.5 / share * (_low[row] - _high[row]);
                for (int k = 0; k < j; k++)
                {
                    sum -= _jacobian[at + k] * axis[k];
                }

                _jacobian[at + j] = sum / axis[j];
            }
        }

        Array.Clear(_normal, 0, _normal.Length);
        for (int row = 0; row < _high.Length; row++)
        {
            int at = row * _count;
            for (int i = 0; i < _count * _count; i++)
            {
                _normal[i] += _jacobian[at + (i / _count)] * _jacobian[at + (i % _count)];
            }
        }

        _model.AddKnown(values, _normal, _gradient);
        return FindAxes();
    }

    /// <summary>Solves (N + λ diag N) x = g for the first parameters, with all others held.</summary>
    /// <param name="values">The parameters.</param>
    /// <param name="misses">The residuals.</param>
    /// <param name="free">The number of parameters that are not held.</param>
    /// <param name="damping">The damping λ.</param>
    /// <param name="step">The step.</param>
    /// <param name="gain">The decrease of the cost if the model were linear.</param>
    public bool Solve(double[] values, double[] misses, int free, double damping, double[] step, out double gain)
    {
        Array.Clear(_gradient, 0, _count);
        for (int row = 0; row < misses.Length; row++)
        {
            for (int i = 0; i < free; i++)
            {
                _gradient[i] += _jacobian[(row * _count) + i] * misses[row];
            }
        }

        _model.AddKnown(values, null, _gradient);
        bool solved = Solve(free, damping, _gradient, step, holds: false);
        if (solved && free > Height && step[Height] < 0 && values[Height] <= _floor + OnGround)
        {
            solved = Solve(free, damping, _gradient, step, holds: true);
        }

        gain = 0;
        for (int i = 0; solved && i < free; i++)
        {
            gain += step[i] * _gradient[i];
        }

        return solved && !double.IsNaN(gain);
    }

    /// <summary>Returns the half width of a secant along an axis, as a share of the axis.</summary>
    private double Share(double[] axis)
    {
        double share = HalfWidth;
        for (int i = 0; i < _count; i++)
        {
            double most = Kind(i, MostPlace, MostVelocity, MostSpin, MostFactor);
            share = share * Math.Abs(axis[i]) > most ? most / Math.Abs(axis[i]) : share;
        }

        return share;
    }

    private static double Kind(int parameter, double place, double velocity, double spin, double factor) =>
        parameter < 3 ? place : parameter < TrackModel.FirstSpin ? velocity : parameter < TrackModel.Launch ? spin : factor;

    private void Follow(double[] values, double[] axis, double share, double lift, double[] misses)
    {
        for (int i = 0; i < _count; i++)
        {
            _changed[i] = values[i] + (share * axis[i]);
        }

        _changed[Height] += lift;
        _paths.Follow(_changed, misses);
    }

    private bool FindAxes()
    {
        for (int j = 0; j < _count; j++)
        {
            // Column j of the inverse of the first j + 1 rows and columns.
            double[] axis = Axes[j];
            Array.Clear(axis, 0, _count);
            Array.Clear(_unit, 0, _count);
            _unit[j] = 1;
            if (!Solve(j + 1, 0, _unit, axis, holds: false) || !(axis[j] > 0) || double.IsInfinity(axis[j]))
            {
                return false;
            }

            double scale = 1.0 / Math.Sqrt(axis[j]);
            for (int k = 0; k <= j; k++)
            {
                axis[k] *= scale;
            }
        }

        return true;
    }

    /// <summary>Solves for the first parameters, optionally with the height held.</summary>
    private bool Solve(int free, double damping, double[] right, double[] x, bool holds)
    {
        int width = free + 1;
        for (int i = 0; i < free; i++)
        {
            for (int j = 0; j < free; j++)
            {
                bool held = holds && (i == Height || j == Height);
                _system[(i * width) + j] = held ? (i == j ? 1 : 0) : _normal[(i * _count) + j] * (i == j ? 1.0 + damping : 1.0);
            }

            _system[(i * width) + free] = holds && i == Height ? 0 : right[i];
        }

        return Linear.Solve(_system, x, free);
    }
}
