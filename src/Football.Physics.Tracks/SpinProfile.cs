using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>Widens the deviations of a flight's spin as far as the flight fits with more spin.</summary>
/// <remarks>
/// The lift saturates: of a slow ball with 20 rad/s it is almost that with 80 rad/s. The slope at the fitted spin does not reveal this, so a spin's deviation
/// is at least a third of the distance at which the cost has risen by the square of three deviations. Other spins have other places and velocities: for each,
/// these follow from one linear step, because the derivatives by them hardly depend on the spin.
/// </remarks>
internal sealed class SpinProfile
{
    /// <summary>The deviations at which the cost is compared.</summary>
    private const double Deviations = 3;

    /// <summary>The largest change of a spin, in rad/s, and the number of steps that halve its range.</summary>
    private const double MostChange = 240;
    private const double Growth = 1.6;
    private const int Halvings = 4;

    /// <summary>The other spins that are tried, in rad/s, and the gain, in squared deviations, from which one is fitted.</summary>
    private static readonly double[] OtherSpins = [40, 80, 120];
    private const double LeastGain = 1;

    /// <summary>The number of the parameters of the launch without the spin: position and velocity. The doubted laws of the ball follow.</summary>
    private const int Motion = 6;

    /// <summary>The difference for derivatives by the velocity, in m/s.</summary>
    private const double VelocityStep = 0.02;

    private readonly ParameterDoubt[] _doubts;
    private readonly double[] _values = new double[FlightPath.Launch];
    private readonly double[] _change = new double[FlightPath.Launch];
    private readonly double[] _inverse;
    private readonly double[] _pull;
    private readonly Vector3d[][] _slopes;
    private readonly int _free;
    private readonly FlightEquations _equations;
    private readonly SharedFit _fit;
    private readonly Vector3d[] _axes = new Vector3d[4];
    private Vector3d[] _weights = [];
    private double _scale;

    /// <summary>Creates profiles for the flights of a fit.</summary>
    /// <param name="equations">The equations of the flights.</param>
    /// <param name="fit">The fit, with the doubts about the laws of the ball.</param>
    public SpinProfile(FlightEquations equations, SharedFit fit)
    {
        (_equations, _fit) = (equations, fit);
        _doubts = fit.Doubts;
        _free = Motion + _doubts.Length;
        _slopes = new Vector3d[_free - 3][];
        _inverse = new double[_free * _free];
        _pull = new double[_free];
    }

    /// <summary>Fits a flight again from the other spin that fits it best, if one fits better: strong and weak spin can bend a slow ball alike.</summary>
    /// <param name="flight">The flight.</param>
    /// <param name="descend">Fits the flight from its present launch.</param>
    public void Search(FlightPath flight, Action<FlightPath> descend)
    {
        if (!Linearize(flight))
        {
            return;
        }

        double least = Cost(flight, Vector3d.Zero);
        double lowest = least - LeastGain;
        double[] kept = flight.Values;
        double[]? best = null;
        foreach (Vector3d axis in _axes)
        {
            foreach (double change in OtherSpins)
            {
                double cost = Cost(flight, change * axis);
                if (cost < lowest)
                {
                    lowest = cost;
                    best = (double[])kept.Clone();
                    for (int i = 0; i < best.Length; i++)
                    {
                        best[i] += _change[i];
                    }
                }
            }
        }

        double rms = flight.Rms;
        if (best is null || !TrackModel.IsLaunch(best))
        {
            return;
        }

        flight.Values = best;
        descend(flight);
        if (flight.Rms >= rms)
        {
            flight.Values = kept;
            _equations.Measure(_fit.At, flight);
        }
    }

    /// <summary>Widens the covariance of a flight across its velocity, where the spin bends the path.</summary>
    public void Widen(FlightPath flight)
    {
        if (Linearize(flight))
        {
            double least = Cost(flight, Vector3d.Zero);
            foreach (Vector3d axis in _axes)
            {
                Widen(flight, axis, least);
            }
        }
    }

    private void Widen(FlightPath flight, Vector3d axis, double least)
    {
        // 1. The farthest spin of a coarse scan that still fits. 2. Halve the range beyond it. 3. Add the square of the change there.
        double told = Deviation(flight.Covariance, axis);
        if (!(told > 0))
        {
            return;
        }

        double low = 0;
        double high = 0;
        for (double change = Deviations * told; change < MostChange; change *= Growth)
        {
            if (Rise(change) < 0)
            {
                (low, high) = (change, Growth * change);
            }
        }

        for (int i = 0; i < Halvings && low > 0; i++)
        {
            double middle = 0.5 * (low + high);
            (low, high) = Rise(middle) < 0 ? (middle, high) : (low, middle);
        }

        if (low > 0)
        {
            Rise(low);
            double deviation = low / Deviations;
            double added = (1 - (told * told / (deviation * deviation))) / (Deviations * Deviations);
            for (int i = 0; i < flight.Covariance.Length; i++)
            {
                flight.Covariance[i] += added * _change[i / FlightPath.Launch] * _change[i % FlightPath.Launch];
            }
        }

        double Rise(double change) => Cost(flight, change * axis) - least - (Deviations * Deviations);
    }

    private static double Deviation(double[] covariance, Vector3d axis)
    {
        double sum = 0;
        for (int i = 0; i < 9; i++)
        {
            sum += covariance[((Motion + (i / 3)) * FlightPath.Launch) + Motion + (i % 3)] * axis.Along(i / 3) * axis.Along(i % 3);
        }

        return Math.Sqrt(Math.Max(0, sum));
    }

    /// <summary>Evaluates the derivatives by position and velocity, the weights of the points, and the axes across the velocity.</summary>
    /// <returns>False for a ball that moves straight up or down.</returns>
    private bool Linearize(FlightPath flight)
    {
        Vector3d v = flight.Velocity;
        Vector3d aside = Vector3d.Cross(Vector3d.Up, in v);
        if (aside.Length <= 1e-3 * v.Length)
        {
            return false;
        }

        aside /= aside.Length;
        Vector3d up = Vector3d.Cross(in v, in aside) / v.Length;
        (_axes[0], _axes[1], _axes[2], _axes[3]) = (aside, -aside, up, -up);
        int count = flight.Count;
        Vector3d[] misses = _equations.Misses(_fit.At, flight, flight.Values);
        double[] steps = new double[_slopes.Length];
        for (int k = 0; k < _slopes.Length; k++)
        {
            Array.Copy(flight.Values, _values, _values.Length);
            steps[k] = VelocityStep;
            Simulator at = k < 3 ? _fit.At : _fit.Changed(_doubts[k - 3].Parameter, out steps[k]);
            _values[k < 3 ? 3 + k : 3] += k < 3 ? VelocityStep : 0;
            _slopes[k] = _equations.Misses(at, flight, _values);
        }

        _weights = new Vector3d[count];
        double[] normal = new double[_free * _free];
        for (int i = 0; i < count; i++)
        {
            _weights[i] = _equations.Weights(in _equations.Point(flight.First + i), in misses[i]);
            for (int k = 0; k < _slopes.Length; k++)
            {
                _slopes[k][i] = (misses[i] - _slopes[k][i]) / steps[k];
            }

            for (int j = 0; j < normal.Length; j++)
            {
                Vector3d left = Slope(j / _free, i);
                Vector3d right = Slope(j % _free, i);
                normal[j] += (left.X * right.X * _weights[i].X) + (left.Y * right.Y * _weights[i].Y) + (left.Z * right.Z * _weights[i].Z);
            }
        }

        for (int k = 0; k < _doubts.Length; k++)
        {
            normal[(Motion + k) * (_free + 1)] += _fit.Inflation(flight) / (_doubts[k].Deviation * _doubts[k].Deviation);
        }

        Linear.Invert(normal, _inverse, _free);
        _scale = 1 / _fit.Inflation(flight);
        return true;
    }

    private Vector3d Slope(int parameter, int point) => parameter < 3 ? Vector3d.Axis(parameter) : _slopes[parameter - 3][point];

    /// <summary>Returns the least cost of a flight with another spin, in squared deviations, and sets the change of the launch.</summary>
    private double Cost(FlightPath flight, Vector3d change)
    {
        Array.Copy(flight.Values, _values, _values.Length);
        Array.Clear(_change, 0, _change.Length);
        Array.Clear(_pull, 0, _free);
        for (int k = 0; k < 3; k++)
        {
            _change[Motion + k] = change.Along(k);
            _values[Motion + k] += change.Along(k);
        }

        double cost = 0;
        Vector3d[] misses = _equations.Misses(_fit.At, flight, _values);
        for (int i = 0; i < misses.Length; i++)
        {
            Vector3d weighted = new(misses[i].X * _weights[i].X, misses[i].Y * _weights[i].Y, misses[i].Z * _weights[i].Z);
            cost += Vector3d.Dot(in weighted, in misses[i]);
            for (int k = 0; k < _free; k++)
            {
                _pull[k] += Vector3d.Dot(Slope(k, i), in weighted);
            }
        }

        for (int i = 0; i < _inverse.Length; i++)
        {
            double step = _inverse[i] * _pull[i % _free];
            cost -= _pull[i / _free] * step;
            if (i / _free < Motion)
            {
                _change[i / _free] += step;
            }
        }

        Vector3d off = flight.Spin + change - flight.LikelySpin;
        Vector3d known = _equations.PerSpin(flight);
        return (_scale * cost) + (known.X * off.X * off.X) + (known.Y * off.Y * off.Y) + (known.Z * off.Z * off.Z);
    }
}
