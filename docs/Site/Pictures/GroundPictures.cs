using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Shapes;

namespace FootballPhysics.Site.Pictures;

/// <summary>What uneven ground does between the heights that it is given.</summary>
internal static class GroundPictures
{
    /// <summary>A raised node, a step and a hill: the heights, and the ground between them.</summary>
    public static XElement Heights()
    {
        double[] heights = [0, 0, 0, 0, 0.3, 0, 0, 0, 0, 0, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.27, 0.19, 0.09, 0.03, 0.09, 0.19, 0.27, 0.3];
        var grid = new double[heights.Length, 1];
        for (int i = 0; i < heights.Length; i++)
        {
            grid[i, 0] = heights[i];
        }

        var through = new HeightField(0, 0, 1, grid);
        var smooth = HeightField.FromControlValues(0, 0, 1, grid);
        double[] places = [.. Enumerable.Range(0, (20 * (heights.Length - 1)) + 1).Select(k => 0.05 * k)];
        var chart = new Chart(new Axis("along, m") { Min = 0, Max = heights.Length - 1 }, new Axis("height, m") { Min = -0.1, Max = 0.4 }) { Title = "A raised node, a step and a hollow", Width = DocPictures.Width, PlotHeight = 170 };
        chart.Items.Add(new PolylineItem([.. places.Select(x => new PlotPoint(x, smooth.HeightAt(x, 0)))]) { Colour = Palette.Frame, Width = 1.5, Label = "FromControlValues" });
        chart.Items.Add(new PolylineItem([.. places.Select(x => new PlotPoint(x, through.HeightAt(x, 0)))]) { Colour = Palette.Green, Width = 2, Label = "new HeightField" });
        chart.Items.Add(new ScatterItem([.. heights.Select((height, i) => new PlotPoint(i, height))]) { Mark = Mark.Ring, Colour = Palette.Blue, Size = 3, Label = "heights" });
        return Svg.Standing("Uneven ground passes through the heights at its nodes, and overshoots where they jump", Figure.Stack("", chart.Draw()));
    }
}
