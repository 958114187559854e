using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>A chart: axes with units and ticks, items, and a legend.</summary>
public sealed class Chart(Axis x, Axis y)
{
    private const double Left = 56;
    private const double Right = 12;
    private const double Top = 26;
    private const double Bottom = 40;
    private const double Row = 16;

    /// <summary>
    /// The common horizontal range and scale of charts drawn by <see cref="SameScale"/>; null for a single chart. The unit is in axis units per
    /// pixel.
    /// </summary>
    private (double Min, double Max, double Unit)? _shared;

    public string Title { get; init; } = "";

    /// <summary>The width of the whole chart, in pixels.</summary>
    public double Width { get; init; } = 640;

    /// <summary>The height of the plot, in pixels. With <see cref="EqualScales"/>, the minimum height.</summary>
    public double PlotHeight { get; init; } = 300;

    /// <summary>The maximum height of the plot with <see cref="EqualScales"/>, in pixels.</summary>
    public double MaximumPlotHeight { get; init; } = 320;

    /// <summary>True if a unit has the same length along both axes. The axes are then extended; the data is never distorted.</summary>
    public bool EqualScales { get; init; }

    public string Background { get; init; } = Palette.Paper;

    /// <summary>The items to draw, from back to front.</summary>
    public List<ChartItem> Items { get; } = [];

    /// <summary>Gives charts with equal scales the same horizontal range and the same scale.</summary>
    public static void SameScale(params IReadOnlyList<Chart> charts)
    {
        Bounds[] data = [.. charts.Select(chart => chart.Data)];
        double min = data.Min(bounds => bounds.MinX);
        double max = data.Max(bounds => bounds.MaxX);
        foreach (Chart chart in charts)
        {
            chart._shared = (min, max, 0);
        }

        double unit = charts.Max(chart => chart.Unit);
        foreach (Chart chart in charts)
        {
            chart._shared = (min, max, unit);
        }
    }

    public XElement Draw()
    {
        PlotFrame frame = Fit();
        string[] title = [.. Svg.Lines(Title, Width - Left - Right, 13)];
        List<XElement> legend = Legend(frame, title, out double legendHeight);
        double top = Top + legendHeight;
        XElement inside = Svg.Element(
            "svg",
            [("x", Left), ("y", top), ("width", frame.Width), ("height", frame.Height), ("overflow", "hidden")],
            Svg.Element("rect", [("width", frame.Width), ("height", frame.Height), ("fill", Background)]),
            Grid(frame),
            Items.SelectMany(item => item.Draw(frame)),
            Labels(frame));
        return Svg.Root(
            Width,
            top + frame.Height + Bottom,
            title.Select((line, i) => Svg.Text(Left, 16 + (i * Row), line, size: 13, bold: true)),
            legend,
            inside,
            Svg.Element("rect", [("x", Left), ("y", top), ("width", frame.Width), ("height", frame.Height), ("fill", "none"), ("stroke", Palette.Frame)]),
            TickLabels(frame, top),
            Svg.Text(Left + (frame.Width / 2), top + frame.Height + 32, x.Title, "middle"),
            Svg.Element("g", [("transform", $"translate(11 {Svg.Number(top + (frame.Height / 2))}) rotate(-90)")], Svg.Text(0, 0, y.Title, "middle")));
    }

    private static double AboutX(PlotFrame frame) => frame.Width / 64;

    private static double AboutY(PlotFrame frame) => Math.Max(3, frame.Height / 38);

    private static IEnumerable<XElement> Grid(PlotFrame frame)
    {
        foreach (double tick in frame.XAxis.Ticks(AboutX(frame)))
        {
            yield return Svg.Line(frame.X(tick), 0, frame.X(tick), frame.Height, Palette.Grid);
        }

        foreach (double tick in frame.YAxis.Ticks(AboutY(frame)))
        {
            yield return Svg.Line(0, frame.Y(tick), frame.Width, frame.Y(tick), Palette.Grid);
        }
    }

    private static IEnumerable<XElement> TickLabels(PlotFrame frame, double top)
    {
        double bottom = top + frame.Height;
        foreach (double tick in frame.XAxis.Ticks(AboutX(frame)))
        {
            double at = Left + frame.X(tick);
            yield return Svg.Line(at, bottom, at, bottom + 4, Palette.Frame);
            yield return Svg.Text(at, bottom + 16, Ticks.Label(tick), "middle", 11);
        }

        foreach (double tick in frame.YAxis.Ticks(AboutY(frame)))
        {
            double at = top + frame.Y(tick);
            yield return Svg.Line(Left - 4, at, Left, at, Palette.Frame);
            yield return Svg.Text(Left - 7, at + 3.5, Ticks.Label(tick), "end", 11);
        }
    }

    private Bounds Data => Items.Aggregate(Bounds.Empty, static (bounds, item) => bounds.With(item.Bounds));

    private double PlotWidth => Width - Left - Right;

    /// <summary>Axis units per pixel, with equal scales.</summary>
    private double Unit
    {
        get
        {
            (PlotAxis fitX, PlotAxis fitY) = Axes();
            double rangeY = fitY.Max - fitY.Min;
            double own = Math.Max((fitX.Max - fitX.Min) / PlotWidth, rangeY / MaximumPlotHeight);
            return Math.Max(own, _shared?.Unit ?? 0);
        }
    }

    private (PlotAxis X, PlotAxis Y) Axes()
    {
        Bounds data = Data;
        return (PlotAxis.Fit(x, _shared?.Min ?? data.MinX, _shared?.Max ?? data.MaxX), PlotAxis.Fit(y, data.MinY, data.MaxY));
    }

    private PlotFrame Fit()
    {
        (PlotAxis fitX, PlotAxis fitY) = Axes();
        if (!EqualScales)
        {
            return new PlotFrame(fitX, fitY, PlotWidth, PlotHeight);
        }

        double unit = Unit;
        double height = Math.Clamp((fitY.Max - fitY.Min) / unit, PlotHeight, MaximumPlotHeight);
        return new PlotFrame(Widen(fitX, unit * PlotWidth), Widen(fitY, unit * height), PlotWidth, height);
    }

    private List<XElement> Labels(PlotFrame frame)
    {
        var layout = new LabelLayout(frame.Width, frame.Height, Background);
        foreach (ChartItem item in Items)
        {
            layout.Draw(item.Ink(frame));
        }

        return [.. Items.SelectMany(item => item.Labels(frame)).Select(layout.Place)];
    }

    /// <summary>Extends an axis to a range; an end that <see cref="Axis"/> fixes does not move.</summary>
    private static PlotAxis Widen(PlotAxis axis, double range)
    {
        double more = range - (axis.Max - axis.Min);
        double below = axis.Axis.Min is not null ? 0 : axis.Axis.Max is not null ? more : more / 2;
        return axis.Between(axis.Min - below, axis.Max + (more - below));
    }

    /// <summary>Draws the legend: right-aligned in the row of the title, and in further rows if it does not fit there.</summary>
    private List<XElement> Legend(PlotFrame frame, string[] title, out double height)
    {
        List<ChartItem> entries = [.. Items.Where(item => item.Label is not null && item.IsSeen(frame)).DistinctBy(item => item.Label)];
        var drawn = new List<XElement>();
        double begin = Left + Svg.WidthOf(title[^1], 13) + 24;
        double total = entries.Sum(entry => 30 + Svg.WidthOf(entry.Label!, 11));
        bool besideTitle = begin + total <= Width - Right;
        double at = besideTitle ? Width - Right - total : Left;
        double row = title.Length - (besideTitle ? 1 : 0);
        foreach (ChartItem entry in entries)
        {
            double width = 30 + Svg.WidthOf(entry.Label!, 11);
            if (at + width > Width - Right + 1)
            {
                at = Left;
                row++;
            }

            double middle = 12 + (row * Row);
            drawn.Add(entry.LegendKey(at + 8, middle));
            drawn.Add(Svg.Text(at + 20, middle + 3.5, entry.Label!, size: 11));
            at += width;
        }

        height = row * Row;
        return drawn;
    }
}
