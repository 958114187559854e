using System.Text;
using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>Lines that form one object: the meshes of a net, the markings of a pitch, the frame of a goal.</summary>
public sealed class LinesItem(IReadOnlyList<PlotPoint[]> lines) : ChartItem
{
    public double Width { get; init; } = 1;

    /// <summary>The width in axis units, used if it exceeds the minimum width in pixels; 0 for the minimum width.</summary>
    public double Thickness { get; init; }

    /// <summary>The name, written next to the topmost line; empty for none.</summary>
    public string Caption { get; init; } = "";

    /// <summary>True if the chart must show all of the lines; otherwise it clips lines that do not fit. Default true.</summary>
    public bool NeedsRoom { get; init; } = true;

    public override Bounds Bounds => NeedsRoom ? Bounds.Of([.. lines.SelectMany(line => line)]) : Bounds.Empty;

    public override IEnumerable<XElement> Draw(PlotFrame frame)
    {
        var path = new StringBuilder();
        foreach (PlotPoint[] line in lines)
        {
            for (int i = 0; i < line.Length; i++)
            {
                path.Append(i == 0 ? "M" : "L").Append(Svg.Number(frame.X(line[i].X))).Append(',').Append(Svg.Number(frame.Y(line[i].Y)));
            }
        }

        double pixels = Thickness * frame.Width / (frame.XAxis.Max - frame.XAxis.Min);
        yield return Svg.Element(
            "path",
            [("d", path.ToString()), ("fill", "none"), ("stroke", Colour), ("stroke-width", Math.Max(Width, pixels)), ("stroke-linecap", "round")]);
    }

    public override XElement LegendKey(double x, double y) => Svg.Line(x - 8, y, x + 8, y, Colour, Width);

    public override IEnumerable<(double X, double Y)> Ink(PlotFrame frame) =>
        Thickness > 0 ? lines.SelectMany(line => Dense.Line([.. line.Select(point => (frame.X(point.X), frame.Y(point.Y)))])) : [];

    public override IEnumerable<ChartLabel> Labels(PlotFrame frame)
    {
        (double X, double Y)[] seen = [.. lines.SelectMany(line => Dense.Line([.. line.Select(point => (frame.X(point.X), frame.Y(point.Y)))])).Where(place => IsInside(frame, place))];
        if (Caption.Length > 0 && seen.Length > 0)
        {
            (double X, double Y) top = seen.MinBy(place => place.Y);
            double across = seen.Where(place => place.Y < top.Y + 1).Average(place => place.X);
            yield return new ChartLabel(across, top.Y, Caption, Palette.Faint);
        }
    }
}
