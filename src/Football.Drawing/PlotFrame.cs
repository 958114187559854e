namespace FootballPhysics.Drawing;

/// <summary>Maps the values of a chart to pixels. The origin is the upper left corner of the plot.</summary>
public sealed class PlotFrame(PlotAxis x, PlotAxis y, double width, double height)
{
    public PlotAxis XAxis { get; } = x;

    public PlotAxis YAxis { get; } = y;

    public double Width { get; } = width;

    public double Height { get; } = height;

    public double X(double value) => XAxis.Fraction(value) * Width;

    public double Y(double value) => (1 - YAxis.Fraction(value)) * Height;

    /// <summary>True if both axes can show the point.</summary>
    public bool Shows(PlotPoint point) => XAxis.Shows(point.X) && YAxis.Shows(point.Y);
}
