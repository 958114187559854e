using System.Xml.Linq;

namespace Football.Physics.Headless.Drawing;

/// <summary>A rectangle between values of both axes: a region, an object, a bar.</summary>
internal sealed class RectangleItem(Bounds area) : ChartItem
{
    public string Fill { get; init; } = Palette.Object;

    /// <summary>Its name, written beside its upper edge.</summary>
    public string Caption { get; init; } = "";

    /// <summary>Whether the chart is to make room for all of it; otherwise what does not fit is cut off.</summary>
    public bool NeedsRoom { get; init; } = true;

    public override Bounds Bounds => NeedsRoom ? area : Bounds.Empty;

    public override IEnumerable<XElement> Draw(PlotFrame frame)
    {
        double left = frame.X(area.MinX);
        double top = frame.Y(area.MaxY);
        double width = Math.Max(1, frame.X(area.MaxX) - left);
        double height = Math.Max(1, frame.Y(area.MinY) - top);
        yield return Svg.Element(
            "rect",
            [("x", left), ("y", top), ("width", width), ("height", height), ("fill", Fill), ("stroke", Colour), ("stroke-width", 0.8)]);
        if (Caption.Length > 0)
        {
            double middle = Math.Clamp(left + (width / 2), Svg.WidthOf(Caption, 9) / 2, frame.Width - (Svg.WidthOf(Caption, 9) / 2));
            yield return Svg.Text(middle, Math.Max(9, top - 3), Caption, "middle", 9, Palette.Faint);
        }
    }

    public override XElement LegendKey(double x, double y) =>
        Svg.Element("rect", [("x", x - 6), ("y", y - 4), ("width", 12.0), ("height", 8.0), ("fill", Fill), ("stroke", Colour)]);
}
