using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>Adjacent bars on a common base: a histogram.</summary>
/// <param name="edges">The edges of the bars along x: one more than the number of bars.</param>
/// <param name="heights">The heights of the bars.</param>
public sealed class BarsItem(IReadOnlyList<double> edges, IReadOnlyList<double> heights) : ChartItem
{
    public override Bounds Bounds => heights.Count == 0
        ? Bounds.Empty
        : new Bounds(edges[0], edges[heights.Count], Math.Min(0, heights.Min()), heights.Max());

    /// <summary>Counts values into bars of equal width.</summary>
    public static BarsItem Histogram(IReadOnlyList<double> values, int bars, string colour, string? label = null)
    {
        double min = values.Min();
        double max = values.Max();
        double width = max > min ? (max - min) / bars : 1;
        var counts = new double[bars];
        foreach (double value in values)
        {
            counts[Math.Min(bars - 1, (int)((value - min) / width))]++;
        }

        return new BarsItem([.. Enumerable.Range(0, bars + 1).Select(i => min + (i * width))], counts) { Colour = colour, Label = label };
    }

    public override IEnumerable<XElement> Draw(PlotFrame frame)
    {
        // On a logarithmic axis, bars start at its lower end.
        double bottom = frame.YAxis.Shows(0) ? frame.Y(Math.Max(0, frame.YAxis.Min)) : frame.Height;
        for (int i = 0; i < heights.Count; i++)
        {
            if (!frame.Shows(new PlotPoint(edges[i], heights[i])))
            {
                continue;
            }

            double left = frame.X(edges[i]);
            double end = frame.Y(heights[i]);
            yield return Svg.Element(
                "rect",
                [
                    ("x", left), ("y", Math.Min(end, bottom)), ("width", Math.Max(0.5, frame.X(edges[i + 1]) - left - 0.5)),
                    ("height", Math.Abs(bottom - end)), ("fill", Colour), ("fill-opacity", 0.8),
                ]);
        }
    }

    public override XElement LegendKey(double x, double y) =>
        Svg.Element("rect", [("x", x - 6), ("y", y - 4), ("width", 12.0), ("height", 8.0), ("fill", Colour), ("fill-opacity", 0.8)]);
}
