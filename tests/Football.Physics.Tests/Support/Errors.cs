using System.Globalization;

namespace FootballPhysics.Tests.Support;

/// <summary>Named errors of many cases, judged by percentile; a failure lists the worst cases.</summary>
internal sealed class Errors
{
    private readonly string _what;
    private readonly List<(double Error, string Name)> _items = [];

    public Errors(string what) => _what = what;

    public int Count => _items.Count;

    public double Mean => _items.Average(item => item.Error);

    public double Worst => _items.Max(item => item.Error);

    public void Add(string name, double error) => _items.Add((double.IsNaN(error) ? double.PositiveInfinity : error, name));

    /// <summary>The smallest error that is not exceeded by the given share of the cases.</summary>
    public double Percentile(double share)
    {
        double[] sorted = [.. _items.Select(item => item.Error).Order()];
        return sorted[Math.Max(0, (int)Math.Ceiling(share * sorted.Length) - 1)];
    }

    public void Hold(double? p95 = null, double? worst = null, double? mean = null)
    {
        Assert.NotEmpty(_items);
        List<string> broken = [];
        Judge("mean", Mean, mean, broken);
        Judge("p95", Percentile(0.95), p95, broken);
        Judge("worst", Worst, worst, broken);
        Assert.True(broken.Count == 0, string.Create(CultureInfo.InvariantCulture, $"{_what}: {string.Join(", ", broken)}\n{Table()}"));
    }

    private static void Judge(string name, double value, double? limit, List<string> broken)
    {
        if (limit is { } most && !(value <= most))
        {
            broken.Add(string.Create(CultureInfo.InvariantCulture, $"{name} {value:e3} > {most:e0}"));
        }
    }

    private string Table() => string.Join('\n', _items
        .OrderByDescending(item => item.Error)
        .Take(10)
        .Select(item => string.Create(CultureInfo.InvariantCulture, $"  {item.Error:e3}  {item.Name}")));
}
