using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>An arrow with a caption in the upper left corner. It shows a direction that is the same everywhere, such as that of a wind.</summary>
/// <param name="x">The direction along the horizontal axis. The length of the vector must not be zero and does not matter.</param>
/// <param name="y">The direction along the vertical axis.</param>
/// <param name="caption">The text next to the arrow.</param>
public sealed class ArrowItem(double x, double y, string caption) : ChartItem
{
    private const double Reach = 14;

    public override Bounds Bounds => Bounds.Empty;

    public override IEnumerable<XElement> Draw(PlotFrame frame)
    {
        yield return Arrow(26, 26, Reach);
        yield return Svg.Text(48, 30, caption, size: 11, colour: Colour);
    }

    public override IEnumerable<(double X, double Y)> Ink(PlotFrame frame) => Dense.Line([(10, 26), (48 + Svg.WidthOf(caption), 26)]);

    public override XElement LegendKey(double x, double y) => Arrow(x, y, Reach / 2);

    private XElement Arrow(double middleX, double middleY, double reach)
    {
        // Pixels count downwards.
        double length = Math.Sqrt((x * x) + (y * y));
        (double dx, double dy) = (x / length * reach, -y / length * reach);
        (double tipX, double tipY) = (middleX + dx, middleY + dy);
        (double wingX, double wingY) = (tipX - (0.5 * dx), tipY - (0.5 * dy));
        string path = string.Join(' ', [
            $"M{Svg.Number(middleX - dx)},{Svg.Number(middleY - dy)} L{Svg.Number(tipX)},{Svg.Number(tipY)}",
            $"M{Svg.Number(wingX - (0.35 * dy))},{Svg.Number(wingY + (0.35 * dx))} L{Svg.Number(tipX)},{Svg.Number(tipY)}",
            $"L{Svg.Number(wingX + (0.35 * dy))},{Svg.Number(wingY - (0.35 * dx))}",
        ]);
        return Svg.Element("path", [("d", path), ("fill", "none"), ("stroke", Colour), ("stroke-width", 1.8)]);
    }
}
