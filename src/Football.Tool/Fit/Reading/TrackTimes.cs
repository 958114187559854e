using System.Globalization;
using System.Text.RegularExpressions;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Reads times: numbers, clocks, dates, and durations of pandas and ISO 8601.</summary>
internal static partial class TrackTimes
{
    /// <summary>True if a cell is a number or another time.</summary>
    public static bool IsTime(string cell) =>
        double.TryParse(cell.Replace(',', '.'), NumberStyles.Float, CultureInfo.InvariantCulture, out _) || Clock(cell) is not null || Date(cell) is not null;

    /// <summary>Returns the seconds of a clock or a duration such as m:ss.cc, h:mm:ss, d.hh:mm:ss, −1 days +23:59:59.96 or PT1M2.5S; otherwise null.</summary>
    public static double? Clock(string cell)
    {
        string text = cell.Replace('\u2212', '-');
        if (Days().Match(text) is { Success: true } days)
        {
            double time = days.Groups["m"].Success ? Sum(days) : 0;
            return (86400 * Value(days, "days")) + (days.Groups["sign"].Value == "-" ? -time : time);
        }

        if (Colons().Match(text) is { Success: true } colons)
        {
            double time = (86400 * Value(colons, "d")) + Sum(colons);
            bool isInRange = Value(colons, "s") < 60 && (!colons.Groups["h"].Success || Value(colons, "m") < 60);
            return !isInRange ? null : colons.Groups["sign"].Value == "-" ? -time : time;
        }

        if (Iso().Match(text) is { Success: true } iso && text.Length > 2)
        {
            double time = (86400 * Value(iso, "d")) + Sum(iso);
            return iso.Groups["sign"].Value == "-" ? -time : time;
        }

        return null;
    }

    /// <summary>Returns a date with a time of day; null if the cell is not one.</summary>
    public static DateTimeOffset? Date(string cell) =>
        cell.Length >= 14 && cell.Contains(':', StringComparison.Ordinal)
        && DateTimeOffset.TryParse(Fraction().Replace(cell, ".$1"), CultureInfo.InvariantCulture, DateTimeStyles.AssumeUniversal, out DateTimeOffset date)
            ? date
            : null;

    /// <summary>Returns the seconds of a timecode h:mm:ss:ff; null if the cell is not one.</summary>
    public static double? Timecode(string cell, double rate)
    {
        Match match = Frames().Match(cell);
        return match.Success ? (3600 * Value(match, "h")) + (60 * Value(match, "m")) + Value(match, "s") + (Value(match, "f") / rate) : null;
    }

    /// <summary>True if the cell is a timecode h:mm:ss:ff.</summary>
    public static bool IsTimecode(string cell) => Frames().IsMatch(cell);

    /// <summary>Returns the median wait between successive times, in order; 0 if there is none.</summary>
    public static double UsualWait(IReadOnlyList<double> times)
    {
        double[] sorted = [.. times.Where(double.IsFinite).Order()];
        double[] waits = [.. Enumerable.Range(1, Math.Max(0, sorted.Length - 1)).Select(i => sorted[i] - sorted[i - 1]).Where(wait => wait > 0).Order()];
        return waits.Length > 0 ? waits[waits.Length / 2] : 0;
    }

    /// <summary>Returns the unit of numeric times by their usual wait; null for seconds.</summary>
    /// <exception cref="RefusedException">The numbers may be frame numbers.</exception>
    public static string? Unit(double wait)
    {
        return wait switch
        {
            < 0.7 => null,
            < 3.5 => throw new RefusedException(FormattableString.Invariant(
                $"TRACK's times go up by {wait:0.###}. If they are frame numbers, give --rate with the frames a second; else give --time-unit s | ms | us | ns | min.")),
            < 1500 => "ms",
            < 1.5e6 => "us",
            < 1.5e9 => "ns",
            _ => throw new RefusedException(FormattableString.Invariant($"TRACK's times go up by {wait:0.###}. Give --time-unit s | ms | us | ns | min, or --rate if they are frame numbers.")),
        };
    }

    private static double Sum(Match match) => (3600 * Value(match, "h")) + (60 * Value(match, "m")) + Value(match, "s");

    private static double Value(Match match, string group) =>
        match.Groups[group] is { Success: true, Length: > 0 } found ? double.Parse(found.Value.Replace(',', '.'), CultureInfo.InvariantCulture) : 0;

    [GeneratedRegex(@"^(?<days>[-+]?\d{1,6}) days?(?:,? +(?<sign>[-+])?(?<h>\d{1,2}):(?<m>\d{1,2}):(?<s>\d{1,2}(?:[.,]\d+)?))?$", RegexOptions.CultureInvariant)]
    private static partial Regex Days();

    [GeneratedRegex(@"^(?<sign>[-+])?(?:(?:(?<d>\d{1,6})\.)?(?<h>\d{1,6}):)?(?<m>\d{1,6}):(?<s>\d{1,2}(?:[.,]\d+)?)$", RegexOptions.CultureInvariant)]
    private static partial Regex Colons();

    [GeneratedRegex(@"^(?<sign>[-+])?P(?:(?<d>\d{1,6})D)?(?:T(?:(?<h>\d{1,6})H)?(?:(?<m>\d{1,6})M)?(?:(?<s>\d+(?:[.,]\d+)?)S)?)?$", RegexOptions.CultureInvariant | RegexOptions.IgnoreCase)]
    private static partial Regex Iso();

    [GeneratedRegex(@"^(?<h>\d{1,2}):(?<m>\d{2}):(?<s>\d{2})[:;](?<f>\d{1,3})$", RegexOptions.CultureInvariant)]
    private static partial Regex Frames();

    [GeneratedRegex(@",(\d+)")]
    private static partial Regex Fraction();
}
