using FootballPhysics.Drawing;
using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Tool.Gallery;

/// <summary>Adds the objects of a scene to a side view or top view.</summary>
internal static class SceneDrawing
{
    /// <summary>Adds goals, nets, obstacles and, in a top view, the markings.</summary>
    /// <param name="chart">The chart.</param>
    /// <param name="shapes">The shapes to draw.</param>
    /// <param name="project">Maps a position to the chart.</param>
    /// <param name="fromAbove">True for a top view, which shows the markings.</param>
    /// <param name="time">The time at which moving objects are drawn, in s.</param>
    public static void Add(Chart chart, IReadOnlyList<SceneShape> shapes, Func<Vector3d, PlotPoint> project, bool fromAbove, double time)
    {
        foreach (SceneShape shape in shapes)
        {
            PlotPoint[] Seen(Vector3d[] places) => [.. places.Select(place => project(place + (time * shape.Velocity)))];
            PlotPoint[][] lines = [.. shape.Lines.Select(Seen)];
            PlotPoint[][] faces = [.. shape.Faces.Select(Seen)];
            ChartItem? item = shape.Kind switch
            {
                SceneShapeKind.Marking => fromAbove ? new LinesItem(lines) { Colour = Palette.Marking, Width = 1.2, Caption = shape.Name, NeedsRoom = false } : null,
                SceneShapeKind.Guide => new LinesItem(lines) { Colour = Palette.Orange, Width = 1.6, Label = shape.Name },
                SceneShapeKind.Net => new LinesItem(lines) { Colour = Palette.Frame, Width = 0.4 },
                SceneShapeKind.Frame => new LinesItem(lines)
                {
                    Colour = Palette.Posts,
                    Width = 2,
                    Thickness = 2 * shape.Radius,
                    Caption = shape.Name == "crossbar" ? "goal" : "",
                },
                SceneShapeKind.Obstacle when faces.Length > 0 => new PolygonItem(faces) { Colour = Palette.Frame, Caption = shape.Name },
                SceneShapeKind.Obstacle when lines[0].Length == 1 => new PolygonItem([Circle(lines[0][0], shape.Radius)]) { Colour = Palette.Frame, Caption = shape.Name },
                SceneShapeKind.Obstacle => new LinesItem(lines) { Colour = Palette.Frame, Thickness = 2 * shape.Radius, Caption = shape.Name },
                _ => throw new ArgumentOutOfRangeException(nameof(shapes), shape.Kind, null),
            };
            if (item is not null)
            {
                chart.Items.Add(item);
            }
        }
    }

    /// <summary>Returns the outline of a ball to scale.</summary>
    public static PlotPoint[] Circle(PlotPoint middle, double radius) =>
        [.. Enumerable.Range(0, 32).Select(i => Math.SinCos(2 * Math.PI * i / 32)).Select(at => new PlotPoint(middle.X + (radius * at.Cos), middle.Y + (radius * at.Sin)))];
}
