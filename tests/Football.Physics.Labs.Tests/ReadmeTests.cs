using System.Globalization;
using System.Text;
using System.Text.Json;

namespace FootballPhysics.Labs.Tests;

/// <summary>The tables of the page on accuracy and speed are what its commands print: the lab's errors, and the rows of docs/internals/benchmarks.md.</summary>
public sealed class ReadmeTests
{
    private const string Page = "docs/internals/accuracy.md";

    [Fact]
    public void Its_errors_are_those_of_the_lab()
    {
        JsonElement vacuum = Rows("vacuum");
        JsonElement consistency = Rows("consistency");
        var table = new StringBuilder("\n| mean error, mm | thesis | here | command |\n|---|--:|--:|---|\n");
        foreach (string method in new[] { "Rk2", "Rk4" })
        {
            JsonElement row = vacuum.EnumerateArray().Single(r => Is(r, "method", method) && Is(r, "impact", "Exact"));
            Add(table, $"landing in vacuum, {Name(method)}, 40 ms steps", Number(row, "thesis 40"), Number(row, "40 ms"), "lab vacuum");
        }

        foreach (string method in new[] { "Rk2", "Rk4" })
        {
            JsonElement row = consistency.EnumerateArray().Single(r =>
                Is(r, "set", "usual") && Is(r, "law", "published, jump located") && Is(r, "method", method) && Is(r, "steps", "10–20 ms"));
            Add(table, $"all forces, gap between 10 and 20 ms steps, {Name(method)}", Number(row, "thesis mean"), Number(row, "mean"), "lab consistency");
        }

        RepositoryFiles.AssertBetween(Page, "<!-- errors, from the lab -->\n", "\n<!-- /errors -->", table.ToString());
    }

    [Fact]
    public void Its_times_are_those_of_the_page_of_benchmarks()
    {
        string[][] rows = [.. RepositoryFiles.Text("docs/internals/benchmarks.md").Split('\n').Where(line => line.StartsWith('|')).Select(line => line.Split('|').Select(cell => cell.Trim()).ToArray())];
        var table = new StringBuilder("\n| | ns | ratio | reach | | error | thesis (Unity) |\n|---|--:|--:|--:|---|--:|--:|\n");
        foreach (string name in new[] { "RK2", "RK4" }.Select(method => $"a kick from foot to rest at 60 Hz, {method}, of a flight step"))
        {
            string[] row = rows.First(r => r[1] == name);
            table.Append(CultureInfo.InvariantCulture, $"| {name} | {row[2]} | {row[4]} | {row[5]} | {row[6]} | – | – |\n");
        }

        foreach (string name in new[]
        {
            "flight step, fast: RK2", "flight step, fast: RK4", "constant coefficients, RK2, of plain all-forces RK2", "3 s look-ahead, default scene, RK4, 80 ms steps, in plain RK2 steps",
            "many balls, 256-bit, fast: RK4", "many balls, 512-bit, fast: RK4", "many aims, 256-bit, to 1 mm, in plain RK2 steps",
        })
        {
            string[] row = rows.First(r => r[1] == name);
            table.Append(CultureInfo.InvariantCulture, $"| {name} | {row[2]} | {row[4]} | {row[5]} | {row[6]} | {row[8]} | {row[9]} |\n");
        }

        RepositoryFiles.AssertBetween(Page, "<!-- times, from docs/internals/benchmarks.md -->\n", "\n<!-- /times -->", table.ToString());
    }

    private static JsonElement Rows(string lab) => FootballCommand.Run("", "lab", lab).Result.GetProperty("tables")[0].GetProperty("rows");

    private static bool Is(JsonElement row, string column, string value) => row.GetProperty(column).GetString() == value;

    private static double Number(JsonElement row, string column) => row.GetProperty(column).GetDouble();

    private static string Name(string method) => method.ToUpperInvariant();

    private static void Add(StringBuilder table, string what, double thesis, double here, string command) =>
        table.Append(CultureInfo.InvariantCulture, $"| {what} | {thesis:G2} | {(here < 0.001 ? here.ToString("0e+0", CultureInfo.InvariantCulture) : here.ToString("G2", CultureInfo.InvariantCulture))} | `{command}` |\n");
}
