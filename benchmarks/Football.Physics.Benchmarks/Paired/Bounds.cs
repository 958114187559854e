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

    /// <summary>Returns true if a row is above its bound in each of the first runs, and in the median of all others.</summary>
    /// <param name="row">The table and the row.</param>
    /// <param name="ratios">The ratio in each run.</param>
    /// <param name="flightSteps">The number of flight steps in each run; empty if a flight step is not a unit for this row.</param>
    /// <param name="first">The number of the first runs.</param>
    /// <remarks>The addresses of code change a time by some percent, and differ between runs.</remarks>
    public bool Fails(string row, IReadOnlyList<double> ratios, IReadOnlyList<double> flightSteps, int first)
    {
        (bool inFlightSteps, double most) = Of(row);
        IReadOnlyList<double> runs = inFlightSteps ? flightSteps : ratios;
        double[] others = [.. runs.Skip(first).Order()];
        return runs.Count >= first && runs.Take(first).Min() > most && (others.Length == 0 || others[others.Length / 2] > most);
    }

    private static (Regex Pattern, bool InFlightSteps, double Most) Parse(string line) =>
        line.Split('\t') is [var pattern, "ratio" or FlightSteps, var most, not ""] cells && double.TryParse(most, NumberStyles.Float, CultureInfo.InvariantCulture, out double value)
            ? (new Regex(pattern, RegexOptions.CultureInvariant), cells[1] == FlightSteps, value)
            : throw new FormatException($"'{line}' is not a bound. Write a pattern, 'ratio' or '{FlightSteps}', a number and a reason, separated by tabs.");
}
