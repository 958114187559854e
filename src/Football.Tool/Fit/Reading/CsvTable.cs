using System.Text;
using FootballPhysics.Scenarios.Input;
using nietras.SeparatedValues;

namespace FootballPhysics.Tool.Fit.Reading;

/// <summary>Splits CSV: finds the separator, skips comments, and finds the header line if there is one.</summary>
internal static class CsvTable
{
    /// <summary>The number of lines from which the separator and the header are determined.</summary>
    private const int Sample = 60;

    /// <summary>The number of first lines that can be the header.</summary>
    private const int Heading = 6;

    private static readonly char[] s_separators = ['\t', ';', '|', ',', ' '];

    public static TrackTable Read(string text, TrackFormat format, Action<string> report)
    {
        // 1. Replace comments and a spreadsheet's line "sep=;" by empty lines, so that line numbers stay valid. 2. Find the separator. 3. Split the
        // cells. 4. Find the header.
        string[] lines = text.Split(["\r\n", "\n", "\r"], StringSplitOptions.None);
        char? given = null;
        string? comment = null;
        for (int i = 0; i < lines.Length; i++)
        {
            string line = lines[i].Trim('\uFEFF', ' ');
            if (i == 0 && line.Length == 5 && line.StartsWith("sep=", StringComparison.OrdinalIgnoreCase))
            {
                given = line[4];
                lines[i] = "";
            }
            else if (IsComment(line))
            {
                comment ??= HeaderIn(line, format);
                lines[i] = "";
            }
        }

        string[] sample = [.. lines.Where(line => !string.IsNullOrWhiteSpace(line)).Take(Sample)];
        if (sample.Length == 0)
        {
            throw new RefusedException("TRACK", "empty", "a header and lines of t, x, y, z");
        }

        char separator = given ?? Separator(sample, format);
        if (separator == ' ')
        {
            lines = [.. lines.Select(OfRuns)];
            separator = '\t';
        }

        var table = new TrackTable { Separator = separator };
        Split(string.Join('\n', lines), table);
        FindHeader(table, comment is null ? null : [.. comment.Split(separator == '\t' ? null : [separator], StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries)], format);
        if (separator != ',')
        {
            report($"guessed: cells are separated by {Name(separator)}.");
        }

        return table;
    }

    private static string Name(char separator) => separator == '\t' ? "tabs or spaces" : separator == ';' ? "semicolons" : $"\"{separator}\"";

    /// <summary>True if the line starts with #, // or %; false if its first cell is a missing value such as #N/A, or if it is only a %.</summary>
    private static bool IsComment(string line) =>
        line.StartsWith("//", StringComparison.Ordinal)
        || (line.StartsWith('#') && !TrackMissing.IsMissing(line.Split(s_separators, 2)[0]))
        || (line.StartsWith('%') && line.Length > 1);

    /// <summary>Returns the header in a comment, as numpy.savetxt writes it; null if the comment is not a header.</summary>
    private static string? HeaderIn(string line, TrackFormat format)
    {
        string inner = line.TrimStart('#', '/', '%', ' ');
        return s_separators.Any(separator => TrackColumns.Find(Cells(inner, separator), format) is not null) ? inner : null;
    }

    private static char Separator(string[] sample, TrackFormat format)
    {
        // Prefer a separator that gives a known header. Otherwise use the one that splits most lines into the same number of cells.
        foreach (char separator in s_separators)
        {
            if (sample.Take(Heading).Any(line => TrackColumns.Find(Cells(line, separator), format) is not null))
            {
                return separator;
            }
        }

        char best = ',';
        int most = 0;
        foreach (char separator in s_separators)
        {
            int usual = sample.Select(line => Cells(line, separator).Length).GroupBy(count => count).Where(group => group.Key >= 4).Select(group => group.Count()).DefaultIfEmpty().Max();
            (best, most) = usual > most ? (separator, usual) : (best, most);
        }

        return best;
    }

    /// <summary>Splits one line into cells, for the detection of the separator.</summary>
    private static string[] Cells(string line, char separator)
    {
        var cells = new List<string>();
        var cell = new StringBuilder();
        bool quoted = false;
        foreach (char c in separator == ' ' ? OfRuns(line).Replace('\t', ' ') : line)
        {
            if (c == '"')
            {
                quoted = !quoted;
            }
            else if (c == separator && !quoted)
            {
                cells.Add(cell.ToString().Trim());
                cell.Clear();
            }
            else
            {
                cell.Append(c);
            }
        }

        cells.Add(cell.ToString().Trim());
        return [.. cells];
    }

    /// <summary>Replaces runs of spaces by one tab.</summary>
    private static string OfRuns(string line)
    {
        var text = new StringBuilder();
        bool quoted = false;
        foreach (char c in line.Trim())
        {
            quoted ^= c == '"';
            if (quoted || (c != ' ' && c != '\t'))
            {
                text.Append(c);
            }
            else if (text.Length > 0 && text[^1] != '\t')
            {
                text.Append('\t');
            }
        }

        return text.ToString();
    }

    private static void Split(string text, TrackTable table)
    {
        try
        {
            using SepReader reader = Sep.New(table.Separator).Reader(options => options with { HasHeader = false, DisableColCountCheck = true, Unescape = true, Trim = SepTrim.All }).FromText(text);
            long next = 1;
            foreach (SepReader.Row row in reader)
            {
                long line = next;
                next = row.LineNumberToExcl;
                string[] cells = new string[row.ColCount];
                bool isEmpty = true;
                for (int i = 0; i < cells.Length; i++)
                {
                    cells[i] = row[i].ToString().Trim().Trim('"', '\uFEFF').Trim();
                    isEmpty &= cells[i].Length == 0;
                }

                if (next - line > 1 && (table.Lines.Count > 0 || next - line > 3))
                {
                    throw new RefusedException(FormattableString.Invariant($"line {line}: a quote is opened and not closed. Close it, or double a quote that belongs to a cell."));
                }

                if (!isEmpty)
                {
                    table.Lines.Add(new TrackLine(line, cells));
                }
            }
        }
        catch (Exception e) when (e is InvalidDataException or NotSupportedException or ArgumentException or IndexOutOfRangeException)
        {
            throw new RefusedException($"TRACK cannot be split into cells ({Quote.Short(e.Message)}). Write one line a moment, with the same separator in all.");
        }
    }

    /// <summary>True if the columns that are given by number hold a time and numbers.</summary>
    private static bool IsData(TrackLine line, TrackFormat format) =>
        TrackColumns.ByNumber(format, line.Cells.Length) is { } columns && columns.Places.Append(columns.Time).All(column => TrackTimes.IsTime(line[column]) || TrackMissing.IsMissing(line[column]));

    private static void FindHeader(TrackTable table, string[]? comment, TrackFormat format)
    {
        List<TrackLine> lines = table.Lines;
        int at = lines.FindIndex(0, Math.Min(Heading, lines.Count), line => TrackColumns.Find(line.Cells, format) is not null);
        if (at >= 0)
        {
            table.Header = lines[at].Cells;
            lines.RemoveRange(0, at + 1);
        }
        else if (comment is not null)
        {
            table.Header = comment;
        }
        else if (lines.Count > 0 && !IsData(lines[0], format) && lines[0].Cells.Any(cell => cell.Any(char.IsLetter) && !TrackMissing.IsMissing(cell) && !TrackTimes.IsTime(cell)))
        {
            // A header with unknown names: the columns are given by number.
            table.Header = lines[0].Cells;
            lines.RemoveAt(0);
        }

        if (table.Header is { } header)
        {
            foreach (TrackLine line in lines)
            {
                if (line.Cells.Length > header.Length && line.Cells.Skip(header.Length).Any(cell => cell.Length > 0))
                {
                    throw new RefusedException(FormattableString.Invariant(
                        $"line {line.Number} has {line.Cells.Length} cells, the header has {header.Length}. Put cells that contain a comma in quotes, or separate cells by semicolons."));
                }
            }
        }
    }
}
