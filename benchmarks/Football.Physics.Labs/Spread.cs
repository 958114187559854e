namespace FootballPhysics.Labs;

/// <summary>Mean, percentiles and worst of some values; of none all are 0.</summary>
internal sealed class Spread(IEnumerable<double> values)
{
    private readonly double[] _sorted = [.. values.Order().DefaultIfEmpty()];

    public double Mean => _sorted.Average();

    public double Median => Percentile(0.5);

    public double P95 => Percentile(0.95);

    public double Worst => _sorted[^1];

    /// <summary>The smallest value that is not exceeded by the given share.</summary>
    public double Percentile(double share) => _sorted[Math.Max(0, (int)Math.Ceiling(share * _sorted.Length) - 1)];
}
