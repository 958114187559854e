namespace FootballPhysics.Labs;

/// <summary>Mean, percentiles and worst of some values; all are 0 if there are no values.</summary>
internal sealed class Spread(IEnumerable<double> values)
{
    private readonly double[] _sorted = [.. values.Order().DefaultIfEmpty()];

    public double Mean => _sorted.Average();

    public double Median => Percentile(0.5);

    public double P95 => Percentile(0.95);

    public double Worst => _sorted[^1];

    /// <summary>Returns the smallest value that at least the given share does not exceed.</summary>
    public double Percentile(double share) => _sorted[Math.Max(0, (int)Math.Ceiling(share * _sorted.Length) - 1)];
}
