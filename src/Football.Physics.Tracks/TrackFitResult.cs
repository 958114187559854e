using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The launch estimated from a track, with its uncertainty.</summary>
/// <remarks>The parameters are, in order: position, velocity and spin of the launch, then the requested factors.</remarks>
public sealed class TrackFitResult
{
    /// <summary>1/√2: the track contributes as much information as the prior.</summary>
    private const double Identified = 0.7071067811865476;

    /// <summary>The standard errors of position and velocity from which on they are not identified, in m and m/s.</summary>
    private const double MostPlaceError = 0.5;
    private const double MostVelocityError = 2;

    /// <summary>The probability of a χ² below which the fit is suspicious.</summary>
    private const double Rare = 1e-3;

    /// <summary>The cost difference by which another ball fits better, and up to which one fits no worse: two and three standard deviations of one
    /// parameter.</summary>
    private const double LikelierBy = 4;
    private const double AsGood = 9;

    /// <summary>The growth of the deviations of pixels above which no law of a free ball describes them.</summary>
    private const double MostGrowth = 10;

    private readonly double[] _values;
    private readonly double[] _covariance;

    private readonly TrackModel _model;
    private readonly TrackCamera? _camera;
    private readonly double _noise;

    internal TrackFitResult(TrackModel model, double[] values, double[] covariance, Sightings seen, double chiSquared, int iterations, bool converged)
    {
        _model = model;
        _values = values;
        _covariance = covariance;
        _camera = seen.FirstCamera;
        Time = seen.Time(0);
        ChiSquared = chiSquared;
        DegreesOfFreedom = seen.Rows - model.Count;
        _noise = seen.Noise;
        Rms = Math.Sqrt(chiSquared / seen.Count) * _noise;
        Iterations = iterations;
        Converged = converged;
    }

    /// <summary>The names of the parameters.</summary>
    public IReadOnlyList<string> Names => _model.Names;

    /// <summary>The time of the launch, in s; equal to that of the first track point.</summary>
    public double Time { get; }

    /// <summary>The position at the launch, in m.</summary>
    public Vector3d Position => new(_values[0], _values[1], _values[2]);

    /// <summary>The velocity at the launch, in m/s.</summary>
    public Vector3d Velocity => new(_values[3], _values[4], _values[5]);

    /// <summary>The spin at the launch, in rad/s.</summary>
    public Vector3d Spin => new(_values[6], _values[7], _values[8]);

    /// <summary>The sum Σ (observed − fitted)²/noise² over all coordinates.</summary>
    /// <remarks>The sum is about <see cref="DegreesOfFreedom"/> if the scene and the noise are correct.</remarks>
    public double ChiSquared { get; }

    /// <summary>The number of observed coordinates minus the number of parameters.</summary>
    public int DegreesOfFreedom { get; }

    /// <summary>The number of search steps.</summary>
    public int Iterations { get; }

    /// <summary>True if neither a step nor the measurement of the uncertainty finds a better fit.</summary>
    public bool Converged { get; }

    /// <summary>The spin of another launch that fits the track about as well, in rad/s; null if none was found.</summary>
    /// <remarks>
    /// The χ² of that launch, including the prior, is within 9 of the best, and its spin differs by more than three standard deviations. The ball bounces
    /// differently in the two fits.
    /// </remarks>
    public Vector3d? OtherSpin { get; internal init; }

    /// <summary>The fits with the other balls (<see cref="TrackFitRequest.OtherBalls"/>).</summary>
    public IReadOnlyList<TrackFitByBall> ByBall { get; internal init; } = [];

    /// <summary>The probability of an equal or larger χ² if the scene and the noise are correct, 0 … 1.</summary>
    /// <remarks>The probability is computed by the approximation of Wilson and Hilferty. A value below 0.001 means that the scene or the noise is
    /// wrong.</remarks>
    public double Probability => ProbabilityOf(ChiSquared);

    internal bool IsPoor => Probability < Rare;

    /// <summary>True if noise gives a χ² as large as this one less than once in a thousand tracks.</summary>
    internal static bool IsRare(double chiSquared, int freedom) => ProbabilityOf(chiSquared, freedom) < Rare;

    /// <summary>The factor by which a misfit has increased the deviations that follow from the observations; 1 without a misfit.</summary>
    internal double Growth { get; init; } = 1;

    /// <summary>The answers that are reliable to within their standard errors, by the rule of <see cref="MatchFitResult.GoodFor"/>.</summary>
    /// <remarks>
    /// The launch needs a standard error of at most 1 m/s in each component of the velocity, and its spin of at most 20 rad/s in each component, including the
    /// uncertainty of the ball (<see cref="DeviationOverBalls"/>). Fitted factors of drag are reliable if <see cref="IsIdentified"/> is true, and so are those of
    /// the surface. Nothing is reliable if the fit did not converge, or if <see cref="Suspicions"/> names a fault.
    /// </remarks>
    public MatchAnswers GoodFor
    {
        get
        {
            if (!Converged || Suspicions != TrackSuspicions.None || !MatchVerdict.IsGoodLaunch(Deviations(3)) || IsLost(DepthError))
            {
                return MatchAnswers.None;
            }

            return MatchAnswers.Launches | (MatchVerdict.IsGoodSpin(Deviations(TrackModel.FirstSpin)) ? MatchAnswers.Spins : 0)
                | (IsFitted("drag") ? MatchAnswers.WindAndDrag : 0) | (IsFitted("restitution") || IsFitted("friction") ? MatchAnswers.Surface : 0);
        }
    }

    /// <summary>The suspected faults of the track: <see cref="TrackSuspicions.Misfit"/> or none. One flight does not reveal the others.</summary>
    /// <remarks>
    /// Deviations grow with a misfit, by the rule of match fits. Above it, no law of a free ball describes the track: the residuals exceed the greater of 2 cm and
    /// three times the noise by 5 cm; of pixels, the deviations have grown to more than ten times those of the noise.
    /// </remarks>
    public TrackSuspicions Suspicions => Growth > 1 && (_camera is null ? MatchVerdict.IsMisfit(Rms, _noise) : Growth > MostGrowth) ? TrackSuspicions.Misfit : TrackSuspicions.None;

    /// <summary>The root mean square distance of the points from the fitted path, in m; NaN for pixels.</summary>
    internal double Rms { get; }

    /// <summary>The verdict on the fit, from χ², the search, other minima and other balls.</summary>
    public TrackVerdict Verdict =>
        !Converged ? TrackVerdict.NotConverged
        : Probability < Rare && !ByBall.Any(other => ProbabilityOf(other.ChiSquared) >= Rare) ? TrackVerdict.Poor
        : OtherSpin is not null && !(Probability < Rare) ? TrackVerdict.Ambiguous
        : ByBall.Any(other => other.DeltaChiSquared < -LikelierBy) ? TrackVerdict.OtherBall
        : Probability > 1.0 - Rare ? TrackVerdict.NoiseOverestimated
        : TrackVerdict.AsExpected;

    /// <summary>The verdict in plain words with its numbers, and a depth that pixels do not reveal.</summary>
    public string Explanation => IsLost(DepthError) || IsLost(PathDepthError)
        ? FormattableString.Invariant($"{VerdictInWords} The pixels do not reveal the distance from the camera: ± {DepthError:0.##} m at the launch, up to ± {PathDepthError:0.##} m later. Do not use positions and velocities along the line of sight. If the ball starts on the ground, set FromGround. A bounce in the track, or a second camera, also reveals the distance.")
        : VerdictInWords;

    private string VerdictInWords
    {
        get
        {
            string chi = FormattableString.Invariant($"χ² is {ChiSquared:0.0} of {DegreesOfFreedom} expected");
            return Verdict switch
            {
                TrackVerdict.NotConverged => $"{chi}; the search did not end: neither numbers nor deviations are to be relied on.",
                TrackVerdict.Poor => FormattableString.Invariant($"{chi}, which noise alone gives less than once in a thousand: the scene (ball, air, wind, ground) or the noise is not what was said. Deviations have grown with the misfit, by a factor of {Growth:0.0}."),
                TrackVerdict.Ambiguous => FormattableString.Invariant($"{chi}, but a spin of {OtherSpin:F1} rad/s fits about as well: another bounce or, from one viewpoint, another curl. More points, another camera or a known spin tell them apart."),
                TrackVerdict.OtherBall => $"{chi}, but another ball fits better: deviations are too small; DeviationOverBalls has what the balls differ by.",
                TrackVerdict.NoiseOverestimated => $"{chi}, less than the noise that was said would leave: deviations are too large.",
                TrackVerdict.AsExpected => $"{chi}, as it should be. Deviations are those of noise alone: they hold for the scene that was given.",
                _ => throw Check.Unknown("verdict", Verdict),
            };
        }
    }

    /// <summary>Returns the standard deviation of a parameter including the uncertainty of the ball.</summary>
    /// <remarks>
    /// The deviation combines the noise with the differences between the balls that fit no worse (χ² within 9). If the request has no other balls, it equals
    /// <see cref="StandardError"/>.
    /// </remarks>
    /// <param name="index">The index of the parameter, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such parameter.</exception>
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

    /// <summary>Returns the value of a parameter.</summary>
    /// <param name="index">The index of the parameter, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such parameter.</exception>
    public double Value(int index)
    {
        Check.Index(nameof(index), index, _values.Length);
        return _values[index];
    }

    /// <summary>Returns the standard error of a parameter.</summary>
    /// <param name="index">The index of the parameter, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such parameter.</exception>
    public double StandardError(int index)
    {
        Check.Index(nameof(index), index, _values.Length);
        return Math.Sqrt(Math.Max(0, _covariance[(index * _values.Length) + index]));
    }

    /// <summary>Returns true if the fit converged and the track contains more information about a parameter than the prior.</summary>
    /// <remarks>
    /// The standard error is then less than 0.7 of the prior deviation. Position and velocity have no prior: their standard errors are then below 0.5 m and 2 m/s. A restitution without a bounce, or a spin along the velocity, is not
    /// identified: its value is the prior, not a result.
    /// </remarks>
    /// <param name="index">The index of the parameter, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such parameter.</exception>
    public bool IsIdentified(int index) => Converged && StandardError(index) < (index < 3 ? MostPlaceError : index < TrackModel.FirstSpin ? MostVelocityError : Identified * _model.KnownDeviation(index));

    /// <summary>The names of the quantities that the observations do not reveal: their values are no results.</summary>
    /// <remarks>
    /// They are the parameters for which <see cref="IsIdentified"/> is false, then <c>spin.alongVelocity</c>, the component of the spin along the launch velocity,
    /// and, for pixels, <c>position.depth</c>, the distance of the launch from the first camera along its axis, and <c>path.depth</c>, that distance later on the
    /// path. A distance is identified if its standard error is below 0.5 m.
    /// </remarks>
    public IReadOnlyList<string> Unidentified
    {
        get
        {
            List<string> names = [];
            for (int i = 0; i < _values.Length; i++)
            {
                if (!IsIdentified(i))
                {
                    names.Add(Names[i]);
                }
            }

            if (!Converged || !(SpinAlongVelocityError < Identified * _model.KnownDeviation(TrackModel.FirstSpin)))
            {
                names.Add("spin.alongVelocity");
            }

            if (IsLost(DepthError))
            {
                names.Add("position.depth");
            }

            if (IsLost(PathDepthError))
            {
                names.Add("path.depth");
            }

            return names;
        }
    }

    /// <summary>The standard error of the spin's component along the launch velocity, in rad/s.</summary>
    public double SpinAlongVelocityError => ErrorAlong(TrackModel.FirstSpin, Velocity.Length > 0 ? Velocity / Velocity.Length : Vector3d.Up);

    /// <summary>The standard error of the launch's distance from the first camera along its axis, in m; null for a track of positions.</summary>
    public double? DepthError => _camera is null ? null : ErrorAlong(0, _camera.Forward);

    /// <summary>The largest standard error of the ball's distance from the first camera along its axis, over the track, in m; null for a track of
    /// positions.</summary>
    /// <remarks>It can be much larger than <see cref="DepthError"/>: one camera hardly sees a curl towards itself.</remarks>
    public double? PathDepthError { get; internal init; }

    /// <summary>Returns the covariance of two parameters.</summary>
    /// <param name="row">The index of the first parameter, from 0.</param>
    /// <param name="column">The index of the second parameter, from 0.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such parameter.</exception>
    public double Covariance(int row, int column)
    {
        Check.Index(nameof(row), row, _values.Length);
        Check.Index(nameof(column), column, _values.Length);
        return _covariance[(row * _values.Length) + column];
    }

    private Vector3d Deviations(int first) => new(DeviationOverBalls(first), DeviationOverBalls(first + 1), DeviationOverBalls(first + 2));

    private bool IsFitted(string name)
    {
        int index = Array.IndexOf([.. Names], name);
        return index >= 0 && IsIdentified(index);
    }

    /// <summary>True for pixels that do not reveal a distance from the camera.</summary>
    private bool IsLost(double? error) => error is { } depth && !(Converged && depth < MostPlaceError);

    /// <summary>Returns the standard error of a vector's component along a unit vector.</summary>
    private double ErrorAlong(int first, in Vector3d axis) => ErrorAlong(_covariance, _values.Length, first, in axis);

    internal static double ErrorAlong(double[] covariance, int count, int first, in Vector3d axis)
    {
        ReadOnlySpan<double> n = [axis.X, axis.Y, axis.Z];
        double sum = 0;
        for (int i = 0; i < n.Length; i++)
        {
            for (int j = 0; j < n.Length; j++)
            {
                // Skip 0 · ∞ of a fit without covariances.
                sum += n[i] == 0 || n[j] == 0 ? 0 : n[i] * n[j] * covariance[((first + i) * count) + first + j];
            }
        }

        return double.IsNaN(sum) ? double.PositiveInfinity : Math.Sqrt(Math.Max(0, sum));
    }

    private double ProbabilityOf(double chiSquared) => ProbabilityOf(chiSquared, DegreesOfFreedom);

    private static double ProbabilityOf(double chiSquared, int freedom)
    {
        // (χ²/f)^⅓ is approximately normal, with mean 1 − 2/(9f) and variance 2/(9f).
        double width = 2.0 / (9.0 * Math.Max(1, freedom));
        double share = Math.Max(1e-300, chiSquared / Math.Max(1, freedom));
        return 1.0 - NormalDistribution.Integral((Elementary.Pow(share, 1.0 / 3.0) - (1.0 - width)) / Math.Sqrt(width));
    }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant(
        $"{(Converged ? "converged" : "not converged")}: {Velocity:0.###} m/s, {Spin:0.###} rad/s from {Position:0.###}, χ² {ChiSquared:0.##} of {DegreesOfFreedom}");
}

/// <summary>The verdicts on a fit.</summary>
public enum TrackVerdict
{
    /// <summary>χ² is consistent with the noise.</summary>
    AsExpected = 0,

    /// <summary>χ² is larger than noise produces once in 1000 tracks: the scene or the noise is wrong.</summary>
    Poor = 1,

    /// <summary>χ² is smaller than noise produces once in 1000 tracks: the actual noise is smaller than stated.</summary>
    NoiseOverestimated = 2,

    /// <summary>Another launch, which bounces differently, fits about as well.</summary>
    Ambiguous = 3,

    /// <summary>One of the other balls fits better.</summary>
    OtherBall = 4,

    /// <summary>The search did not end at a minimum.</summary>
    NotConverged = 5,
}

/// <summary>A fit with another ball.</summary>
public sealed class TrackFitByBall
{
    internal TrackFitByBall(BallProperties ball, IReadOnlyList<double> values, double chiSquared, double deltaChiSquared)
    {
        Ball = ball;
        Values = values;
        ChiSquared = chiSquared;
        DeltaChiSquared = deltaChiSquared;
    }

    /// <summary>The ball.</summary>
    public BallProperties Ball { get; }

    /// <summary>The parameters, in the order of <see cref="TrackFitResult.Names"/>.</summary>
    public IReadOnlyList<double> Values { get; }

    /// <summary>The χ² of the fit.</summary>
    public double ChiSquared { get; }

    /// <summary>The increase of χ², including the prior, over the main fit; negative if this ball fits better.</summary>
    public double DeltaChiSquared { get; }
}
