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

    /// <summary>The misfit per coordinate, in m, from which heights near the ground are as wrong as on any pitch. Without a misfit, they are right.</summary>
    private const double LowMisfit = 0.008;

    /// <summary>The half widths of differences by the spin, in rad/s: limits, and as a multiple of its deviation.</summary>
    private const double LeastSecant = 1;
    private const double WidestSecant = 30;
    private const double SecantDeviations = 2;

    private readonly FlightEquations _system;
    private readonly MatchModel _model;
    private readonly int _shared;
    private readonly int _size;
    private readonly LaunchElimination _elimination;

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

    /// <summary>The standard deviations of the drag and of the lift of a single flight, as shares, if the laws of the ball are in doubt; they count in the deviations only. Default 0.</summary>
    public double DragDoubt { get; set; }

    public double LiftDoubt { get; set; }

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

    /// <summary>Estimates the covariances of launches and shared parameters, from the scatter of each flight's residuals and their likeness.</summary>
    public void MeasureUncertainty(IReadOnlyList<FlightPath> flights, double[] shares, FitWatch watch)
    {
        // The sandwich S⁻¹ (Σ w² T V Tᵀ + P) S⁻¹ of the scores and the prior P; then that of each launch.
        FlightScore[] scores = Scores(flights, shares, watch, wide: true);
        double[] inverse = new double[_shared * _shared];
        Solve(scores, 0, scores.Length, inverse, Covariance, new double[_shared]);
        for (int f = 0; f < flights.Count; f++)
        {
            scores[f].Launches(inverse, Covariance, flights[f].Covariance);
        }
    }

    /// <summary>Returns the equations of each flight at the present values, without its launch.</summary>
    /// <param name="flights">The flights.</param>
    /// <param name="shares">The weight of each flight in the shared parameters.</param>
    /// <param name="watch">Cancels the computation.</param>
    /// <param name="wide">True for derivatives by the spin as wide as its deviation: drag by spin has a kink at 0, which tells nothing of a spin far from it.</param>
    public FlightScore[] Scores(IReadOnlyList<FlightPath> flights, double[] shares, FitWatch watch, bool wide = false)
    {
        Simulator[] shared = Changed(out double[] differences);
        double[] normal = new double[_size * _size];
        double[] gradient = new double[_size];
        var scores = new FlightScore[flights.Count];
        for (int f = 0; f < scores.Length; f++)
        {
            watch.Check();
            double[] spread = new double[_size * _size];
            double[] low = new double[_size];
            _system.Normal(At, shared, differences, flights[f], normal, gradient, spread, low, wide ? Secants(flights[f]) : null);
            double variance = Variance(flights[f], out double misfit);
            double trusted = Math.Min(1, Math.Sqrt(misfit) / LowMisfit);
            for (int i = 0; i < spread.Length; i++)
            {
                spread[i] = (variance * spread[i]) + (trusted * trusted * low[i / _size] * low[i % _size]);
            }

            Vector3d known = _system.PerSpin(flights[f]);
            for (int k = 0; k < 3; k++)
            {
                spread[((6 + k) * _size) + 6 + k] += known.Along(k);
            }

            foreach (ParameterDoubt doubt in Doubts)
            {
                AddDoubt(doubt.Parameter, doubt.Deviation, normal, spread);
            }

            scores[f] = new FlightScore(_shared, normal, gradient, spread, shares[f]);
        }

        return scores;
    }

    /// <summary>Returns half the widths of the differences by the spin: several deviations, as far as these are known.</summary>
    private static Vector3d Secants(FlightPath flight)
    {
        double Width(int axis) => Math.Min(WidestSecant, Math.Max(LeastSecant, SecantDeviations * Math.Sqrt(Math.Max(0, flight.Covariance[(axis * Launch) + axis]))));
        return new Vector3d(Width(6), Width(7), Width(8));
    }

    /// <summary>The common parameters that differ from flight to flight, and their deviations.</summary>
    public ParameterDoubt[] Doubts
    {
        get
        {
            ParameterDoubt[] drag = DragDoubt > 0 && _model.DragAt >= 0 ? [new(_model.DragAt, DragDoubt * Values[_model.DragAt])] : [];
            ParameterDoubt[] lift = LiftDoubt > 0 && _model.LiftAt >= 0 ? [new(_model.LiftAt, LiftDoubt * Values[_model.LiftAt])] : [];
            return [.. drag, .. lift];
        }
    }

    /// <summary>Adds the covariance of the gradient for a parameter of the flight that differs from the common one.</summary>
    private void AddDoubt(int parameter, double deviation, double[] normal, double[] spread)
    {
        int at = Launch + parameter;
        for (int i = 0; i < spread.Length; i++)
        {
            spread[i] += deviation * deviation * normal[(i / _size * _size) + at] * normal[(i % _size * _size) + at];
        }
    }

    /// <summary>Solves the equations of a range of flights for the shared parameters.</summary>
    /// <param name="scores">The equations.</param>
    /// <param name="from">The first flight.</param>
    /// <param name="to">The flight after the last.</param>
    /// <param name="inverse">Receives the inverse information.</param>
    /// <param name="covariance">Receives the covariance.</param>
    /// <param name="step">Receives the change of the parameters.</param>
    public void Solve(FlightScore[] scores, int from, int to, double[] inverse, double[] covariance, double[] step)
    {
        double[] information = new double[_shared * _shared];
        double[] right = new double[_shared];
        AddKnown(information, right);
        double[] spread = new double[_shared * _shared];
        for (int i = 0; i < _shared; i++)
        {
            spread[(i * _shared) + i] = information[(i * _shared) + i];
        }

        for (int f = from; f < to; f++)
        {
            double share = scores[f].Share;
            for (int i = 0; i < spread.Length; i++)
            {
                information[i] += share * scores[f].Information[i];
                spread[i] += share * share * scores[f].Spread[i];
            }

            for (int i = 0; i < _shared; i++)
            {
                right[i] += share * scores[f].Score[i];
            }
        }

        Linear.Invert(information, inverse, _shared);
        if (_shared > 0)
        {
            FlightScore.Times(FlightScore.Times(inverse, spread, _shared, _shared), inverse, _shared, _shared).CopyTo(covariance, 0);
        }

        for (int i = 0; i < _shared; i++)
        {
            step[i] = 0;
            for (int j = 0; j < _shared; j++)
            {
                step[i] += inverse[(i * _shared) + j] * right[j];
            }
        }
    }

    private double Evaluate(IReadOnlyList<FlightPath> flights, double[] shares, double[][] normals, double[][] gradients, FitWatch watch)
    {
        Simulator[] shared = Changed(out double[] differences);
        double cost = KnownCost(Values);
        for (int i = 0; i < flights.Count; i++)
        {
            watch.Check();
            cost += shares[i] * _system.Normal(At, shared, differences, flights[i], normals[i], gradients[i]);
        }

        return cost;
    }

    /// <summary>Returns the scenes with each shared parameter changed.</summary>
    private Simulator[] Changed(out double[] differences)
    {
        var shared = new Simulator[_shared];
        differences = new double[_shared];
        for (int j = 0; j < _shared; j++)
        {
            shared[j] = Changed(j, out differences[j]);
        }

        return shared;
    }

    /// <summary>Returns the scene with one shared parameter changed.</summary>
    public Simulator Changed(int parameter, out double difference)
    {
        double[] values = (double[])Values.Clone();
        difference = _model.Difference(parameter);
        values[parameter] += difference;
        return new Simulator(_model.Scene(values));
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
        Vector3d[] off = _system.Misses(At, flight, flight.Values);
        double[] misses = new double[3 * off.Length];
        for (int i = 0; i < misses.Length; i++)
        {
            misses[i] = off[i / 3].Along(i % 3);
        }

        return ResidualVariance.Of(misses, 3, Launch, _system.Noise * _system.Noise, out misfit);
    }
}
