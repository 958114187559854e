using System.Globalization;
using System.Text;
using System.Text.Json;
using Spectre.Console;

namespace FootballPhysics.Labs;

/// <summary>Rows of named columns: a table for a person, CSV, or JSON.</summary>
internal sealed class LabTable(string name, params string[] columns)
{
    public string Name { get; } = name;

    public List<object?[]> Rows { get; } = [];

    public void Add(params object?[] cells) => Rows.Add(cells);

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

    public void WriteCsv(StringBuilder to)
    {
        to.Append(string.Join(',', columns.Prepend("table").Select(Quoted))).Append('\n');
        foreach (object?[] row in Rows)
        {
            to.Append(string.Join(',', row.Select(Exact).Prepend(Name).Select(Quoted))).Append('\n');
        }
    }

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
                switch (row[i])
                {
                    case double number when double.IsFinite(number):
                        json.WriteNumberValue(number);
                        break;
                    case int or long:
                        json.WriteNumberValue(Convert.ToInt64(row[i], CultureInfo.InvariantCulture));
                        break;
                    case null or double:
                        json.WriteNullValue();
                        break;
                    default:
                        json.WriteStringValue(row[i]!.ToString());
                        break;
                }
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static string Short(object? cell) => cell switch
    {
        null => "-",
        double.NaN => "-",
        double number => number == 0 ? "0" : Math.Abs(number) is >= 0.01 and < 1e6
            ? number.ToString(Math.Abs(number) >= 1000 ? "0" : Math.Abs(number) >= 10 ? "0.0" : "0.000", CultureInfo.InvariantCulture)
            : number.ToString("0.0e+0", CultureInfo.InvariantCulture),
        IFormattable other => other.ToString(null, CultureInfo.InvariantCulture),
        _ => cell.ToString() ?? "",
    };

    private static string Exact(object? cell) => cell switch
    {
        null => "",
        double number => number.ToString("R", CultureInfo.InvariantCulture),
        IFormattable other => other.ToString(null, CultureInfo.InvariantCulture),
        _ => cell.ToString() ?? "",
    };

    private static string Quoted(string text) => text.AsSpan().IndexOfAny(",\"\n") >= 0 ? $"\"{text.Replace("\"", "\"\"")}\"" : text;
}
