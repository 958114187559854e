using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>An area: the outline of an object as the chart shows it.</summary>
/// <param name="faces">The polygons that cover the area.</param>
public sealed class PolygonItem(IReadOnlyList<PlotPoint[]> faces) : ChartItem
{
    public string Fill { get; init; } = Palette.Object;

    /// <summary>The name, written next to the area; empty for none.</summary>
    public string Caption { get; init; } = "";

    public override Bounds Bounds => Bounds.Of([.. faces.SelectMany(face => face)]);

    public override IEnumerable<XElement> Draw(PlotFrame frame) => faces.Select(face => Svg.Element(
        "polygon",
        [
            ("points", string.Join(' ', face.Select(point => $"{Svg.Number(frame.X(point.X))},{Svg.Number(frame.Y(point.Y))}"))),
            ("fill", Fill), ("stroke", Colour), ("stroke-width", 0.8), ("stroke-linejoin", "round"),
        ]));

    public override XElement LegendKey(double x, double y) =>
        Svg.Element("rect", [("x", x - 6), ("y", y - 4), ("width", 12.0), ("height", 8.0), ("fill", Fill), ("stroke", Colour)]);

    public override IEnumerable<(double X, double Y)> Ink(PlotFrame frame) =>
        faces.SelectMany(face => Dense.Line([.. face.Append(face[0]).Select(point => (frame.X(point.X), frame.Y(point.Y)))]));

    public override IEnumerable<ChartLabel> Labels(PlotFrame frame)
    {
        if (Caption.Length > 0)
        {
            Bounds bounds = Bounds;
            yield return new ChartLabel(frame.X((bounds.MinX + bounds.MaxX) / 2), frame.Y(bounds.MaxY), Caption, Palette.Faint);
        }
    }
}
