namespace FootballPhysics.Tracks;

/// <summary>Searches for the minimum of a fit, and measures its uncertainty along each axis.</summary>
/// <remarks>It moves along an axis, with the earlier parameters following, until the cost has risen by one.</remarks>
internal sealed class TrackSearch
{
    private const int MostSteps = 60;
    private const double FirstDamping = 0.1;
    private const double LeastDamping = 1e-2;
    private const double LessDamping = 0.1;

    /// <summary>The damping for one viewpoint, where costs have long curved valleys.</summary>
    private const double FirstValleyDamping = 1e-3;
    private const double LeastValleyDamping = 2e-3;
    private const double LessValleyDamping = 0.2;

    /// <summary>The gain of a step below which the search ends.</summary>
    private const double LeastGain = 0.02;

    /// <summary>The decrease of the cost at which the search restarts from the measurement, and the maximum number of restarts.</summary>
    private const double Lower = 0.1;
    private const int MostSearches = 8;
    private const int MostValleySearches = 40;

    /// <summary>The maximum number of tries to find a rise by one, the accepted range of rises, and the maximum factor between tries.</summary>
    private const int MostTries = 4;
    private const double LeastRise = 0.6;
    private const double LargestRise = 1.6;
    private const double LargestChange = 4;

    /// <summary>The steps of the parameters that follow: their number, the minimum gain, the number of shortenings, and the factor of each.</summary>
    private const int MostFollowing = 6;
    private const double LeastFollowing = 0.05;
    private const int MostShortenings = 3;
    private const double Shorter = 0.4;

    /// <summary>The first parameter whose axis is measured, and the first whose pairs of axes are: positions are nearly linear, velocities almost.</summary>
    private const int FirstMeasured = 3;
    private const int FirstPaired = TrackModel.FirstSpin;

    private readonly TrackPaths _paths;
    private readonly TrackSecants _secants;
    private readonly bool _isOneView;
    private readonly int _count;
    private readonly double[] _step;
    private readonly double[] _tried;
    private double[] _misses;
    private double[] _triedMisses;
    private bool _isFound;
    private bool _hasAxes;

    public TrackSearch(Sightings seen, TrackFitRequest request, TrackModel model, FitWatch watch)
    {
        Model = model;
        _paths = new TrackPaths(seen, request, model, watch);
        _secants = new TrackSecants(_paths, model);
        _isOneView = seen.IsOneView;
        _count = model.Count;
        _step = new double[_count];
        _tried = new double[_count];
        _misses = new double[_paths.Rows];
        _triedMisses = new double[_paths.Rows];
        Covariance = new double[_count * _count];
    }

    /// <summary>The parameters to estimate.</summary>
    public TrackModel Model { get; }

    /// <summary>The final cost.</summary>
    public double Cost { get; private set; }

    /// <summary>The number of search steps.</summary>
    public int Steps { get; private set; }

    /// <summary>The covariance matrix of the parameters.</summary>
    public double[] Covariance { get; }

    /// <summary>Returns the χ² of the observations, without the prior.</summary>
    public double ChiSquared(double[] values) => Cost - Model.KnownCost(values);

    /// <summary>Returns the residuals of the observations, in standard deviations.</summary>
    public double[] Misses(double[] values)
    {
        double[] misses = new double[_paths.Rows];
        _paths.Follow(values, misses);
        return misses;
    }

    /// <summary>Measures the uncertainty of the parameters; restarts the search if it finds a lower cost.</summary>
    /// <returns>True if neither a step nor the measurement finds a lower cost.</returns>
    public bool Measure(double[] values)
    {
        bool converged = _isFound;
        for (int i = 0; i < (_isOneView ? MostValleySearches : MostSearches) && _hasAxes; i++)
        {
            if (MeasureAxes(values))
            {
                return converged;
            }

            converged = Descend(values);
        }

        if (!_hasAxes)
        {
            Covariance.AsSpan().Fill(double.PositiveInfinity);
        }

        return false;
    }

    /// <summary>Minimises the cost by the Gauss–Newton method with secants.</summary>
    public bool Descend(double[] values)
    {
        _isFound = false;
        Cost = _paths.Follow(values, _misses);
        double damping = 0;
        for (int i = 0; i < MostSteps; i++)
        {
            // The secants are as wide as the uncertainty from the previous ones.
            _hasAxes = _secants.Evaluate(values);
            if (!_hasAxes)
            {
                return false;
            }

            for (bool better = false; !better;)
            {
                if (!_secants.Solve(values, _misses, _count, damping, _step, out double gain))
                {
                    return false;
                }

                if (gain < LeastGain)
                {
                    _isFound = true;
                    return true;
                }

                Steps++;
                better = Try(values, _count, 1.0, Cost, out double cost);
                Cost = better ? cost : Cost;
                damping = !better ? Math.Max(_isOneView ? FirstValleyDamping : FirstDamping, 10 * damping)
                    : damping < (_isOneView ? LeastValleyDamping : LeastDamping) ? 0 : (_isOneView ? LessValleyDamping : LessDamping) * damping;
            }
        }

        return false;
    }

    /// <summary>Measures the uncertainty along all axes.</summary>
    /// <returns>False if a lower cost was found; the parameters are then those.</returns>
    private bool MeasureAxes(double[] values)
    {
        // 1. Move out along each axis, with the earlier parameters following, until the cost has risen by one. 2. Both ends give deviation and
        // curvature. 3. Measure pairs of axes whose joint effect may be nonlinear, such as spin and lift.
        Array.Clear(Covariance, 0, Covariance.Length);
        double best = Cost;
        double[] bend = new double[_count];
        double[] bends = new double[_count];
        double[] half = new double[_count];
        double[] low = new double[_count];
        double[][] ends = new double[_count][];
        for (int j = _count - 1; j >= 0; j--)
        {
            if (j < FirstMeasured)
            {
                AddSquare(1.0, _secants.Axes[j]);
                continue;
            }

            double[] high = ends[j] = new double[_count];
            double share = 1;
            double other = -1;
            if (!GoOut(values, j, best, high, ref share) || !GoOut(values, j, best, low, ref other))
            {
                return false;
            }

            // x(t) = x + d t + c t² with standard normal t: E[(d t + c t²)²] = d² + 3 c², and c₁ c₂ for two axes.
            for (int i = 0; i < _count; i++)
            {
                half[i] = 0.5 * (high[i] - low[i]);
                bend[i] = (0.5 * (high[i] + low[i])) - values[i];
                bends[i] += bend[i];
            }

            AddSquare(1.0, half);
            AddSquare(2.0, bend);
            for (int k = j + 1; k < _count && j >= FirstPaired; k++)
            {
                // The joint effect of two axes, c t₁ t₂.
                for (int i = 0; i < _count; i++)
                {
                    low[i] = ends[k][i] + (share * _secants.Axes[j][i]);
                }

                Settle(low, j);
                for (int i = 0; i < _count; i++)
                {
                    bend[i] = low[i] - ends[k][i] - high[i] + values[i];
                }

                AddSquare(1.0, bend);
            }
        }

        AddSquare(1.0, bends);
        return true;
    }

    /// <summary>Moves out along an axis until the cost has risen by one.</summary>
    /// <param name="values">The start.</param>
    /// <param name="axis">The index of the axis.</param>
    /// <param name="best">The cost at the start.</param>
    /// <param name="end">Receives the end.</param>
    /// <param name="share">The initial share of the axis; on return, the final one.</param>
    /// <returns>False if a lower cost was found; the parameters are then those.</returns>
    private bool GoOut(double[] values, int axis, double best, double[] end, ref double share)
    {
        double next = share;
        double rise = 0;
        for (int i = 0; i < MostTries; i++)
        {
            share = next;
            for (int k = 0; k < _count; k++)
            {
                end[k] = values[k] + (share * _secants.Axes[axis][k]);
            }

            rise = Settle(end, axis) - best;
            if (rise < -Lower)
            {
                Array.Copy(end, values, _count);
                return false;
            }

            if (rise > LeastRise && rise < LargestRise)
            {
                return true;
            }

            next = share * Math.Min(LargestChange, Math.Max(1.0 / LargestChange, 1.0 / Math.Sqrt(Math.Max(1e-3, rise))));
        }

        if (rise < LargestRise)
        {
            return true;
        }

        // The cost rises steeply next to the minimum. Keep the axis, whose deviation is that of a smooth cost.
        share = Math.Sign(share);
        for (int k = 0; k < _count; k++)
        {
            end[k] = values[k] + (share * _secants.Axes[axis][k]);
        }

        return true;
    }

    /// <summary>Lets the parameters before a given one follow it, with the secants at the best parameters.</summary>
    /// <returns>The cost.</returns>
    private double Settle(double[] values, int held)
    {
        double cost = _paths.Follow(values, _misses);
        for (int i = 0; i < MostFollowing && _secants.Solve(values, _misses, held, 0, _step, out double gain) && gain >= LeastFollowing; i++)
        {
            bool better = false;
            double share = 1;
            for (int tries = 0; tries < MostShortenings && !better; tries++, share *= Shorter)
            {
                better = Try(values, held, share, cost, out double lower);
                cost = better ? lower : cost;
            }

            if (!better)
            {
                break;
            }
        }

        return cost;
    }

    /// <summary>Takes a share of the step of the first parameters if it lowers the cost.</summary>
    private bool Try(double[] values, int free, double share, double cost, out double lower)
    {
        for (int i = 0; i < _count; i++)
        {
            _tried[i] = values[i] + (i < free ? share * _step[i] : 0);
        }

        lower = TrackModel.IsLaunch(_tried) ? _paths.Follow(_tried, _triedMisses) : double.PositiveInfinity;
        if (!(lower < cost))
        {
            return false;
        }

        Array.Copy(_tried, values, _count);
        (_misses, _triedMisses) = (_triedMisses, _misses);
        return true;
    }

    private void AddSquare(double weight, double[] v)
    {
        for (int i = 0; i < _count; i++)
        {
            for (int j = 0; j < _count; j++)
            {
                Covariance[(i * _count) + j] += weight * v[i] * v[j];
            }
        }
    }
}
