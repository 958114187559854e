using System.Globalization;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Scenarios.Input;
using Spectre.Console;

namespace FootballPhysics.Tool.Aim;

/// <summary>Formats a kick as a table.</summary>
internal static class AimTable
{
    public static void Print(AimResult kick, Terminal terminal)
    {
        Table table = new Table().Border(TableBorder.Simple).AddColumns("", "");
        void Row(string name, FormattableString value) => table.AddRow(Cell.Of(name), Cell.Of(value.ToString(CultureInfo.InvariantCulture)));
        Row("status", $"{Words.Of(kick.Status)}");
        if (kick.Reason is { } reason)
        {
            Row("reason", $"{reason}");
        }

        if (kick.BlockedBy is { } blocker)
        {
            Row("in the way", $"{blocker}");
        }

        Row("speed", $"{kick.Speed:0.00} m/s");
        Row("elevation", $"{kick.ElevationDegrees:0.00}°");
        Row("velocity", $"{kick.Velocity.X:0.000}, {kick.Velocity.Y:0.000}, {kick.Velocity.Z:0.000} m/s");
        Row("spin", $"{kick.Spin.X:0.00}, {kick.Spin.Y:0.00}, {kick.Spin.Z:0.00} rad/s");
        Row("passes the target at", $"{1e3 * kick.Miss:0.0} mm after {kick.Time:0.000} s");
        if (kick.WaypointMiss is { } through)
        {
            Row("and the point on the way at", $"{1e3 * through:0.0} mm");
        }

        Row("simulations", $"{kick.Simulations}");
        terminal.PersonConsole.Write(table.HideHeaders());
    }
}
