using System.Globalization;

namespace FootballPhysics.Tests.Support;

/// <summary>Observed orders of convergence.</summary>
internal static class Order
{
    /// <summary>The slope of log error over log step, by least squares over halvings of a step.</summary>
    public static double Observed(double coarsest, int halvings, Func<double, double> error)
    {
        double[] x = [.. Enumerable.Range(0, halvings + 1).Select(i => (double)-i)];
        double[] y = [.. x.Select(i => Math.Log2(error(coarsest * Math.Pow(2, i))))];
        double mx = x.Average();
        double my = y.Average();
        return x.Zip(y).Sum(p => (p.First - mx) * (p.Second - my)) / x.Sum(a => (a - mx) * (a - mx));
    }

    /// <summary>The median of the observed orders of many cases lies in a range.</summary>
    public static void Hold(string what, IReadOnlyList<double> orders, double low, double high)
    {
        double[] sorted = [.. orders.Order()];
        double median = sorted[sorted.Length / 2];
        Assert.True(
            median >= low && median <= high,
            string.Create(CultureInfo.InvariantCulture, $"{what}: median order {median:f2}, expected {low:f2} … {high:f2}; all: {string.Join(' ', sorted.Select(o => o.ToString("f2", CultureInfo.InvariantCulture)))}"));
    }
}
