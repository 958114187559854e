using System.Globalization;
using System.Text.RegularExpressions;

namespace FootballPhysics.Benchmarks;

/// <summary>The bounds of `paired`: a common one for ratios, and those of benchmarks/bounds.tsv for the rows that need another.</summary>
internal sealed class Bounds
{
    /// <summary>The unit of a bound that is a number of flight steps; all other bounds are ratios.</summary>
    public const string FlightSteps = "flight steps";

    private readonly double _common;
    private readonly (Regex Pattern, bool InFlightSteps, double Most)[] _others;

    /// <summary>Reads the lines: pattern, unit, bound and reason, separated by tabs; the first line is the header.</summary>
    /// <exception cref="FormatException">A line has another form.</exception>
    public Bounds(double common, IEnumerable<string> lines)
    {
        _common = common;
        _others = [.. lines.Skip(1).Select(Parse)];
    }

    /// <summary>Returns the bound of a row: the first pattern that matches decides.</summary>
    public (bool InFlightSteps, double Most) Of(string row)
    {
        foreach ((Regex pattern, bool inFlightSteps, double most) in _others)
        {
            if (pattern.IsMatch(row))
            {
                return (inFlightSteps, most);
            }
        }

        return (false, _common);
    }

    /// <summary>Returns the patterns that match none of the rows.</summary>
    public IEnumerable<string> Unused(IReadOnlyCollection<string> rows) => _others.Select(other => other.Pattern).Where(pattern => !rows.Any(pattern.IsMatch)).Select(pattern => pattern.ToString());

    /// <summary>Returns true if a row is above its bound in every run.</summary>
    /// <remarks>The position of code in memory changes a time by some percent, and differs between runs.</remarks>
    public bool Fails(string row, IReadOnlyCollection<double> ratios, IReadOnlyCollection<double> flightSteps)
    {
        (bool inFlightSteps, double most) = Of(row);
        return (inFlightSteps ? flightSteps : ratios) is { Count: > 0 } runs && runs.Min() > most;
    }

    private static (Regex Pattern, bool InFlightSteps, double Most) Parse(string line) =>
        line.Split('\t') is [var pattern, "ratio" or FlightSteps, var most, not ""] cells && double.TryParse(most, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            ? (new Regex(pattern, RegexOptions.CultureInvariant), cells[1] == FlightSteps, value)
            : throw new FormatException($"'{line}' is not a bound. Write a pattern, 'ratio' or '{FlightSteps}', a number and a reason, separated by tabs.");
}
