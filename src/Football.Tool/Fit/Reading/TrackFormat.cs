using System.Globalization;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>The given properties of a track file. The reader finds the others in the file.</summary>
internal sealed record TrackFormat
{
    private static readonly Dictionary<string, double> s_lengths = new(StringComparer.OrdinalIgnoreCase)
    {
        ["m"] = 1,
        ["cm"] = 0.01,
        ["mm"] = 0.001,
        ["km"] = 1000,
        ["ft"] = 0.3048,
        ["yd"] = 0.9144,
        ["in"] = 0.0254,
    };

    private static readonly Dictionary<string, double> s_times = new(StringComparer.OrdinalIgnoreCase) { ["s"] = 1, ["ms"] = 1e-3, ["us"] = 1e-6, ["ns"] = 1e-9, ["min"] = 60 };

    /// <summary>The unit of the coordinates: m, cm, mm, km, ft, yd, in, pitch (0 … 1) or percent (0 … 100); null to find it.</summary>
    public string? Unit { get; init; }

    /// <summary>The unit of the times: s, ms, us, ns or min; null to find it.</summary>
    public string? TimeUnit { get; init; }

    /// <summary>The frame rate, per second; null if times are given.</summary>
    public double? Rate { get; init; }

    /// <summary>The length and width of the pitch, in m.</summary>
    public (double Length, double Width)? Pitch { get; init; }

    /// <summary>True if y points to the right of x, false if it points to the left; null if unknown.</summary>
    public bool? IsYDown { get; init; }

    /// <summary>True if y points up and z across, false if z points up; null to find it.</summary>
    public bool? IsYUp { get; init; }

    /// <summary>The decimal mark, a point or a comma; null to find it.</summary>
    public char? Decimal { get; init; }

    /// <summary>The names, or numbers from 1, of the columns t, x, y and z; null to find them.</summary>
    public string[]? Columns { get; init; }

    /// <summary>The column that names the object of a line, and the name of the ball in it; null to find them.</summary>
    public (string Column, string Ball)? Object { get; init; }

    /// <summary>The column of the half; null to find it.</summary>
    public string? Period { get; init; }

    /// <summary>The list of moments in a JSON document, with points between the names of nested members; null to find it.</summary>
    public string? Records { get; init; }

    /// <summary>Returns the length of a unit, in m; null if the unit is unknown.</summary>
    public static double? Metres(string unit) => s_lengths.TryGetValue(unit, out double metres) ? metres : null;

    /// <summary>Returns the duration of a unit, in s; null if the unit is unknown.</summary>
    public static double? Seconds(string unit) => s_times.TryGetValue(unit, out double seconds) ? seconds : null;

    /// <summary>Reads the options of a command.</summary>
    /// <exception cref="RefusedException">An option has a value that is not allowed.</exception>
    public static TrackFormat Of(string? unit, string? timeUnit, string? rate, string? pitch, string? y, string? up, string? mark, string? columns, string? of = null, string? period = null, string? records = null)
    {
        static string Word(string option, string value, params string[] allowed) =>
            Array.Find(allowed, word => word.Equals(value, StringComparison.OrdinalIgnoreCase)) ?? throw new RefusedException(option, Quote.Short(value), string.Join(" | ", allowed));

        string[]? names = columns?.Split(',', StringSplitOptions.TrimEntries);
        return new TrackFormat
        {
            Unit = unit is null ? null : Word("--unit", unit, [.. s_lengths.Keys, "pitch", "percent"]),
            TimeUnit = timeUnit is null ? null : Word("--time-unit", timeUnit, [.. s_times.Keys]),
            Rate = rate is null ? null : Ratio(rate),
            Pitch = pitch is null ? null : Size(pitch),
            IsYDown = y is null ? null : Word("--y", y, "left", "right") == "right",
            IsYUp = up is null ? null : Word("--up", up, "y", "z") == "y",
            Decimal = mark is null ? null : Word("--decimal", mark, "point", "comma") == "comma" ? ',' : '.',
            Object = of is null ? null : (of.Split('=', 2)[0].Trim(), of.Contains('=', StringComparison.Ordinal) ? of.Split('=', 2)[1].Trim() : "ball"),
            Period = period,
            Records = records,
            Columns = names is null or { Length: 4 } ? names : throw new RefusedException("--columns", Quote.Short(columns!), "four names or numbers: t,x,y,z"),
        };
    }

    private static double Ratio(string text)
    {
        string[] parts = text.Split('/');
        double rate = parts.Length <= 2 && Number(parts[0]) is { } above && Number(parts[^1]) is { } below ? (parts.Length == 2 ? above / below : above) : double.NaN;
        return rate is > 0 and <= 1e6 ? rate : throw new RefusedException("--rate", Quote.Short(text), "frames a second, above 0 up to 1e6, or a ratio such as 30000/1001");
    }

    private static (double Length, double Width) Size(string text)
    {
        string[] parts = text.Split('x', 'X', '×');
        return parts.Length == 2 && Number(parts[0]) is > 1 and < 1000 and { } length && Number(parts[1]) is > 1 and < 1000 and { } width
            ? (length, width)
            : throw new RefusedException("--pitch", Quote.Short(text), "LENGTHxWIDTH in metres, such as 105x68");
    }

    private static double? Number(string text) => double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : null;
}
