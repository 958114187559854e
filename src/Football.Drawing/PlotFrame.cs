namespace FootballPhysics.Drawing;

/// <summary>Where on the page a chart's values lie; its origin is the upper left corner of the plot.</summary>
public sealed class PlotFrame(PlotAxis x, PlotAxis y, double width, double height)
{
    public PlotAxis XAxis { get; } = x;

    public PlotAxis YAxis { get; } = y;

    public double Width { get; } = width;

    public double Height { get; } = height;

    public double X(double value) => XAxis.Fraction(value) * Width;

    public double Y(double value) => (1 - YAxis.Fraction(value)) * Height;

    /// <summary>Whether both axes have a place for the point.</summary>
    public bool Shows(PlotPoint point) => XAxis.Shows(point.X) && YAxis.Shows(point.Y);
}
