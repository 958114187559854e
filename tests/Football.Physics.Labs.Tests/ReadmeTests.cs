using System.Globalization;
using System.Text;
using System.Text.Json;

namespace FootballPhysics.Labs.Tests;

/// <summary>The table of the page on accuracy is what its commands print.</summary>
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

    private static JsonElement Rows(string lab) => FootballCommand.Run("", "lab", lab).Result.GetProperty("tables")[0].GetProperty("rows");

    private static bool Is(JsonElement row, string column, string value) => row.GetProperty(column).GetString() == value;

    private static double Number(JsonElement row, string column) => row.GetProperty(column).GetDouble();

    private static string Name(string method) => method.ToUpperInvariant();

    private static void Add(StringBuilder table, string what, double thesis, double here, string command) =>
        table.Append(CultureInfo.InvariantCulture, $"| {what} | {thesis:G2} | {(here < 0.001 ? here.ToString("0e+0", CultureInfo.InvariantCulture) : here.ToString("G2", CultureInfo.InvariantCulture))} | `{command}` |\n");
}
