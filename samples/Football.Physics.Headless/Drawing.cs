using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Headless;

/// <summary>Draws the path of a shot from the side and from above, with its events.</summary>
internal static class Drawing
{
    public static XElement Of(string name, IReadOnlyList<Vector3d> path, IReadOnlyList<BallEvent> events)
    {
        Chart side = View(name, "height, m", path, events, place => new PlotPoint(-place.Z, place.Y));
        Chart above = View("from above", "to the left, m", path, events, place => new PlotPoint(-place.Z, -place.X));
        Chart.SameScale(side, above);
        return Figure.Stack("", side.Draw(), above.Draw());
    }

    private static Chart View(string title, string axis, IReadOnlyList<Vector3d> path, IReadOnlyList<BallEvent> events, Func<Vector3d, PlotPoint> at) =>
        new(new Axis("forward, m"), new Axis(axis))
        {
            Title = title,
            EqualScales = true,
            Items =
            {
                new PolylineItem([.. path.Select(at)]) { Label = "path", Colour = Palette.Blue },
                new ScatterItem([.. events.Select(item => at(item.Position))])
                {
                    Label = "events",
                    Colour = Palette.Red,
                    Captions = [.. events.Select(item => item.Kind is BallEventKind.Goal or BallEventKind.Rest ? item.Kind.ToString() : "")],
                },
            },
        };
}
