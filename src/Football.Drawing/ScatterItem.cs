using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>Marked points.</summary>
public sealed class ScatterItem(IReadOnlyList<PlotPoint> points) : ChartItem
{
    public Mark Mark { get; init; } = Mark.Dot;

    /// <summary>Half the width of a mark, in pixels; default 3.5.</summary>
    public double Size { get; init; } = 3.5;

    /// <summary>The text of each point; an empty text or list for none.</summary>
    public IReadOnlyList<string> Captions { get; init; } = [];

    public override Bounds Bounds => Bounds.Of(points);

    public override IEnumerable<XElement> Draw(PlotFrame frame) =>
        points.Where(frame.Shows).Select(point => Shape(frame.X(point.X), frame.Y(point.Y)));

    public override XElement LegendKey(double x, double y) => Shape(x, y);

    public override IEnumerable<(double X, double Y)> Ink(PlotFrame frame) => points.Where(frame.Shows).Select(point => Place(frame, point));

    public override bool IsSeen(PlotFrame frame) => Ink(frame).Any(place => IsInside(frame, place));

    public override IEnumerable<ChartLabel> Labels(PlotFrame frame) => points.Zip(Captions, (point, caption) => (Place: Place(frame, point), caption))
        .Where(named => IsInside(frame, named.Place))
        .Select(named => new ChartLabel(named.Place.X, named.Place.Y, named.caption, Palette.Faint));

    private static (double X, double Y) Place(PlotFrame frame, PlotPoint point) => (frame.X(point.X), frame.Y(point.Y));

    private XElement Shape(double x, double y)
    {
        double r = Size;
        return Mark switch
        {
            Mark.Ring => Svg.Element("circle", [("cx", x), ("cy", y), ("r", r), ("fill", Palette.Paper), ("stroke", Colour), ("stroke-width", 1.5)]),
            Mark.Square => Polygon((x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)),
            Mark.Triangle => Polygon((x, y - r), (x + r, y + r), (x - r, y + r)),
            Mark.Diamond => Polygon((x, y - (1.3 * r)), (x + (1.3 * r), y), (x, y + (1.3 * r)), (x - (1.3 * r), y)),
            Mark.Cross => Svg.Element(
                "path",
                [("d", $"M{Svg.Number(x - r)},{Svg.Number(y - r)} L{Svg.Number(x + r)},{Svg.Number(y + r)} M{Svg.Number(x - r)},{Svg.Number(y + r)} L{Svg.Number(x + r)},{Svg.Number(y - r)}"),
                    ("stroke", Colour), ("stroke-width", 2.0), ("fill", "none")]),
            _ => Svg.Element("circle", [("cx", x), ("cy", y), ("r", r), ("fill", Colour)]),
        };
    }

    private XElement Polygon(params (double X, double Y)[] corners) => Svg.Element(
        "polygon",
        [("points", string.Join(' ', corners.Select(corner => $"{Svg.Number(corner.X)},{Svg.Number(corner.Y)}"))), ("fill", Colour)]);
}
