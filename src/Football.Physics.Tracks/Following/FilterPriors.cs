using FootballPhysics.Numerics;

namespace FootballPhysics.Tracks;

/// <summary>The distributions with which hypotheses start: means and covariances of position, velocity, spin, and the time of a kick.</summary>
internal sealed class FilterPriors(BallFilterSettings settings)
{
    /// <summary>The standard deviation of the position at a start, in m: by a position, and by a pixel.</summary>
    private const double StartDeviation = 10;
    private const double PixelStartDeviation = 30;

    /// <summary>The mean and the standard deviation of a height that no point shows, in m.</summary>
    private const double UnseenHeight = 1.5;

    /// <summary>The least standard deviations of a condensed start, for position, velocity and spin.</summary>
    private static readonly double[] Floor = [3e-4, 2e-3, 0.05];

    private readonly double[] _covariance = new double[FilterHypothesis.Motion * FilterHypothesis.Motion];

    /// <summary>Sets the distribution of a start at a point, without a path before it.</summary>
    public void SetStart(FilterHypothesis start, in FilterPoint point, in Vector3d guess, FilterStart kind)
    {
        Array.Clear(start.Prior, 0, start.Prior.Length);
        Array.Clear(start.Mean, 0, start.Mean.Length);
        double deviation = point.Kind == FilterPointKind.Pixel ? PixelStartDeviation : StartDeviation;
        for (int i = 0; i < 3; i++)
        {
            start.Mean[i] = guess.Along(i);
            start.Prior[(i * FilterHypothesis.Most) + i] = deviation * deviation;
        }

        SetMotion(start);
        Constrain(start, kind);
    }

    /// <summary>Sets the distribution of the height at a start that no point shows.</summary>
    public void SetHeight(FilterHypothesis start)
    {
        start.Mean[1] = UnseenHeight;
        start.Prior[FilterHypothesis.Most + 1] = UnseenHeight * UnseenHeight;
    }

    /// <summary>Sets the distribution of the upward velocity to one part of it.</summary>
    /// <returns>The mean of the part, in m/s.</returns>
    public double SetUpward(FilterHypothesis start, UpwardParts parts, int part)
    {
        const int Upward = 4;
        double mean = parts.Means[part] * settings.KickVelocity;
        double deviation = parts.Deviation * settings.KickVelocity;
        start.Mean[Upward] = mean;
        start.Prior[(Upward * FilterHypothesis.Most) + Upward] = deviation * deviation;
        return mean;
    }

    /// <summary>Sets the distribution of a kick between a moment of another hypothesis and the next.</summary>
    /// <param name="kick">The hypothesis of the kick.</param>
    /// <param name="before">The moment before the kick.</param>
    /// <param name="count">The number of parameters of the other hypothesis.</param>
    /// <param name="span">The time from that moment to the next, in s.</param>
    /// <param name="kind">The constraint of the motion after the kick.</param>
    public void SetKick(FilterHypothesis kick, FilterMoment before, int count, double span, FilterStart kind)
    {
        // The position of the path at the middle of the interval: P + T (Ppv + Pvp) + T² Pvv.
        double half = 0.5 * span;
        FilterMath.Covariance(before, count, _covariance);
        Array.Clear(kick.Prior, 0, kick.Prior.Length);
        Array.Clear(kick.Mean, 0, kick.Mean.Length);
        for (int i = 0; i < 3; i++)
        {
            for (int j = 0; j < 3; j++)
            {
                kick.Prior[(i * FilterHypothesis.Most) + j] = Part(i, j) + (half * (Part(i, j + 3) + Part(i + 3, j))) + (half * half * Part(i + 3, j + 3));
            }

            kick.Prior[(i * FilterHypothesis.Most) + i] += Floor[0] * Floor[0];
        }

        SetMotion(kick);
        kick.Mean[9] = before.Time + half;
        kick.Prior[(9 * FilterHypothesis.Most) + 9] = span * span / 12;
        Constrain(kick, kind);

        double Part(int i, int j) => _covariance[(i * FilterHypothesis.Motion) + j];
    }

    /// <summary>Sets the distribution of a start at a moment of the hypothesis itself.</summary>
    public void SetMoment(FilterHypothesis old, FilterMoment moment, FilterStart kind)
    {
        FilterMath.Covariance(moment, old.Count, _covariance);
        Array.Clear(old.Prior, 0, old.Prior.Length);
        for (int i = 0; i < FilterHypothesis.Motion; i++)
        {
            old.Mean[i] = moment.Motion[i];
            for (int j = 0; j < FilterHypothesis.Motion; j++)
            {
                old.Prior[(i * FilterHypothesis.Most) + j] = _covariance[(i * FilterHypothesis.Motion) + j];
            }

            old.Prior[(i * FilterHypothesis.Most) + i] += Floor[i / 3] * Floor[i / 3];
        }

        Constrain(old, kind);
    }

    /// <summary>Removes the parameters that a start on the ground does not have.</summary>
    private static void Constrain(FilterHypothesis start, FilterStart kind)
    {
        if (kind != FilterStart.Free)
        {
            Fix(start, 1);
            Fix(start, 4);
        }

        if (kind == FilterStart.Rolling)
        {
            Fix(start, 6);
            Fix(start, 8);
        }
    }

    private static void Fix(FilterHypothesis start, int parameter)
    {
        start.Mean[parameter] = 0;
        for (int i = 0; i < FilterHypothesis.Most; i++)
        {
            start.Prior[(i * FilterHypothesis.Most) + parameter] = 0;
            start.Prior[(parameter * FilterHypothesis.Most) + i] = 0;
        }
    }

    private void SetMotion(FilterHypothesis start)
    {
        for (int i = 3; i < FilterHypothesis.Motion; i++)
        {
            double deviation = i < 6 ? settings.KickVelocity : settings.KickSpin;
            start.Prior[(i * FilterHypothesis.Most) + i] = deviation * deviation;
        }
    }
}

/// <summary>Parts of the distribution of the upward velocity, each narrow enough for a linear fit.</summary>
/// <remarks>
/// Points without height hardly show the upward velocity until a bounce, whose time depends on it: the density has several maxima, and a single fit finds one of
/// them. A sum of narrow normal distributions keeps all of them until the points decide.
/// </remarks>
internal sealed class UpwardParts
{
    private UpwardParts(double deviation, params double[] means)
    {
        Means = means;
        Deviation = deviation;
        LogShare = -Elementary.Log(means.Length);
    }

    /// <summary>One part: the distribution itself.</summary>
    public static UpwardParts None { get; } = new(1, 0);

    /// <summary>A ball on the ground that is kicked upwards.</summary>
    public static UpwardParts FromGround { get; } = new(0.2, 0.1, 0.4, 0.75, 1.15);

    /// <summary>A ball that is kicked in the air, or whose motion starts anywhere.</summary>
    public static UpwardParts InAir { get; } = new(0.3, -0.5, 0, 0.5, 1);

    public static UpwardParts AtStart { get; } = new(0.3, -0.4, 0.1, 0.6);

    /// <summary>The means, and the standard deviation of each part, in deviations of the velocity of a kick.</summary>
    public double[] Means { get; }

    public double Deviation { get; }

    public int Count => Means.Length;

    /// <summary>The logarithm of the share of a part.</summary>
    public double LogShare { get; }
}
