using System.Globalization;

namespace FootballPhysics.Benchmarks;

/// <summary>Formats numbers for the tables.</summary>
internal static class Text
{
    /// <summary>Returns three significant digits.</summary>
    public static string Number(double value) => value switch
    {
        0 => "0",
        >= 100 => value.ToString("F0", CultureInfo.InvariantCulture),
        >= 10 => value.ToString("F1", CultureInfo.InvariantCulture),
        >= 1 => value.ToString("F2", CultureInfo.InvariantCulture),
        >= 0.1 => value.ToString("F3", CultureInfo.InvariantCulture),
        _ => value.ToString("G2", CultureInfo.InvariantCulture),
    };

    /// <summary>Returns a length with its unit.</summary>
    public static string Length(double metres) => metres switch
    {
        >= 1 => $"{Number(metres)} m",
        >= 1e-4 => $"{Number(1e3 * metres)} mm",
        >= 1e-7 => $"{Number(1e6 * metres)} µm",
        _ => metres.ToString("0e-0", CultureInfo.InvariantCulture) + " m",
    };
}
