using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Tool.Fit;

/// <summary>Draws the fit of a match: a top view, the height over time, and the residuals of each flight.</summary>
internal static class MatchPicture
{
    private const double Width = 1500;

    public static XElement Draw(string title, MatchFitResult fit)
    {
        MatchPiece[] pieces = [.. fit.Pieces];
        MatchPiece[] flights = [.. pieces.Where(piece => piece.Kind == MatchPieceKind.Flight)];
        MatchPiece[] others = [.. pieces.Where(piece => piece.Kind is MatchPieceKind.Ground or MatchPieceKind.Lost && piece.Points > 0)];

        var above = new Chart(new Axis("x along the pitch, m"), new Axis("y across, m")) { Title = "From above", Width = Width, EqualScales = true, MaximumPlotHeight = 620 };
        AddSeen(above, others, point => new PlotPoint(point.X, -point.Z), Palette.Object, "seen: on the ground, or lost");
        AddSeen(above, flights, point => new PlotPoint(point.X, -point.Z), Palette.Frame, "seen: in flight");
        AddFitted(above, flights, (_, point) => new PlotPoint(point.X, -point.Z));
        AddEvents(above, pieces, piece => new PlotPoint(piece.Position.X, -piece.Position.Z));

        var figures = new List<XElement> { above.Draw() };
        double from = pieces.Min(piece => piece.StartTime);
        double to = pieces.Max(piece => piece.EndTime);
        const double Span = 30;
        int rows = (int)Math.Min(8, Math.Max(1, Math.Ceiling((to - from) / Span)));
        double length = (to - from) / rows;
        for (int i = 0; i < rows; i++)
        {
            double begin = from + (i * length);
            figures.Add(Side(pieces, begin, begin + length).Draw());
        }

        figures.Add(Distances(flights).Draw());
        return Figure.Stack(title, figures);
    }

    private static Chart Side(MatchPiece[] all, double from, double to)
    {
        MatchPiece[] pieces = [.. all.Where(piece => piece.EndTime >= from && piece.StartTime <= to)];
        MatchPiece[] flights = [.. pieces.Where(piece => piece.Kind == MatchPieceKind.Flight)];
        var chart = new Chart(new Axis("time, s") { Min = from, Max = to, Margin = 0 }, new Axis("height, m")) { Title = "From the side", Width = Width, PlotHeight = 220 };
        foreach ((MatchPieceKind kind, string colour, string label) in (ReadOnlySpan<(MatchPieceKind, string, string)>)
            [(MatchPieceKind.Ground, Palette.Object, "seen: on the ground"), (MatchPieceKind.Lost, Palette.Red, "seen: lost"), (MatchPieceKind.Flight, Palette.Frame, "seen: in flight")])
        {
            PlotPoint[] points = [.. pieces.Where(piece => piece.Kind == kind).SelectMany(piece => piece.Observed).Select(seen => new PlotPoint(seen.Time, seen.Position.Y))];
            if (points.Length > 0)
            {
                chart.Items.Add(new ScatterItem(points) { Colour = colour, Size = 2, Label = label });
            }
        }

        AddFitted(chart, flights, (time, point) => new PlotPoint(time, point.Y));
        AddEvents(chart, pieces, piece => new PlotPoint(piece.StartTime, piece.Position.Y));
        return chart;
    }

    private static Chart Distances(MatchPiece[] flights)
    {
        var chart = new Chart(new Axis("time, s"), new Axis("seen less fitted, cm")) { Title = "Distances by flight", Width = Width, PlotHeight = 220 };
        foreach ((string label, string colour, Func<Vector3d, double> of) in (ReadOnlySpan<(string, string, Func<Vector3d, double>)>)
            [("x", Palette.Blue, v => v.X), ("y across", Palette.Green, v => -v.Z), ("height", Palette.Orange, v => v.Y)])
        {
            bool first = true;
            foreach (MatchPiece flight in flights)
            {
                PlotPoint[] points = [.. flight.Observed.Select((seen, i) => new PlotPoint(seen.Time, 100 * of(seen.Position - flight.Fitted[i])))];
                chart.Items.Add(new PolylineItem(points) { Colour = colour, Width = 1, Label = first ? label : null });
                first = false;
            }
        }

        return chart;
    }

    private static void AddSeen(Chart chart, MatchPiece[] pieces, Func<Vector3d, PlotPoint> place, string colour, string label)
    {
        PlotPoint[] points = [.. pieces.SelectMany(piece => piece.Observed).Select(seen => place(seen.Position))];
        if (points.Length > 0)
        {
            chart.Items.Add(new ScatterItem(points) { Colour = colour, Size = 1.6, Label = label });
        }
    }

    private static void AddFitted(Chart chart, MatchPiece[] flights, Func<double, Vector3d, PlotPoint> place)
    {
        for (int i = 0; i < flights.Length; i++)
        {
            MatchPiece flight = flights[i];
            PlotPoint[] points = [.. flight.Fitted.Select((point, k) => place(flight.Observed[k].Time, point))];
            chart.Items.Add(new PolylineItem(points) { Colour = i % 2 == 0 ? Palette.Blue : Palette.Purple, Label = i < 2 ? "fitted flight" : null });
        }
    }

    private static void AddEvents(Chart chart, MatchPiece[] pieces, Func<MatchPiece, PlotPoint> place)
    {
        foreach ((MatchPieceKind kind, Mark mark, string colour, string label) in (ReadOnlySpan<(MatchPieceKind, Mark, string, string)>)
            [(MatchPieceKind.Impact, Mark.Triangle, Palette.Green, "impact"), (MatchPieceKind.Touch, Mark.Cross, Palette.Red, "touch")])
        {
            PlotPoint[] points = [.. pieces.Where(piece => piece.Kind == kind).Select(place)];
            if (points.Length > 0)
            {
                chart.Items.Add(new ScatterItem(points) { Colour = colour, Mark = mark, Size = 4, Label = label });
            }
        }
    }
}
