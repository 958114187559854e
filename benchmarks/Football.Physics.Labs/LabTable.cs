using System.Globalization;
using System.Text.Json;
using Spectre.Console;

namespace FootballPhysics.Labs;

/// <summary>Rows of named columns: a table for a person, CSV, or JSON.</summary>
internal sealed class LabTable(string name, params string[] columns)
{
    public string Name { get; } = name;

    public List<object?[]> Rows { get; } = [];

    /// <summary>False if a row was judged and missed.</summary>
    public bool Holds { get; private set; } = true;

    public void Add(params object?[] cells) => Rows.Add(cells);

    /// <summary>Adds a row that ends with its verdict.</summary>
    public void Judge(bool holds, params ReadOnlySpan<object?> cells)
    {
        Rows.Add([.. cells, Verdict.Of(holds)]);
        Holds &= holds;
    }

    /// <summary>Adds a row of a name and a number, with a verdict if one is given.</summary>
    public void Count(string what, object? number, bool? holds = null)
    {
        Add(what, number, holds is { } yes ? Verdict.Of(yes) : null);
        Holds &= holds ?? true;
    }

    /// <summary>Prints the table for a person.</summary>
    public void Print(IAnsiConsole to)
    {
        Table table = new Table().Border(TableBorder.Simple);
        table.Title = new TableTitle(Markup.Escape(Name));
        for (int i = 0; i < columns.Length; i++)
        {
            bool numbers = Rows.Any(row => i < row.Length && row[i] is double or long or int);
            table.AddColumn(new TableColumn(Markup.Escape(columns[i])) { Alignment = numbers ? Justify.Right : Justify.Left });
        }

        foreach (object?[] row in Rows)
        {
            table.AddRow([.. row.Select(cell => Markup.Escape(Short(cell)))]);
        }

        to.Write(table);
    }

    public string Csv() => string.Concat(
        Rows.Select(row => row.Select(Exact).Prepend(Name)).Prepend(columns.Prepend("table")).Select(row => string.Join(',', row.Select(Quoted)) + "\n"));

    public void WriteJson(Utf8JsonWriter json)
    {
        json.WriteStartObject();
        json.WriteString("table", Name);
        json.WriteStartArray("rows");
        foreach (object?[] row in Rows)
        {
            json.WriteStartObject();
            for (int i = 0; i < row.Length; i++)
            {
                json.WritePropertyName(columns[i]);
                JsonSerializer.Serialize(json, row[i] switch { double number => double.IsFinite(number) ? number : null, int or long => row[i], var other => other?.ToString() });
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static string Short(object? cell) => cell switch
    {
        null or double.NaN => "-",
        double number => number == 0 ? "0" : Math.Abs(number) is >= 0.01 and < 1e6
            ? number.ToString(Math.Abs(number) >= 1000 ? "0" : Math.Abs(number) >= 10 ? "0.0" : "0.000", CultureInfo.InvariantCulture)
            : number.ToString("0.0e+0", CultureInfo.InvariantCulture),
        _ => Exact(cell),
    };

    private static string Exact(object? cell) => cell is double number
        ? number.ToString("R", CultureInfo.InvariantCulture)
        : Convert.ToString(cell, CultureInfo.InvariantCulture) ?? "";

    private static string Quoted(string text) => text.AsSpan().IndexOfAny(",\"\n") >= 0 ? $"\"{text.Replace("\"", "\"\"")}\"" : text;
}

/// <summary>Reached or missed.</summary>
internal static class Verdict
{
    public static string Of(bool reached) => reached ? "reached" : "MISSED";
}

/// <summary>Counts of cases that run in parallel, by the columns or rows of their table, and examples of those that fail.</summary>
internal sealed class LabCounts
{
    private readonly Lock _lock = new();
    private readonly Dictionary<string, object> _numbers = [];
    private readonly List<string> _examples = [];

    /// <summary>A count; 0 if nothing was added to it.</summary>
    public long this[string column]
    {
        get
        {
            lock (_lock)
            {
                return _numbers.GetValueOrDefault(column) is long count ? count : 0;
            }
        }
    }

    /// <summary>The failures, in order of their text.</summary>
    public IEnumerable<string> Examples => _examples.Order(StringComparer.Ordinal);

    /// <summary>Runs a number of cases in parts, on all processors.</summary>
    /// <param name="count">The number of cases.</param>
    /// <param name="perPart">The number of cases of a part.</param>
    /// <param name="run">Runs a part: the counts, the index of the part, and its number of cases.</param>
    public static LabCounts Of(int count, int perPart, Action<LabCounts, int, int> run)
    {
        var counts = new LabCounts();
        Parallel.For(0, (count + perPart - 1) / perPart, part => run(counts, part, Math.Min(perPart, count - (part * perPart))));
        return counts;
    }

    /// <summary>Adds to a count.</summary>
    public void Add(string column, long number = 1)
    {
        lock (_lock)
        {
            _numbers[column] = this[column] + number;
        }
    }

    /// <summary>Adds a case to a count if a condition holds.</summary>
    public void AddIf(bool holds, string column) => Add(column, holds ? 1 : 0);

    /// <summary>Keeps the largest number of a column.</summary>
    public void Most<T>(string column, T number)
        where T : struct, IComparable<T>
    {
        lock (_lock)
        {
            _numbers[column] = _numbers.GetValueOrDefault(column) is T most && most.CompareTo(number) >= 0 ? most : number;
        }
    }

    /// <summary>Counts a case that fails, and keeps it as an example.</summary>
    public void Require(bool holds, string column, FormattableString example)
    {
        AddIf(!holds, column);
        if (!holds)
        {
            lock (_lock)
            {
                _examples.Add(FormattableString.Invariant(example));
            }
        }
    }

    /// <summary>Returns a count as a share of another one, %; 100 if that one is 0.</summary>
    public double Percent(string part, string whole) => this[whole] > 0 ? 100.0 * this[part] / this[whole] : 100;

    /// <summary>The cells of columns.</summary>
    public IEnumerable<object?> Cells(params IEnumerable<string> columns) => columns.Select(column => _numbers.GetValueOrDefault(column, 0L));

    /// <summary>Adds a row for each count to a table of names, counts and verdicts.</summary>
    /// <param name="table">The table.</param>
    /// <param name="rows">The names; those of faults must be 0.</param>
    public void AddTo(LabTable table, params IEnumerable<(string Row, bool IsFault)> rows)
    {
        foreach ((string row, bool isFault) in rows)
        {
            table.Count(row, _numbers.GetValueOrDefault(row, 0L), isFault ? this[row] == 0 : null);
        }
    }
}

/// <summary>Mean, percentiles and worst of some values; all are 0 if there are no values.</summary>
internal sealed class Spread(IEnumerable<double> values)
{
    private readonly double[] _sorted = [.. values.Order().DefaultIfEmpty()];

    public double Mean => _sorted.Average();

    public double Median => Percentile(0.5);

    public double P95 => Percentile(0.95);

    public double Worst => _sorted[^1];

    /// <summary>Returns the smallest value that at least the given share does not exceed.</summary>
    public double Percentile(double share) => _sorted[Math.Max(0, (int)Math.Ceiling(share * _sorted.Length) - 1)];
}

/// <summary>The largest value so far, and the case that has it.</summary>
/// <param name="none">The case before the first value.</param>
internal sealed class Peak<T, TCase>(TCase none)
    where T : struct, IComparable<T>
{
    public T Most { get; private set; }

    public TCase At { get; private set; } = none;

    public void See(T value, TCase at)
    {
        if (value.CompareTo(Most) > 0)
        {
            (Most, At) = (value, at);
        }
    }
}
