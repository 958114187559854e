using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>An item of a chart.</summary>
public abstract class ChartItem
{
    public string Colour { get; init; } = Palette.Blue;

    /// <summary>The text in the legend; null for no entry.</summary>
    public string? Label { get; init; }

    /// <summary>The range of values that the chart must show for this item.</summary>
    public abstract Bounds Bounds { get; }

    public abstract IEnumerable<XElement> Draw(PlotFrame frame);

    /// <summary>Draws the sample in the legend, 16 pixels wide, centred on a point.</summary>
    public abstract XElement LegendKey(double x, double y);

    /// <summary>Returns points that labels should not cover, in pixels; empty if the chart does not show the item.</summary>
    public virtual IEnumerable<(double X, double Y)> Ink(PlotFrame frame) => [];

    public virtual IEnumerable<ChartLabel> Labels(PlotFrame frame) => [];

    /// <summary>True if any part of the item is visible. The legend omits invisible items.</summary>
    public virtual bool IsSeen(PlotFrame frame) => true;

    /// <summary>True if a point is inside the plot.</summary>
    protected static bool IsInside(PlotFrame frame, (double X, double Y) place) =>
        place.X >= 0 && place.X <= frame.Width && place.Y >= 0 && place.Y <= frame.Height;
}
