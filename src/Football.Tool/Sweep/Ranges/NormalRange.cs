namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>Numbers around a mean, normally distributed; those outside of a range do not occur.</summary>
internal sealed class NormalRange : FieldRange
{
    /// <summary>Halvings until the share below a bound is known to the last bit that matters.</summary>
    private const int Halvings = 100;

    private readonly double _mean;
    private readonly double _deviation;
    private readonly double _low;
    private readonly double _high;
    private readonly double _shareBelow;
    private readonly double _share;

    /// <summary>Makes a range.</summary>
    /// <param name="mean">The mean, were there no bounds.</param>
    /// <param name="deviation">The standard deviation, were there no bounds; above 0.</param>
    /// <param name="low">The lowest number; may be infinite.</param>
    /// <param name="high">The highest number; may be infinite.</param>
    public NormalRange(double mean, double deviation, double low, double high)
    {
        _mean = mean;
        _deviation = deviation;
        _low = low;
        _high = high;
        _shareBelow = ShareBelow((low - mean) / deviation);
        _share = ShareBelow((high - mean) / deviation) - _shareBelow;
    }

    /// <summary>The part of the distribution that lies within the bounds.</summary>
    public double Share => _share;

    public override IEnumerable<FieldValue> Ends =>
        [new(double.IsInfinity(_low) ? _mean : _low), new(double.IsInfinity(_high) ? _mean : _high)];

    public override FieldValue Draw(double random, long index)
    {
        // x = µ + σ Φ⁻¹(p), p uniform among the shares within the bounds
        double x = _mean + (_deviation * NormalQuantile.At(_shareBelow + (_share * random)));
        return new FieldValue(Math.Min(Math.Max(x, _low), _high));
    }

    /// <summary>Φ(z): the share whose quantile is z.</summary>
    private static double ShareBelow(double z)
    {
        if (double.IsInfinity(z))
        {
            return z > 0 ? 1 : 0;
        }

        double below = 0;
        double above = 1;
        for (int i = 0; i < Halvings; i++)
        {
            double middle = 0.5 * (below + above);
            bool lower = middle <= 0 || (middle < 1 && NormalQuantile.At(middle) < z);
            (below, above) = lower ? (middle, above) : (below, middle);
        }

        return above;
    }
}
