using System.Text.Json;

namespace Football.Physics.Headless.Lab;

/// <summary>Mean, median, 95th percentile and largest of some values.</summary>
internal sealed record Spread(double Mean, double Median, double P95, double Worst)
{
    public static Spread Of(IEnumerable<double> values)
    {
        double[] sorted = [.. values.Order()];
        return sorted.Length == 0 ? new Spread(0, 0, 0, 0) : new Spread(sorted.Average(), At(sorted, 0.5), At(sorted, 0.95), sorted[^1]);
    }

    public void Write(Utf8JsonWriter json, string name)
    {
        json.WriteStartObject(name);
        json.WriteNumber("mean", Mean);
        json.WriteNumber("median", Median);
        json.WriteNumber("p95", P95);
        json.WriteNumber("worst", Worst);
        json.WriteEndObject();
    }

    private static double At(double[] sorted, double share) => sorted[Math.Max(0, (int)Math.Ceiling(share * sorted.Length) - 1)];
}
