using System.Xml.Linq;

namespace Football.Physics.Headless.Drawing;

/// <summary>Something drawn in a chart.</summary>
internal abstract class ChartItem
{
    public string Colour { get; init; } = Palette.Blue;

    /// <summary>Its entry in the legend; null for none.</summary>
    public string? Label { get; init; }

    /// <summary>The values it needs room for.</summary>
    public abstract Bounds Bounds { get; }

    public abstract IEnumerable<XElement> Draw(PlotFrame frame);

    /// <summary>Its sample in the legend, 16 wide around the given middle.</summary>
    public abstract XElement LegendKey(double x, double y);
}
