using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Benchmarks;

/// <summary>The history as a picture: a small chart per ratio, with a point per line of the file.</summary>
internal static class HistoryPicture
{
    private const string Title = "Ratios by version";

    public static XElement Draw(HistoryFile file)
    {
        string[] versions = [.. file.Versions];
        return Svg.Standing(Title, Figure.Tile(Title, [.. file.Ratios.Select(column => Chart(column, versions, [.. file.Of(column).Select(at => new PlotPoint(at.Line, at.Ratio))]))]));
    }

    private static XElement Chart(string column, string[] versions, PlotPoint[] points)
    {
        double most = points.Length > 0 ? points.Max(point => point.Y) : 1;
        var chart = new Chart(new Axis("line of the file") { Min = -0.5, Max = versions.Length - 0.5 }, new Axis("ratio") { Min = 0, Max = 1.3 * most })
        {
            Title = column,
            Width = 380,
            PlotHeight = 110,
        };
        chart.Items.Add(new PolylineItem(points) { Colour = Palette.Blue });
        chart.Items.Add(new ScatterItem(points) { Colour = Palette.Blue, Captions = [.. points.Select(point => versions[(int)point.X])] });
        return chart.Draw();
    }
}
