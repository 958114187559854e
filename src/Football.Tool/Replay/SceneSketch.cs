using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Tool.Replay;

/// <summary>Draws a scene in perspective as SVG: sky, grass, lines, shadows and objects, from far to near.</summary>
internal static class SceneSketch
{
    private const string Sky = "#dfeaf3";
    private const string Grass = "#7fae6b";

    /// <summary>The colours that dark mode replaces.</summary>
    public static IReadOnlyList<(string Light, string Dark)> Dark { get; } = [(Sky, "#0d1318"), (Grass, "#23402a"), (Palette.Blue, "#56b4e9")];

    /// <summary>Draws the sky and the grass, with stripes across the path.</summary>
    public static IEnumerable<XElement> Backdrop(Eye eye, Vector3d from, Vector3d to)
    {
        double horizon = Math.Clamp(eye.Horizon, 0, eye.Height);
        yield return Svg.Element("rect", [("width", eye.Width), ("height", eye.Height), ("fill", Sky)]);
        yield return Svg.Element("rect", [("y", horizon), ("width", eye.Width), ("height", eye.Height - horizon), ("fill", Grass)]);
        const double wide = 5.5;
        Vector3d along = (to - from).Horizontal.Normalized();
        Vector3d side = Vector3d.Cross(along, Vector3d.Up);
        Vector3d start = from.Horizontal;
        for (int i = -1; i < 10; i += 2)
        {
            Vector3d near = start + (Math.Max(-5, i * wide) * along);
            Vector3d far = start + ((i + 1) * wide * along);
            // Make a stripe as wide as possible: both ends must be in front of the camera.
            double half = 60;
            while (half > 1 && ((double[])[-half, half]).Any(across => eye.On(near + (across * side)) is null || eye.On(far + (across * side)) is null))
            {
                half *= 0.8;
            }

            if (eye.On(near) is not null)
            {
                Vector3d across = half * side;
                yield return Svg.Element("polygon", [("points", Points(eye, [near - across, near + across, far + across, far - across])), ("fill", "#ffffff"), ("fill-opacity", 0.09)]);
            }
        }
    }

    /// <summary>Draws the markings on the grass and the shadows of people.</summary>
    /// <param name="eye">The camera.</param>
    /// <param name="shapes">The shapes of the scene.</param>
    /// <param name="motion">Returns the movement of a shape in the image; null if it does not move.</param>
    public static IEnumerable<XElement> Lying(Eye eye, IReadOnlyList<SceneShape> shapes, Func<SceneShape, XElement?> motion)
    {
        foreach (XElement line in shapes.Where(shape => shape.Kind == SceneShapeKind.Marking).SelectMany(shape => shape.Lines).Select(line => Line(eye, line, "#ffffff", 0.9, 1.6)))
        {
            yield return line;
        }

        foreach ((SceneShape shape, Vector3d[] person) in shapes.SelectMany(shape => (shape.People ?? []).Select(person => (shape, person))))
        {
            if (eye.On(person[0].Horizontal) is { } feet)
            {
                yield return Svg.Element("ellipse", [("cx", feet.X), ("cy", feet.Y), ("rx", 0.45 * feet.Metre), ("ry", 0.12 * feet.Metre), ("fill", "#06120a"), ("fill-opacity", 0.3)], motion(shape));
            }
        }
    }

    /// <summary>Draws the objects. Returns each with the size of a metre at its distance, from far to near; guide lines are last.</summary>
    /// <param name="eye">The camera.</param>
    /// <param name="shapes">The shapes of the scene.</param>
    /// <param name="net">Draws a net of the scene.</param>
    /// <param name="motion">Returns the movement of a person in the image; null if he does not move.</param>
    public static List<(double Metre, XElement[] Drawn)> Standing(
        Eye eye, IReadOnlyList<SceneShape> shapes, Func<int, SceneShape, IEnumerable<XElement>> net, Func<SceneShape, XElement?> motion)
    {
        var all = new List<(double Metre, XElement[] Drawn)>();
        int nets = 0;
        foreach (SceneShape shape in shapes.Where(shape => shape.Kind != SceneShapeKind.Marking))
        {
            if (shape.Kind == SceneShapeKind.Net)
            {
                all.Add((Metre(eye, shape.Corners!), [.. net(nets++, shape)]));
            }
            else if (shape.People is { } people)
            {
                all.AddRange(people.Select((person, i) => (Metre(eye, [person[0], person[1]]), (XElement[])[Svg.Element("g", [], motion(shape), Person(eye, shape.Name, person, i))])));
            }
            else if (shape.Kind == SceneShapeKind.Guide)
            {
                all.Add((double.PositiveInfinity, [.. shape.Lines.Select(line => Line(eye, line, "#ffd23f", 0.9, 1.6))]));
            }
            else
            {
                all.AddRange(shape.Faces.OrderBy(face => Metre(eye, face)).Select(face => (Metre(eye, face), (XElement[])[Face(eye, face)])));
                all.AddRange(shape.Lines.Select(line => (Metre(eye, line), (XElement[])[.. Rod(eye, line, shape.Radius)])));
            }
        }

        return [.. all.OrderBy(item => item.Metre)];
    }

    /// <summary>Draws a line with the given width in the image.</summary>
    public static XElement Line(Eye eye, Vector3d[] line, string colour, double opacity, double width) => Svg.Element(
        "polyline",
        [("points", Points(eye, line)), ("fill", "none"), ("stroke", colour), ("stroke-opacity", opacity), ("stroke-width", width), ("stroke-linecap", "round"), ("stroke-linejoin", "round")]);

    /// <summary>Returns the positions in the image as an attribute; omits those behind the camera.</summary>
    public static string Points(Eye eye, IEnumerable<Vector3d> places) =>
        string.Join(' ', places.Select(eye.On).OfType<(double X, double Y, double Metre)>().Select(at => $"{Svg.Number(at.X)},{Svg.Number(at.Y)}"));

    private static double Metre(Eye eye, IReadOnlyCollection<Vector3d> places) => eye.On(places.Aggregate((a, b) => a + b) / places.Count)?.Metre ?? double.PositiveInfinity;

    private static XElement Face(Eye eye, Vector3d[] face) =>
        Svg.Element("polygon", [("points", Points(eye, face)), ("fill", "#5f7181"), ("stroke", "#3e4c59"), ("fill-opacity", 0.75)]);

    /// <summary>Draws a post or a crossbar, lit from the upper left; a single point is a ball.</summary>
    private static IEnumerable<XElement> Rod(Eye eye, Vector3d[] line, double radius)
    {
        double width = Math.Max(2, eye.On(line[0]) is { } first ? 2 * radius * first.Metre : 0);
        yield return Line(eye, line, "#c3ccd4", 1, width);
        yield return Line(eye, line, "#ffffff", 1, 0.6 * width);
    }

    /// <summary>Draws a person. Each limb is the convex hull of two discs: a polygon between two circles.</summary>
    public static IEnumerable<XElement> Person(Eye eye, string kit, Vector3d[] person, int who)
    {
        foreach (PersonLimbs limb in PersonLimbs.Of(person, kit, who).OrderBy(limb => (eye.On(0.5 * (limb.From + limb.To))?.Metre) ?? 0))
        {
            if (eye.On(limb.From) is not { } a || eye.On(limb.To) is not { } b)
            {
                continue;
            }

            (double ra, double rb) = (limb.FromRadius * a.Metre, limb.ToRadius * b.Metre);
            double angle = Math.Atan2(b.Y - a.Y, b.X - a.X);
            (double x, double y) = (-Math.Sin(angle), Math.Cos(angle));
            string corners = string.Join(' ', new[] { (a.X + (ra * x), a.Y + (ra * y)), (b.X + (rb * x), b.Y + (rb * y)), (b.X - (rb * x), b.Y - (rb * y)), (a.X - (ra * x), a.Y - (ra * y)) }
                .Select(at => $"{Svg.Number(at.Item1)},{Svg.Number(at.Item2)}"));
            yield return Svg.Element(
                "g",
                [("fill", limb.Colour)],
                Svg.Element("polygon", [("points", corners)]),
                Svg.Element("circle", [("cx", a.X), ("cy", a.Y), ("r", ra)]),
                Svg.Element("circle", [("cx", b.X), ("cy", b.Y), ("r", rb)]));
        }
    }
}
