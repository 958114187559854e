using FootballPhysics.Tool.Commands;
using System.Globalization;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;
using Spectre.Console;

namespace FootballPhysics.Tool.Gallery;

/// <summary>Prints a shot in a terminal: its figures, its events, and a sketch of the view from behind its launch.</summary>
internal sealed class ShotReport
{
    /// <summary>The maximum number of events that are listed; only the first ones are.</summary>
    private const int MostEvents = 24;

    /// <summary>The width of a sketch, in letters. With its labels, it fits into 80 columns.</summary>
    private const int Columns = 66;

    private readonly Scenario _scenario;
    private readonly Vector3d _forward;
    private readonly Vector3d _left;

    /// <summary>Creates a report for a view direction.</summary>
    /// <param name="scenario">The shot.</param>
    /// <param name="forward">The horizontal view direction; null for that of the launch.</param>
    public ShotReport(Scenario scenario, Vector3d? forward = null)
    {
        _scenario = scenario;
        Vector3d flat = forward ?? scenario.Velocity.Horizontal;
        _forward = flat.Length > 0 ? flat / flat.Length : ViewFrame.Direction(1, 0, 0);
        _left = Vector3d.Cross(Vector3d.Up, _forward);
    }

    /// <summary>Returns a table of the figures with one row per shot, and the names of named shots.</summary>
    public static Table Figures(IReadOnlyList<(string? Name, ShotFigures Figures)> shots)
    {
        bool named = shots.Any(shot => shot.Name is not null);
        Table table = new Table().Border(TableBorder.Simple);
        foreach (string column in named ? ShotFigures.Columns.Prepend("shot") : ShotFigures.Columns)
        {
            table.AddColumn(new TableColumn(column) { Alignment = column == "shot" ? Justify.Left : Justify.Right });
        }

        foreach ((string? name, ShotFigures figures) in shots)
        {
            table.AddRow([.. named ? [Cell.Of(name ?? "")] : (string[])[], .. figures.Texts]);
        }

        return table;
    }

    /// <summary>Returns a table of the final states of several balls.</summary>
    private static Table Finals(IReadOnlyList<Moment> balls)
    {
        Table table = new Table().Border(TableBorder.Simple);
        foreach (string column in (ReadOnlySpan<string>)["ball", "time", "state", "place, m", "velocity, m/s", "spin, rad/s"])
        {
            table.AddColumn(new TableColumn(column));
        }

        for (int i = 0; i < balls.Count; i++)
        {
            Moment at = balls[i];
            table.AddRow(
                i.ToString(CultureInfo.InvariantCulture),
                at.Time.ToString("F3", CultureInfo.InvariantCulture),
                Words.Of(at.State),
                at.Position.ToString("F2", CultureInfo.InvariantCulture),
                at.Velocity.ToString("F2", CultureInfo.InvariantCulture),
                at.Spin.ToString("F1", CultureInfo.InvariantCulture));
        }

        return table;
    }

    /// <summary>Prints a result, with a sketch of the path if its samples fit into memory.</summary>
    public void Print(IAnsiConsole console, Outcome outcome)
    {
        if (outcome.Balls.Count > 0)
        {
            console.Write(Finals(outcome.Balls));
            return;
        }

        if (outcome.Samples is null && _scenario.CanKeepPath)
        {
            Print(console, new Flight(_scenario).Outcome);
            return;
        }

        if (outcome.Samples is not null)
        {
            console.Write(Figures([(null, ShotFigures.Of(outcome))]));
        }

        console.Write(Events(outcome.Events));
        if (outcome.Samples is not null)
        {
            Vector3d[] places = [.. Flight.LegsOf(outcome).SelectMany(leg => leg.Points)];
            double[] along = [.. places.Select(Along)];
            console.Write(new Text(new Sketch(Columns, 10).Draw("height", along, [.. places.Select(place => place.Y)])));
            console.Write(new Text(new Sketch(Columns, 7).Draw("left", along, [.. places.Select(Left)])));
        }
    }

    private static string Number(double value, string format) => (value + 0.0).ToString(format, CultureInfo.InvariantCulture);

    private double Along(Vector3d place) => Vector3d.Dot(place - _scenario.Position, _forward);

    private double Left(Vector3d place) => Vector3d.Dot(place - _scenario.Position, _left);

    private Table Events(IReadOnlyList<BallEvent> events)
    {
        Table table = new Table().Border(TableBorder.Simple).AddColumn("event");
        foreach (string column in (string[])["time s", "along m", "left m", "height m", "speed m/s", "spin rad/s"])
        {
            table.AddColumn(new TableColumn(column).RightAligned());
        }

        foreach (BallEvent item in events.Take(MostEvents))
        {
            table.AddRow(
                Words.Of(item.Kind), Number(item.Time, "0.000"), Number(Along(item.Position), "0.00"), Number(Left(item.Position), "0.00"),
                Number(item.Position.Y, "0.00"), Number(item.Velocity.Length, "0.00"), Number(item.Spin.Length, "0.0"));
        }

        return events.Count > MostEvents ? table.Caption(string.Create(CultureInfo.InvariantCulture, $"and {events.Count - MostEvents} more")) : table;
    }
}
