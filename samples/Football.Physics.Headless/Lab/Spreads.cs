namespace Football.Physics.Headless.Lab;

/// <summary>Mean, percentiles and worst of a set of numbers.</summary>
internal sealed class Spreads
{
    private readonly double[] _sorted;

    public Spreads(IEnumerable<double> values) => _sorted = [.. values.Order()];

    public double Mean => _sorted.Average();

    public double Worst => _sorted[^1];

    /// <summary>The smallest value that is not exceeded by the given share.</summary>
    public double Percentile(double share) => _sorted[Math.Max(0, (int)Math.Ceiling(share * _sorted.Length) - 1)];
}
