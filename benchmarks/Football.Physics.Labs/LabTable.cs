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
