namespace FootballPhysics.Tracks;

/// <summary>The launch that a track tells of, and how surely. Numbers in a row are: position, velocity, spin of the launch, then the factors that were asked for.</summary>
public sealed class TrackFitResult
{
    /// <summary>1/√2: the track tells as much as was known before.</summary>
    private const double Identified = 0.7071067811865476;

    /// <summary>Of a χ² that is likelier than this nothing is said.</summary>
    private const double Rare = 1e-3;

    /// <summary>A ball whose cost is lower by this fits better, and one whose is higher by no more than that fits no worse: two, and three deviations of one number.</summary>
    private const double LikelierBy = 4;
    private const double AsGood = 9;

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
        DegreesOfFreedom = freedom;
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

    /// <summary>Σ (seen − fitted)²/noise² over all coordinates: about <see cref="DegreesOfFreedom"/> where scene and noise are as they were said to be.</summary>
    public double ChiSquared { get; }

    /// <summary>Coordinates seen less numbers found.</summary>
    public int DegreesOfFreedom { get; }

    /// <summary>Steps of the search.</summary>
    public int Iterations { get; }

    /// <summary>True when the search ended where neither a step nor a way out along the uncertainty leads to what fits better.</summary>
    public bool Converged { get; }

    /// <summary>
    /// Spin of another launch that fits the track about as well (χ² with what was known before within 9), and differs by more than three deviations, rad/s: another bounce. Null where none
    /// was found.
    /// </summary>
    public Vector3d? OtherSpin { get; internal init; }

    /// <summary>Fits with the other balls (<see cref="TrackFitRequest.OtherBalls"/>).</summary>
    public IReadOnlyList<TrackFitByBall> ByBall { get; internal init; } = [];

    /// <summary>
    /// How likely so large a χ² is, or a larger one, where scene and noise are as they were said to be, 0 … 1 (Wilson and Hilferty's approximation): below 0.001 they are not.
    /// </summary>
    public double Probability => ProbabilityOf(ChiSquared);

    /// <summary>Verdict on the fit from χ² against its freedom, the search, other minima and other balls.</summary>
    public TrackVerdict Verdict =>
        !Converged ? TrackVerdict.NotConverged
        : Probability < Rare && !ByBall.Any(other => ProbabilityOf(other.ChiSquared) >= Rare) ? TrackVerdict.Poor
        : OtherSpin is not null && !(Probability < Rare) ? TrackVerdict.Ambiguous
        : ByBall.Any(other => other.DeltaChiSquared < -LikelierBy) ? TrackVerdict.OtherBall
        : Probability > 1.0 - Rare ? TrackVerdict.NoiseOverestimated
        : TrackVerdict.AsExpected;

    /// <summary>The verdict in a sentence, with its numbers.</summary>
    public string Explanation
    {
        get
        {
            string chi = FormattableString.Invariant($"χ² is {ChiSquared:0.0} of {DegreesOfFreedom} expected");
            return Verdict switch
            {
                TrackVerdict.NotConverged => $"{chi}; the search did not end: neither numbers nor deviations are to be relied on.",
                TrackVerdict.Poor => $"{chi}, which noise alone gives less than once in a thousand: the scene (ball, air, wind, ground) or the noise is not what was said. Deviations are those of noise alone; the truth may be many of them away.",
                TrackVerdict.Ambiguous => FormattableString.Invariant($"{chi}, but a spin of {OtherSpin:F1} rad/s fits about as well: another bounce. More points, or a known spin, tell them apart."),
                TrackVerdict.OtherBall => $"{chi}, but another ball fits better: deviations are too small; DeviationOverBalls has what the balls differ by.",
                TrackVerdict.NoiseOverestimated => $"{chi}, less than the noise that was said would leave: deviations are too large.",
                TrackVerdict.AsExpected => $"{chi}, as it should be. Deviations are those of noise alone: they hold for the scene that was given.",
                _ => throw Check.Unknown("verdict", Verdict),
            };
        }
    }

    /// <summary>
    /// Standard deviation of a number with what is not known of the ball: that of the noise, and the differences of the numbers between the balls that fit no worse (χ² within 9).
    /// Without other balls in the request it is <see cref="StandardError"/>.
    /// </summary>
    /// <param name="index">Which, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such number.</exception>
    public double DeviationOverBalls(int index)
    {
        double noise = StandardError(index);
        double squares = noise * noise;
        int fitting = 0;
        double off = 0;
        foreach (TrackFitByBall other in ByBall)
        {
            if (other.DeltaChiSquared <= AsGood)
            {
                double difference = other.Values[index] - _values[index];
                off += difference * difference;
                fitting++;
            }
        }

        return Math.Sqrt(squares + (fitting > 0 ? off / fitting : 0));
    }

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
    public double StandardError(int index)
    {
        Check.Index(nameof(index), index, _values.Length);
        return Math.Sqrt(Math.Max(0, _covariance[(index * _values.Length) + index]));
    }

    /// <summary>
    /// True when the track tells more of a number than was known before (its deviation is less than 0.7 of that before): not of a restitution where nothing bounces, nor of a
    /// spin along the way. What is not identified is as it was said to be before, not found.
    /// </summary>
    /// <param name="index">Which, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such number.</exception>
    public bool IsIdentified(int index) => StandardError(index) < Identified * _model.KnownDeviation(index);

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

    private double ProbabilityOf(double chiSquared)
    {
        // (χ²/f)^⅓ is about normal, of mean 1 − 2/(9f) and variance 2/(9f).
        double width = 2.0 / (9.0 * Math.Max(1, DegreesOfFreedom));
        double share = Math.Max(1e-300, chiSquared / Math.Max(1, DegreesOfFreedom));
        return 1.0 - NormalDistribution.Integral((Elementary.Pow(share, 1.0 / 3.0) - (1.0 - width)) / Math.Sqrt(width));
    }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant(
        $"{(Converged ? "converged" : "not converged")}: {Velocity:0.###} m/s, {Spin:0.###} rad/s from {Position:0.###}, χ² {ChiSquared:0.##} of {DegreesOfFreedom}");
}

/// <summary>Verdicts on a fit.</summary>
public enum TrackVerdict
{
    /// <summary>χ² is what the noise leaves.</summary>
    AsExpected = 0,

    /// <summary>χ² is larger than noise gives once in a thousand tracks: scene or noise is not what was said.</summary>
    Poor = 1,

    /// <summary>χ² is smaller than noise leaves once in a thousand tracks: the noise is less than was said.</summary>
    NoiseOverestimated = 2,

    /// <summary>Another launch, with another bounce, fits about as well.</summary>
    Ambiguous = 3,

    /// <summary>One of the other balls fits better.</summary>
    OtherBall = 4,

    /// <summary>The search did not end at a minimum.</summary>
    NotConverged = 5,
}

/// <summary>A fit with another ball.</summary>
/// <param name="Ball">The ball.</param>
/// <param name="Values">Its numbers, in the order of <see cref="TrackFitResult.Names"/>.</param>
/// <param name="ChiSquared">Its χ².</param>
/// <param name="DeltaChiSquared">How much worse it fits, χ² with what was known before; negative where it fits better.</param>
public sealed record TrackFitByBall(BallProperties Ball, IReadOnlyList<double> Values, double ChiSquared, double DeltaChiSquared);
