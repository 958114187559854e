using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The least-squares equations of flights, for each launch and for the parameters that all flights share.</summary>
/// <param name="track">The track.</param>
/// <param name="noise">The standard deviation of a coordinate from one point to the next, in m.</param>
/// <param name="deviation">The standard deviation of a coordinate, in m: noise and model error.</param>
/// <param name="spinDeviation">The prior standard deviation of a spin component, in rad/s.</param>
internal sealed class FlightEquations(TrackPoint[] track, double noise, double deviation, double spinDeviation)
{
    private const int Launch = FlightPath.Launch;

    /// <summary>The differences for derivatives with respect to a launch's velocity, in m/s, and spin, in rad/s.</summary>
    private const double VelocityStep = 0.02;
    private const double SpinStep = 1;

    /// <summary>The distance, in standard deviations, beyond which points are down-weighted (Huber).</summary>
    private const double Outlier = 4;

    /// <summary>The error of heights at the ground, in m, and the height above the ground at which it has fallen to 0, in m.</summary>
    /// <remarks>The causes are crowned pitches, and cameras with a ball in the grass.</remarks>
    private const double NearGround = 0.05;
    private const double Low = 0.5;

    /// <summary>The longest step, in s.</summary>
    private const double LongestStep = 0.04;

    private readonly StepLog _log = new();
    private readonly double[] _changed = new double[Launch];
    private Vector3d[] _lefts = [];
    private Vector3d[] _path = [];
    private Vector3d[] _other = [];

    /// <summary>The height of the ball's centre on the ground, in m, once known; heights near the ground have an additional error.</summary>
    public double Contact { get; set; } = double.NegativeInfinity;

    /// <summary>Simulates a flight from its launch.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="flight">The flight.</param>
    /// <param name="values">The launch.</param>
    /// <param name="path">Receives the position at each point.</param>
    /// <returns>The state of the ball at the last point.</returns>
    public BallState Follow(Simulator simulator, FlightPath flight, double[] values, Vector3d[] path)
    {
        BallState ball = simulator.LaunchAt(
            new Vector3d(values[0], values[1], values[2]), new Vector3d(values[3], values[4], values[5]), new Vector3d(values[6], values[7], values[8]), 0);
        for (int i = 0; i < flight.Count; i++)
        {
            double wait = i > 0 ? track[flight.First + i].Time - track[flight.First + i - 1].Time : 0;
            for (int parts = (int)Math.Ceiling(wait / LongestStep); parts > 0; parts--)
            {
                _log.Clear();
                double dt = wait / parts;
                simulator.Advance(ref ball, dt, _log);
                wait -= dt;
            }

            path[i] = ball.Position;
        }

        return ball;
    }

    /// <summary>Returns the cost of a flight: squared residuals in standard deviations, linear for outliers, plus the prior of the spin.</summary>
    public double Cost(Simulator simulator, FlightPath flight, double[] values)
    {
        Reserve(flight.Count);
        Follow(simulator, flight, values, _path);
        return Cost(flight, values, _path);
    }

    /// <summary>Computes the residual statistics of a flight.</summary>
    public void Measure(Simulator simulator, FlightPath flight)
    {
        Reserve(flight.Count);
        flight.Last = Follow(simulator, flight, flight.Values, _path);
        double sum = 0;
        double worst = 0;
        for (int i = 0; i < flight.Count; i++)
        {
            double square = (track[flight.First + i].Position - _path[i]).LengthSquared;
            sum += square;
            worst = Math.Max(worst, square);
        }

        flight.Rms = Math.Sqrt(sum / flight.Count);
        flight.Worst = Math.Sqrt(worst);
    }

    /// <summary>Returns the residuals of a flight's points for a launch, in m.</summary>
    public Vector3d[] Misses(Simulator simulator, FlightPath flight, double[] values)
    {
        Reserve(flight.Count);
        Follow(simulator, flight, values, _path);
        var misses = new Vector3d[flight.Count];
        for (int i = 0; i < misses.Length; i++)
        {
            misses[i] = track[flight.First + i].Position - _path[i];
        }

        return misses;
    }

    /// <summary>Assembles the normal equations of a flight.</summary>
    /// <param name="at">The scene.</param>
    /// <param name="shared">The scenes with each shared parameter changed; empty for the launch only.</param>
    /// <param name="differences">The changes.</param>
    /// <param name="flight">The flight.</param>
    /// <param name="normal">Receives JᵀWJ for launch and shared parameters, row by row.</param>
    /// <param name="gradient">Receives JᵀWr.</param>
    /// <param name="scatter">Receives JᵀW²J, the covariance of the gradient for residuals with a variance of 1 m²; null to skip it.</param>
    /// <param name="lowHeights">Receives JᵀWb for the common height error b near the ground; null to skip it.</param>
    /// <param name="secants">Half the widths of central differences for the spin, in rad/s; null for narrow forward differences.</param>
    /// <returns>The cost.</returns>
    public double Normal(
        Simulator at, Simulator[] shared, double[] differences, FlightPath flight, double[] normal, double[] gradient, double[]? scatter = null, double[]? lowHeights = null,
        Vector3d? secants = null)
    {
        // 1. The path, and one per changed parameter; the launch position only shifts the path. 2. The weighted rows of J. 3. The prior of the spin.
        int size = Launch + shared.Length;
        int count = flight.Count;
        Reserve(count);
        Follow(at, flight, flight.Values, _path);
        Vector3d[][] jacobian = Jacobian(at, shared, differences, flight, secants);
        Array.Clear(normal, 0, size * size);
        Array.Clear(gradient, 0, size);
        for (int i = 0; i < count; i++)
        {
            ref readonly TrackPoint point = ref track[flight.First + i];
            Vector3d miss = point.Position - _path[i];
            Vector3d weights = Weights(in point, in miss);
            for (int j = 0; j < size; j++)
            {
                Vector3d left = Weighted(j < 3 ? Vector3d.Axis(j) : jacobian[j][i], in weights);
                gradient[j] += Vector3d.Dot(in left, in miss);
                if (lowHeights is not null)
                {
                    lowHeights[j] += left.Y * Wrong(in point);
                }

                if (scatter is not null)
                {
                    AddScatter(scatter, size, j, in left);
                }

                for (int k = 0; k <= j; k++)
                {
                    normal[(j * size) + k] += k < 3 ? left.Along(k) : Vector3d.Dot(in left, in jacobian[k][i]);
                }
            }
        }

        Vector3d perSpin = PerSpin(flight);
        for (int j = 6; j < Launch; j++)
        {
            double known = perSpin.Along(j - 6);
            normal[(j * size) + j] += known;
            gradient[j] += known * (flight.LikelySpin.Along(j - 6) - flight.Values[j]);
        }

        for (int j = 0; j < size; j++)
        {
            for (int k = j + 1; k < size; k++)
            {
                normal[(j * size) + k] = normal[(k * size) + j];
            }
        }

        return Cost(flight, flight.Values, _path);
    }

    private void AddScatter(double[] scatter, int size, int row, in Vector3d left)
    {
        if (_lefts.Length < size)
        {
            _lefts = new Vector3d[size];
        }

        _lefts[row] = left;
        for (int k = 0; k <= row; k++)
        {
            double product = Vector3d.Dot(in left, in _lefts[k]);
            scatter[(row * size) + k] += product;
            scatter[(k * size) + row] += k < row ? product : 0;
        }
    }

    /// <summary>Returns the derivatives of the path, from one path per changed parameter; none for the launch position.</summary>
    private Vector3d[][] Jacobian(Simulator at, Simulator[] shared, double[] differences, FlightPath flight, Vector3d? secants)
    {
        int size = Launch + shared.Length;
        int count = flight.Count;
        var jacobian = new Vector3d[size][];
        Vector3d[] opposite = secants is null ? [] : new Vector3d[count];
        for (int j = 3; j < size; j++)
        {
            jacobian[j] = new Vector3d[count];
            Array.Copy(flight.Values, _changed, Launch);
            bool isCentral = secants is not null && j is >= 6 and < Launch;
            double step = isCentral ? secants!.Value.Along(j - 6) : j < 6 ? VelocityStep : j < Launch ? SpinStep : differences[j - Launch];
            if (j < Launch)
            {
                _changed[j] += step;
            }

            Follow(j < Launch ? at : shared[j - Launch], flight, _changed, _other);
            if (isCentral)
            {
                _changed[j] -= 2 * step;
                Follow(at, flight, _changed, opposite);
            }

            for (int i = 0; i < count; i++)
            {
                jacobian[j][i] = isCentral ? (_other[i] - opposite[i]) / (2 * step) : (_other[i] - _path[i]) / step;
            }
        }

        return jacobian;
    }

    /// <summary>The standard deviation of a coordinate from one point to the next, in m.</summary>
    public double Noise => noise;

    /// <summary>Returns a point of the track.</summary>
    public ref readonly TrackPoint Point(int index) => ref track[index];

    /// <summary>Returns the standard deviation of a point's coordinates, in m.</summary>
    public double Deviation(in TrackPoint point) => Math.Max(deviation, point.Noise);

    /// <summary>Returns the weights of the coordinates of a point with a residual, in 1/m²; less for an outlier.</summary>
    public Vector3d Weights(in TrackPoint point, in Vector3d miss)
    {
        double across = Deviation(in point);
        double up = HeightDeviation(in point);
        double weight = Huber.Weight(Off(in miss, across, up), Outlier);
        return new Vector3d(weight / (across * across), weight / (up * up), weight / (across * across));
    }

    /// <summary>Returns the standard deviation of a point's height, in m.</summary>
    private double HeightDeviation(in TrackPoint point)
    {
        double noise = Deviation(in point);
        double wrong = Wrong(in point);
        return Math.Sqrt((noise * noise) + (wrong * wrong));
    }

    /// <summary>Returns the error of a height near the ground, in m, which is common to all points.</summary>
    private double Wrong(in TrackPoint point)
    {
        double over = Math.Max(0, point.Position.Y - Contact);
        return over < Low ? NearGround * (1 - (over / Low)) : 0;
    }

    /// <summary>Returns the prior precision of each component of a flight's spin, 1/σ².</summary>
    public Vector3d PerSpin(FlightPath flight)
    {
        Vector3d likely = flight.LikelySpinDeviation;
        double any = 1 / (spinDeviation * spinDeviation);
        return likely == Vector3d.Zero ? new Vector3d(any, any, any) : new Vector3d(1 / (likely.X * likely.X), 1 / (likely.Y * likely.Y), 1 / (likely.Z * likely.Z));
    }

    private static double Off(in Vector3d miss, double across, double up) =>
        Math.Sqrt((((miss.X * miss.X) + (miss.Z * miss.Z)) / (across * across)) + (miss.Y * miss.Y / (up * up)));

    private static Vector3d Weighted(in Vector3d v, in Vector3d weights) => new(v.X * weights.X, v.Y * weights.Y, v.Z * weights.Z);

    private double Cost(FlightPath flight, double[] values, Vector3d[] path)
    {
        Vector3d spin = new Vector3d(values[6], values[7], values[8]) - flight.LikelySpin;
        double cost = Vector3d.Dot(Weighted(in spin, PerSpin(flight)), in spin);
        for (int i = 0; i < flight.Count; i++)
        {
            ref readonly TrackPoint point = ref track[flight.First + i];
            double off = Off(point.Position - path[i], Deviation(in point), HeightDeviation(in point));
            cost += Huber.Cost(off, Outlier);
        }

        return cost;
    }

    private void Reserve(int count)
    {
        if (_path.Length < count)
        {
            _path = new Vector3d[2 * count];
            _other = new Vector3d[2 * count];
        }
    }
}
