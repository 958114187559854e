using System.Globalization;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Reads the numbers of a column. It finds the decimal mark, and accepts thousands separators only if they are certain.</summary>
internal sealed class TrackNumbers
{
    private const string Advice = "Give --decimal point or --decimal comma, or write numbers without thousands separators";

    private readonly char _mark;

    private TrackNumbers(char mark) => _mark = mark;

    /// <summary>Finds the notation of numbers in some columns.</summary>
    /// <param name="table">The table.</param>
    /// <param name="columns">The columns.</param>
    /// <param name="given">The given decimal mark; null to find it.</param>
    /// <param name="report">Receives remarks.</param>
    /// <exception cref="RefusedException">The decimal mark is ambiguous.</exception>
    public static TrackNumbers[] Of(TrackTable table, int[] columns, char? given, Action<string> report)
    {
        var seen = columns.Select(column => Evidence.Of(table, column)).ToArray();
        bool points = seen.Any(column => column.Point is not null);
        bool commas = seen.Any(column => column.Comma is not null);
        var marks = new TrackNumbers[columns.Length];
        for (int i = 0; i < columns.Length; i++)
        {
            Evidence column = seen[i];
            if (given is null && column is { Point: { } point, Comma: { } comma })
            {
                throw new RefusedException(FormattableString.Invariant($"{point} has a decimal point and {comma} a decimal comma. {Advice}."));
            }

            bool isComma = given == ',' || (given is null && (column.Comma is not null || (column.Point is null && column.MaybeComma is not null && commas && !points)));
            string? unsure = given is not null || column.HasBoth ? null
                : isComma ? column.MaybePoint
                : column.Point is not null || column.Comma is not null ? column.MaybeComma
                : column.MaybeComma ?? (commas ? column.MaybePoint : null);
            if (unsure is not null)
            {
                throw new RefusedException($"{unsure} may be thousands or decimals. {Advice}.");
            }

            marks[i] = new TrackNumbers(isComma ? ',' : '.');
        }

        if (given is null && marks.Any(mark => mark._mark == ','))
        {
            report("guessed: numbers have decimal commas.");
        }

        return marks;
    }

    /// <summary>Returns the number in a cell; null if the cell is not a number.</summary>
    public double? Read(string cell)
    {
        if (_mark == '.' && double.TryParse(cell, NumberStyles.Float, CultureInfo.InvariantCulture, out double plain))
        {
            return plain;
        }

        string text = cell.Replace('\u2212', '-');
        int start = text.Length > 0 && text[0] is '+' or '-' ? 1 : 0;
        int end = text.AsSpan().IndexOfAny('e', 'E') is >= 0 and { } exponent ? exponent : text.Length;
        int mark = text.IndexOf(_mark, StringComparison.Ordinal);
        string whole = text[start..(mark >= 0 && mark < end ? mark : end)];
        string[] groups = whole.Split('.', ',', ' ', '\u00A0', '\u2009', '\u202F', '\'', '’');
        bool isGrouped = groups.Length > 1;
        if (isGrouped && (groups[0].Length is 0 or > 3 || groups.Skip(1).Any(group => group.Length != 3) || whole.Where(c => !char.IsAsciiDigit(c)).Distinct().Count() > 1))
        {
            return null;
        }

        string number = text[..start] + string.Concat(groups) + (mark >= 0 && mark < end ? "." + text[(mark + 1)..] : text[end..]);
        return double.TryParse(number, NumberStyles.Float, CultureInfo.InvariantCulture, out double value) ? value : null;
    }

    /// <summary>The evidence for a decimal mark in a column: for each kind, the first cell that shows it.</summary>
    private sealed record Evidence(string? Point, string? Comma, string? MaybePoint, string? MaybeComma, bool HasBoth)
    {
        public static Evidence Of(TrackTable table, int column)
        {
            string? point = null;
            string? comma = null;
            string? maybePoint = null;
            string? maybeComma = null;
            bool both = false;
            foreach (TrackLine line in table.Lines)
            {
                string cell = line[column];
                int points = cell.AsSpan().Count('.');
                int commas = cell.AsSpan().Count(',');
                if (points + commas == 0 || cell.Contains(':', StringComparison.Ordinal) || TrackMissing.IsMissing(cell))
                {
                    continue;
                }

                string Here() => FormattableString.Invariant($"line {line.Number}, {Quote.Short(table.Header?[column] ?? "column " + (column + 1))}: {Quote.Short(cell)}");
                if (points > 0 && commas > 0)
                {
                    both = true;
                    (point, comma) = cell.LastIndexOf('.') > cell.LastIndexOf(',') ? (point ?? Here(), comma) : (point, comma ?? Here());
                }
                else if (points > 1 || commas > 1)
                {
                    (point, comma) = commas > 1 ? (point ?? Here(), comma) : (point, comma ?? Here());
                }
                else if (MayBeThousands(cell, points == 1 ? '.' : ','))
                {
                    (maybePoint, maybeComma) = points == 1 ? (maybePoint ?? Here(), maybeComma) : (maybePoint, maybeComma ?? Here());
                }
                else
                {
                    (point, comma) = points == 1 ? (point ?? Here(), comma) : (point, comma ?? Here());
                }
            }

            return new Evidence(point, comma, maybePoint, maybeComma, both);
        }

        /// <summary>True for 1,234 and 12,345, not for 0,123, 1234,567 or 1,2345.</summary>
        private static bool MayBeThousands(string cell, char mark)
        {
            string digits = cell.TrimStart('+', '-', '\u2212', ' ');
            int at = digits.IndexOf(mark, StringComparison.Ordinal);
            return at is >= 1 and <= 3 && digits.Length - at == 4 && digits[0] != '0' && digits.All(c => c == mark || char.IsAsciiDigit(c));
        }
    }
}
