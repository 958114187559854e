namespace FootballPhysics.Tool.Sweep.Ranges;

/// <summary>Normally distributed numbers, truncated to a range.</summary>
internal sealed class NormalRange : FieldRange
{
    /// <summary>The number of bisection steps for the share below a bound; enough for full precision.</summary>
    private const int Halvings = 100;

    private readonly double _mean;
    private readonly double _deviation;
    private readonly double _low;
    private readonly double _high;
    private readonly double _shareBelow;
    private readonly double _share;

    /// <summary>Creates a range.</summary>
    /// <param name="mean">The mean without truncation.</param>
    /// <param name="deviation">The standard deviation without truncation. Above 0.</param>
    /// <param name="low">The minimum; can be infinite.</param>
    /// <param name="high">The maximum; can be infinite.</param>
    public NormalRange(double mean, double deviation, double low, double high)
    {
        _mean = mean;
        _deviation = deviation;
        _low = low;
        _high = high;
        _shareBelow = ShareBelow((low - mean) / deviation);
        _share = ShareBelow((high - mean) / deviation) - _shareBelow;
    }

    /// <summary>The share of the distribution within the bounds.</summary>
    public double Share => _share;

    public override IEnumerable<FieldValue> Ends =>
        [new(double.IsInfinity(_low) ? _mean : _low), new(double.IsInfinity(_high) ? _mean : _high)];

    public override FieldValue Draw(double random, long index)
    {
        // x = µ + σ Φ⁻¹(p), where p is uniform between the shares below the bounds.
        double x = _mean + (_deviation * NormalQuantile.At(_shareBelow + (_share * random)));
        return new FieldValue(Math.Min(Math.Max(x, _low), _high));
    }

    /// <summary>Returns Φ(z), the share below the quantile z.</summary>
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
