using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Fits the launches of many flights and their shared parameters simultaneously.</summary>
/// <remarks>
/// Damped Gauss–Newton (Levenberg–Marquardt). Each launch affects only its own flight and is eliminated (<see cref="LaunchElimination"/>), so the system has
/// the size of the shared parameters.
/// </remarks>
internal sealed class SharedFit
{
    private const int Launch = FlightPath.Launch;
    private const int MostSteps = 25;

    /// <summary>The relative gain of a step below which the search ends.</summary>
    private const double LeastGain = 1e-5;

    private const double FirstDamping = 1e-3;
    private const double LeastDamping = 1e-9;
    private const double MostDamping = 1e6;

    /// <summary>The ratio to the median residual above which a flight has less weight in the shared parameters.</summary>
    private const double Strange = 2.5;

    /// <summary>The minimum error of the laws as a share of a point's variance, even if a flight happens to fit better: wind and drag are known no better.</summary>
    private const double LeastScatter = 0.4;

    /// <summary>The share of a systematic misfit that acts alike at all points of a flight.</summary>
    private const double CommonShare = 0.3;

    /// <summary>The misfit per coordinate, in m, from which heights near the ground are as wrong as on any pitch. Without a misfit, they are right.</summary>
    private const double LowMisfit = 0.008;

    /// <summary>The standard deviations beyond which the likeness of successive residuals is a misfit.</summary>
    private const double LikenessDeviations = 2;

    private readonly FlightEquations _system;
    private readonly MatchModel _model;
    private readonly int _shared;
    private readonly int _size;
    private readonly LaunchElimination _elimination;
    private readonly double[] _scratch = new double[Launch * Launch];

    public SharedFit(FlightEquations system, MatchModel model, double[]? start = null)
    {
        _system = system;
        _model = model;
        _shared = model.Count;
        _size = Launch + _shared;
        _elimination = new LaunchElimination(_shared);
        Values = new double[_shared];
        Covariance = new double[_shared * _shared];
        for (int i = 0; i < _shared; i++)
        {
            Values[i] = start is null ? model.Likely(i) : start[i];
        }

        At = new Simulator(model.Scene(Values));
    }

    /// <summary>The shared parameters.</summary>
    public double[] Values { get; }

    /// <summary>The covariance matrix of the shared parameters.</summary>
    public double[] Covariance { get; }

    /// <summary>The scene with the shared parameters.</summary>
    public Simulator At { get; private set; }

    /// <summary>The final cost.</summary>
    public double Cost { get; private set; }

    /// <summary>Minimises the cost.</summary>
    /// <param name="flights">The flights; their launches are both start and result.</param>
    /// <param name="shares">The weight of each flight in the shared parameters.</param>
    /// <param name="watch">Cancels the search.</param>
    public void Descend(IReadOnlyList<FlightPath> flights, double[] shares, FitWatch watch)
    {
        // 1. The normal equations of every flight. 2. Solve the reduced system for the shared parameters, then for each launch. 3. Accept a lower
        // cost; otherwise retry with more damping.
        double damping = FirstDamping;
        double cost = double.PositiveInfinity;
        var normals = new double[flights.Count][];
        var gradients = new double[flights.Count][];
        double[] changed = new double[_shared];
        var launches = new double[flights.Count][];
        for (int i = 0; i < flights.Count; i++)
        {
            normals[i] = new double[_size * _size];
            gradients[i] = new double[_size];
            launches[i] = new double[Launch];
        }

        bool fresh = true;
        for (int step = 0; step < MostSteps && flights.Count > 0; step++)
        {
            watch.Check();
            if (fresh)
            {
                Cost = cost = Evaluate(flights, shares, normals, gradients, watch);
                fresh = false;
            }

            double tried = Try(flights, shares, normals, gradients, damping, changed, launches, watch, out Simulator? there);
            if (tried < cost)
            {
                bool done = cost - tried < LeastGain * cost;
                Array.Copy(changed, Values, _shared);
                for (int i = 0; i < flights.Count; i++)
                {
                    Array.Copy(launches[i], flights[i].Values, Launch);
                }

                At = there!;
                Cost = tried;
                if (done)
                {
                    break;
                }

                damping = Math.Max(LeastDamping, 0.1 * damping);
                fresh = true;
            }
            else if (damping < MostDamping)
            {
                damping *= 10;
            }
            else
            {
                break;
            }
        }

        foreach (FlightPath flight in flights)
        {
            _system.Measure(At, flight);
        }
    }

    /// <summary>Returns the weight of each flight; one that fits far worse than the others is not explained by the shared parameters.</summary>
    public static double[] Shares(IReadOnlyList<FlightPath> flights)
    {
        double[] shares = new double[flights.Count];
        double[] sorted = [.. flights.Select(flight => flight.Rms)];
        Array.Sort(sorted);
        double usual = sorted.Length > 0 ? sorted[sorted.Length / 2] : 0;
        for (int i = 0; i < shares.Length; i++)
        {
            double off = flights[i].Rms / (Strange * usual);
            shares[i] = off > 1 ? 1 / (off * off * off * off) : 1;
        }

        return shares;
    }

    /// <summary>Estimates the covariances of launches and shared parameters, from the scatter of each flight's residuals and their
    /// autocorrelation.</summary>
    public void MeasureUncertainty(IReadOnlyList<FlightPath> flights, double[] shares, FitWatch watch)
    {
        var normals = new double[flights.Count][];
        var gradients = new double[flights.Count][];
        double[] reduced = new double[flights.Count];
        for (int i = 0; i < flights.Count; i++)
        {
            normals[i] = new double[_size * _size];
            gradients[i] = new double[_size];
            reduced[i] = shares[i] / Math.Max(LeastScatter, Inflation(flights[i]));
        }

        _system.KeepsScatter = true;
        Evaluate(flights, shares, normals, gradients, watch);
        _system.KeepsScatter = false;
        double[] s = new double[_shared * _shared];
        double[] unused = new double[_shared];
        AddKnown(s, unused);
        var couplings = new double[flights.Count][];
        var off = new double[flights.Count][];
        for (int i = 0; i < flights.Count; i++)
        {
            _elimination.Invert(normals[i], flights[i].Covariance);
            off[i] = Times(flights[i].Covariance, flights[i].LowHeights);
            Variance(flights[i], out double misfit);
            double low = Math.Min(1, Math.Sqrt(misfit) / LowMisfit);
            for (int k = 0; k < Launch; k++)
            {
                off[i][k] *= low;
            }
            couplings[i] = _elimination.Couple(normals[i], flights[i].Covariance);
            _elimination.Eliminate(normals[i], gradients[i], couplings[i], reduced[i], s, unused);
        }

        Linear.Invert(s, Covariance, _shared);
        for (int f = 0; f < flights.Count; f++)
        {
            // Sum of three terms: the sandwich A⁻¹ (v JᵀW²J + P) A⁻¹ by the variance v of the residuals and the prior P; A⁻¹B S⁻¹ BᵀA⁻¹ by the shared
            // parameters; and d dᵀ with d = A⁻¹JᵀWb by the common height error b near the ground.
            double[] covariance = flights[f].Covariance;
            double[] sandwich = Sandwich(covariance, flights[f].Scatter, Variance(flights[f], out _));
            Vector3d known = _system.PerSpin(flights[f]);
            for (int i = 0; i < Launch; i++)
            {
                for (int j = 0; j < Launch; j++)
                {
                    double sum = sandwich[(i * Launch) + j] + (off[f][i] * off[f][j]);
                    for (int k = 0; k < 3; k++)
                    {
                        sum += covariance[(i * Launch) + 6 + k] * known.Along(k) * covariance[((6 + k) * Launch) + j];
                    }

                    for (int k = 0; k < _shared * _shared; k++)
                    {
                        sum += couplings[f][(i * _shared) + (k / _shared)] * Covariance[k] * couplings[f][(j * _shared) + (k % _shared)];
                    }

                    _scratch[(i * Launch) + j] = sum;
                }
            }

            Array.Copy(_scratch, covariance, covariance.Length);
        }
    }

    private double Evaluate(IReadOnlyList<FlightPath> flights, double[] shares, double[][] normals, double[][] gradients, FitWatch watch)
    {
        var shared = new Simulator[_shared];
        double[] differences = new double[_shared];
        double[] values = new double[_shared];
        for (int j = 0; j < _shared; j++)
        {
            Array.Copy(Values, values, _shared);
            differences[j] = _model.Difference(j);
            values[j] += differences[j];
            shared[j] = new Simulator(_model.Scene(values));
        }

        double cost = KnownCost(Values);
        for (int i = 0; i < flights.Count; i++)
        {
            watch.Check();
            cost += shares[i] * _system.Normal(At, shared, differences, flights[i], normals[i], gradients[i]);
        }

        return cost;
    }

    /// <summary>Computes a damped step.</summary>
    /// <returns>The cost after the step.</returns>
    private double Try(
        IReadOnlyList<FlightPath> flights, double[] shares, double[][] normals, double[][] gradients, double damping, double[] changed, double[][] launches, FitWatch watch,
        out Simulator? there)
    {
        double[] s = new double[_shared * _shared];
        double[] right = new double[_shared];
        AddKnown(s, right);
        var inverses = new double[flights.Count][];
        var couplings = new double[flights.Count][];
        for (int f = 0; f < flights.Count; f++)
        {
            // Damp by the matrix's own diagonal.
            double[] normal = (double[])normals[f].Clone();
            for (int i = 0; i < Launch; i++)
            {
                normal[(i * _size) + i] *= 1 + damping;
            }

            inverses[f] = new double[Launch * Launch];
            _elimination.Invert(normal, inverses[f]);
            couplings[f] = _elimination.Couple(normal, inverses[f]);
            _elimination.Eliminate(normal, gradients[f], couplings[f], shares[f], s, right);
        }

        for (int i = 0; i < _shared; i++)
        {
            s[(i * _shared) + i] *= 1 + damping;
        }

        double[] step = new double[_shared];
        there = null;
        if (!Linear.Solve(s, right, step, _shared))
        {
            return double.PositiveInfinity;
        }

        for (int i = 0; i < _shared; i++)
        {
            changed[i] = Values[i] + step[i];
        }

        _model.Bound(changed);
        there = new Simulator(_model.Scene(changed));
        double cost = KnownCost(changed);
        for (int f = 0; f < flights.Count; f++)
        {
            watch.Check();
            for (int i = 0; i < Launch; i++)
            {
                double sum = flights[f].Values[i];
                for (int j = 0; j < Launch; j++)
                {
                    sum += inverses[f][(i * Launch) + j] * gradients[f][j];
                }

                for (int j = 0; j < _shared; j++)
                {
                    sum -= couplings[f][(i * _shared) + j] * (changed[j] - Values[j]);
                }

                launches[f][i] = sum;
            }

            cost += TrackModel.IsLaunch(launches[f]) ? shares[f] * _system.Cost(there, flights[f], launches[f]) : double.PositiveInfinity;
        }

        return cost;
    }

    private double KnownCost(double[] values)
    {
        double cost = 0;
        for (int i = 0; i < _shared; i++)
        {
            double off = (values[i] - _model.Likely(i)) / _model.KnownDeviation(i);
            cost += off * off;
        }

        return cost;
    }

    private void AddKnown(double[] s, double[] right)
    {
        for (int i = 0; i < _shared; i++)
        {
            double weight = 1 / (_model.KnownDeviation(i) * _model.KnownDeviation(i));
            s[(i * _shared) + i] += weight;
            right[i] += weight * (_model.Likely(i) - Values[i]);
        }
    }

    /// <summary>True if successive residuals of a flight are alike, so that the laws do not describe it.</summary>
    public bool IsMisfit(FlightPath flight)
    {
        Variance(flight, out double misfit);
        return misfit > 0;
    }

    /// <summary>Returns the ratio of a flight's residual variance, including a misfit, to the assumed variance of a point.</summary>
    public double Inflation(FlightPath flight)
    {
        double variance = Variance(flight, out _);
        double assumed = _system.Deviation(in _system.Point(flight.First));
        return variance / (assumed * assumed);
    }

    /// <summary>Returns the variance of a flight's residuals that determines its deviations, in m².</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="misfit">The variance of a misfit of the laws, per coordinate, in m².</param>
    private double Variance(FlightPath flight, out double misfit)
    {
        Vector3d[] misses = _system.Misses(At, flight);
        double squares = 0;
        double products = 0;
        for (int i = 0; i < misses.Length; i++)
        {
            squares += misses[i].LengthSquared;
            products += i > 0 ? Vector3d.Dot(in misses[i], in misses[i - 1]) : 0;
        }

        // White noise has no likeness from one point to the next. A misfit of the laws has, and acts alike at many points, so that more points do not reduce it.
        double freedom = Math.Max(3, (3 * misses.Length) - Launch);
        double usual = squares / (3 * misses.Length);
        misfit = Math.Max(0, (products / (3 * misses.Length)) - (LikenessDeviations * usual / Math.Sqrt(3 * misses.Length)));
        return Math.Max(_system.Noise * _system.Noise, squares / freedom) + (CommonShare * misses.Length * misfit);
    }

    /// <summary>Returns v A⁻¹ M A⁻¹.</summary>
    private static double[] Sandwich(double[] inverse, double[] scatter, double variance)
    {
        double[] left = new double[Launch * Launch];
        double[] product = new double[Launch * Launch];
        for (int i = 0; i < Launch; i++)
        {
            for (int j = 0; j < Launch; j++)
            {
                for (int k = 0; k < Launch; k++)
                {
                    left[(i * Launch) + j] += inverse[(i * Launch) + k] * scatter[(k * Launch) + j];
                }
            }
        }

        for (int i = 0; i < Launch; i++)
        {
            for (int j = 0; j < Launch; j++)
            {
                for (int k = 0; k < Launch; k++)
                {
                    product[(i * Launch) + j] += variance * left[(i * Launch) + k] * inverse[(k * Launch) + j];
                }
            }
        }

        return product;
    }

    private static double[] Times(double[] matrix, double[] vector)
    {
        double[] product = new double[vector.Length];
        for (int i = 0; i < matrix.Length; i++)
        {
            product[i / vector.Length] += matrix[i] * vector[i % vector.Length];
        }

        return product;
    }
}
