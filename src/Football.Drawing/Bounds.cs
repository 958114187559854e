namespace FootballPhysics.Drawing;

/// <summary>The range of values along both axes.</summary>
public readonly record struct Bounds(double MinX, double MaxX, double MinY, double MaxY)
{
    /// <summary>Bounds that contain no point.</summary>
    public static Bounds Empty => new(double.PositiveInfinity, double.NegativeInfinity, double.PositiveInfinity, double.NegativeInfinity);

    public static Bounds Of(IEnumerable<PlotPoint> points) => points.Aggregate(Empty, static (bounds, point) => bounds.With(point));

    public Bounds With(PlotPoint point) =>
        new(Math.Min(MinX, point.X), Math.Max(MaxX, point.X), Math.Min(MinY, point.Y), Math.Max(MaxY, point.Y));

    public Bounds With(Bounds other) => new(
        Math.Min(MinX, other.MinX), Math.Max(MaxX, other.MaxX), Math.Min(MinY, other.MinY), Math.Max(MaxY, other.MaxY));
}
