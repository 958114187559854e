using System.Globalization;
using FootballPhysics.Tool.Commands;
using Spectre.Console;

namespace FootballPhysics.Tool.Intercept;

/// <summary>Formats the interceptions as a table.</summary>
internal static class InterceptTable
{
    public static void Print(InterceptOutcome outcome, Terminal terminal)
    {
        Table table = new Table().Border(TableBorder.Simple).AddColumns("runner", "from, s", "to, s", "ball at, m", "height, m", "speed, m/s");
        for (int i = 0; i < outcome.Windows.Count; i++)
        {
            string name = Cell.Of(outcome.Scenario.Names[i]);
            foreach (InterceptWindow window in outcome.Windows[i])
            {
                string Number(FormattableString value) => Cell.Of(value.ToString(CultureInfo.InvariantCulture));
                table.AddRow(
                    name,
                    Number($"{window.From:0.000}"),
                    Number($"{window.To:0.000}"),
                    Number($"{window.Position.X:0.00}, {window.Position.Z:0.00}"),
                    Number($"{window.Position.Y:0.00}"),
                    Number($"{window.Velocity.Length:0.0}"));
            }

            if (outcome.Windows[i].Length == 0)
            {
                table.AddRow(name, "never");
            }
        }

        terminal.PersonConsole.Write(table);
        string first = outcome.First < 0 ? "Nobody gets to the ball."
            : double.IsFinite(outcome.Lead) ? FormattableString.Invariant($"First: {outcome.Scenario.Names[outcome.First]}, by {outcome.Lead:0.000} s.")
            : $"First: {outcome.Scenario.Names[outcome.First]}; nobody else.";
        terminal.Person.WriteLine(first);
    }
}
