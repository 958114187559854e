using System.Globalization;
using FootballPhysics.Tool.Commands;
using Spectre.Console;

namespace FootballPhysics.Tool.Fit;

/// <summary>Formats a fit as a table.</summary>
internal static class FitTable
{
    public static void Print(TrackFitResult fit, Terminal terminal)
    {
        Table table = new Table().Border(TableBorder.Simple).AddColumns("number", "value", "±", "");
        for (int i = 0; i < fit.Names.Count; i++)
        {
            table.AddRow(
                Cell.Of(fit.Names[i]),
                fit.Value(i).ToString("0.0000", CultureInfo.InvariantCulture),
                fit.StandardError(i).ToString("0.0000", CultureInfo.InvariantCulture),
                fit.IsIdentified(i) ? string.Empty : "not identified");
        }

        terminal.PersonConsole.Write(table);
        if (fit.Unidentified.Count > 0)
        {
            terminal.Person.WriteLine($"not identified: {string.Join(", ", fit.Unidentified)}");
        }

        terminal.Person.WriteLine(fit.Explanation);
        terminal.Person.WriteLine($"Good for: {FitWriter.GoodFor(fit)}.");
    }
}
