namespace Football.Physics.Tracks;

/// <summary>The launch that a track tells of, and how surely. Numbers in a row are: position, velocity, spin of the launch, then the factors that were asked for.</summary>
public sealed class TrackFitResult
{
    /// <summary>1/√2: the track tells as much as was known before.</summary>
    private const double Identified = 0.7071067811865476;

    private readonly double[] _values;
    private readonly double[] _covariance;

    private readonly TrackModel _model;

    internal TrackFitResult(TrackModel model, double[] values, double[] covariance, double time, double chiSquared, int freedom, int iterations, bool converged)
    {
        _model = model;
        _values = values;
        _covariance = covariance;
        Time = time;
        ChiSquared = chiSquared;
        Freedom = freedom;
        Iterations = iterations;
        Converged = converged;
    }

    /// <summary>Names of the numbers.</summary>
    public IReadOnlyList<string> Names => _model.Names;

    /// <summary>When the launch was: the time of the track's first point, s.</summary>
    public double Time { get; }

    /// <summary>Where the ball was then, m.</summary>
    public Vector3d Position => new(_values[0], _values[1], _values[2]);

    /// <summary>Its velocity then, m/s.</summary>
    public Vector3d Velocity => new(_values[3], _values[4], _values[5]);

    /// <summary>Its spin then, rad/s.</summary>
    public Vector3d Spin => new(_values[6], _values[7], _values[8]);

    /// <summary>Σ (seen − fitted)²/noise² over all coordinates: about <see cref="Freedom"/> where scene and noise are as they were said to be.</summary>
    public double ChiSquared { get; }

    /// <summary>Coordinates seen less numbers found.</summary>
    public int Freedom { get; }

    /// <summary>Steps of the search.</summary>
    public int Iterations { get; }

    /// <summary>Whether the search ended where neither a step nor a way out along the uncertainty leads to what fits better.</summary>
    public bool Converged { get; }

    /// <summary>A number.</summary>
    /// <param name="index">Which, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such number.</exception>
    public double Value(int index)
    {
        Check.Index(nameof(index), index, _values.Length);
        return _values[index];
    }

    /// <summary>Its standard deviation.</summary>
    /// <param name="index">Which, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such number.</exception>
    public double Deviation(int index)
    {
        Check.Index(nameof(index), index, _values.Length);
        return Math.Sqrt(Math.Max(0, _covariance[(index * _values.Length) + index]));
    }

    /// <summary>
    /// Whether the track tells more of a number than was known before (its deviation is less than 0.7 of that before): not of a restitution where nothing bounces, nor of a
    /// spin along the way. What is not identified is as it was said to be before, not found.
    /// </summary>
    /// <param name="index">Which, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such number.</exception>
    public bool IsIdentified(int index) => Deviation(index) < Identified * _model.KnownDeviation(index);

    /// <summary>The covariance of two numbers.</summary>
    /// <param name="row">One, from 0.</param>
    /// <param name="column">The other, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such number.</exception>
    public double Covariance(int row, int column)
    {
        Check.Index(nameof(row), row, _values.Length);
        Check.Index(nameof(column), column, _values.Length);
        return _covariance[(row * _values.Length) + column];
    }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant(
        $"{(Converged ? "converged" : "not converged")}: {Velocity:0.###} m/s, {Spin:0.###} rad/s from {Position:0.###}, χ² {ChiSquared:0.##} of {Freedom}");
}
