using System.Text;
using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>Points joined by lines.</summary>
public sealed class PolylineItem(IReadOnlyList<PlotPoint> points) : ChartItem
{
    /// <summary>Points that are closer than this to the point before are omitted, in pixels.</summary>
    private const double Nearest = 0.4;

    public double Width { get; init; } = 1.6;

    /// <summary>The lengths of dashes and gaps, or "none". Default "none".</summary>
    public string Dash { get; init; } = "none";

    public override Bounds Bounds => Bounds.Of(points);

    public override IEnumerable<XElement> Draw(PlotFrame frame)
    {
        var text = new StringBuilder();
        (double X, double Y) last = (double.NaN, double.NaN);
        for (int i = 0; i < points.Count; i++)
        {
            if (!frame.Shows(points[i]))
            {
                continue;
            }

            (double x, double y) = (frame.X(points[i].X), frame.Y(points[i].Y));
            bool near = Math.Abs(x - last.X) < Nearest && Math.Abs(y - last.Y) < Nearest;
            if (!near || i == points.Count - 1)
            {
                text.Append(text.Length > 0 ? " " : "").Append(Svg.Number(x)).Append(',').Append(Svg.Number(y));
                last = (x, y);
            }
        }

        yield return Svg.Element(
            "polyline",
            [("points", text.ToString()), ("fill", "none"), ("stroke", Colour), ("stroke-width", Width), ("stroke-dasharray", Dash), ("stroke-linejoin", "round")]);
    }

    public override XElement LegendKey(double x, double y) => Svg.Line(x - 8, y, x + 8, y, Colour, Width, Dash);

    public override IEnumerable<(double X, double Y)> Ink(PlotFrame frame) =>
        Dense.Line([.. points.Where(frame.Shows).Select(point => (frame.X(point.X), frame.Y(point.Y)))]);

    /// <summary>True if the visible part extends over at least two pixels along an axis.</summary>
    public override bool IsSeen(PlotFrame frame)
    {
        (double X, double Y)[] inside = [.. Ink(frame).Where(place => IsInside(frame, place))];
        return inside.Length > 1 && Math.Max(inside.Max(place => place.X) - inside.Min(place => place.X), inside.Max(place => place.Y) - inside.Min(place => place.Y)) >= 2;
    }
}
