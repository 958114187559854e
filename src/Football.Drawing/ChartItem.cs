using System.Xml.Linq;

namespace FootballPhysics.Drawing;

/// <summary>Something drawn in a chart.</summary>
public abstract class ChartItem
{
    public string Colour { get; init; } = Palette.Blue;

    /// <summary>Its entry in the legend; null for none.</summary>
    public string? Label { get; init; }

    /// <summary>The values it needs room for.</summary>
    public abstract Bounds Bounds { get; }

    public abstract IEnumerable<XElement> Draw(PlotFrame frame);

    /// <summary>Its sample in the legend, 16 wide around the given middle.</summary>
    public abstract XElement LegendKey(double x, double y);

    /// <summary>Places of the page, in pixels, that a label must not cover; in a chart that shows nothing of it there are none.</summary>
    public virtual IEnumerable<(double X, double Y)> Ink(PlotFrame frame) => [];

    /// <summary>Words that belong to it.</summary>
    public virtual IEnumerable<ChartLabel> Labels(PlotFrame frame) => [];

    /// <summary>Whether anything of it is to be seen; what is not has no place in a legend.</summary>
    public virtual bool IsSeen(PlotFrame frame) => true;

    /// <summary>Whether a place is inside the plot.</summary>
    protected static bool IsInside(PlotFrame frame, (double X, double Y) place) =>
        place.X >= 0 && place.X <= frame.Width && place.Y >= 0 && place.Y <= frame.Height;
}
