using System.Globalization;
using System.Xml.Linq;
using Football.Drawing;

namespace Football.Tool.Replay;

/// <summary>Shots as one SVG that moves by itself, for pages that run no program: seen from behind the ball, again and again.</summary>
internal static class MovingDrawing
{
    private const double Width = 720;
    private const double Height = 380;
    private const double Margin = 36;

    /// <summary>Time between two places of the ball, s.</summary>
    private const double Frame = 0.02;

    /// <summary>How long the picture rests before it begins again, s.</summary>
    private const double Pause = 1.2;

    /// <summary>Of a long roll only the beginning is shown, s.</summary>
    private const double Longest = 4;

    private const string Sky = "#dfeaf3";
    private const string Grass = "#7fae6b";

    /// <summary>What is dark where that is preferred.</summary>
    private static readonly (string Light, string Dark)[] Dark = [(Sky, "#0d1318"), (Grass, "#23402a"), (Palette.Blue, "#56b4e9")];

    /// <summary>The drawing.</summary>
    public static XElement Draw(ReplayPicture picture)
    {
        double end = Math.Min(Longest, picture.Shots.Max(shot => shot.Track.Keys[^1].Time));
        Vector3d[][] ways = [.. picture.Shots.Select(shot => Way(shot.Track, end))];
        IReadOnlyList<SceneShape> standing = [.. picture.Shapes.Where(shape => shape.Kind is not (SceneShapeKind.Marking or SceneShapeKind.Guide))];
        Vector3d to = standing.Where(shape => shape.Kind == SceneShapeKind.Frame).SelectMany(shape => shape.Points).DefaultIfEmpty(ways[0][^1]).Aggregate((a, b) => a + b)
            / Math.Max(1, standing.Where(shape => shape.Kind == SceneShapeKind.Frame).SelectMany(shape => shape.Points).Count());
        var eye = new Eye(ways[0][0], to.Horizontal, [.. ways.SelectMany(way => way), .. standing.SelectMany(shape => shape.Points)], Width, Height, Margin);
        double total = end + Pause;
        return Svg.Standing(
            picture.Name,
            Svg.Root(
                Width,
                Height,
                Svg.Element("rect", [("width", Width), ("height", Height), ("fill", Sky)]),
                Svg.Element("rect", [("y", Math.Max(0, eye.Horizon)), ("width", Width), ("height", Height - Math.Max(0, eye.Horizon)), ("fill", Grass)]),
                Stripes(eye, ways[0][0], to),
                picture.Shapes.OrderBy(Order).SelectMany(shape => shape.People is { } people ? People(eye, shape.Name, people) : Shape(eye, shape)),
                ways.SelectMany((way, i) => Ball(eye, way, picture.Shots[i], Palette.Series[i % Palette.Series.Count], total)),
                Svg.Text(Width - 12, Height - 12, picture.Shots[0].Kick, "end", 13, "#ffffff")),
            Dark);
    }

    /// <summary>Lines on the ground below all, nets behind posts.</summary>
    private static int Order(SceneShape shape) => shape.Kind switch
    {
        SceneShapeKind.Marking => 0,
        SceneShapeKind.Net => 1,
        SceneShapeKind.Frame => 2,
        SceneShapeKind.Obstacle => 3,
        SceneShapeKind.Guide => 4,
        _ => throw new ArgumentOutOfRangeException(nameof(shape), shape.Kind, null),
    };

    /// <summary>Stripes of the mower across the way, as on a pitch.</summary>
    private static IEnumerable<XElement> Stripes(Eye eye, Vector3d from, Vector3d to)
    {
        const double wide = 5.5;
        Vector3d along = (to - from).Horizontal.Normalized();
        Vector3d across = 60 * Vector3d.Cross(along, Vector3d.Up);
        Vector3d start = from.Horizontal;
        for (int i = -1; i < 10; i += 2)
        {
            Vector3d near = start + (Math.Max(-5, i * wide) * along);
            Vector3d far = start + ((i + 1) * wide * along);
            if (eye.On(near) is not null)
            {
                yield return Svg.Element("polygon", [("points", Points(eye, [near - across, near + across, far + across, far - across])), ("fill", "#ffffff"), ("fill-opacity", 0.09)]);
            }
        }
    }

    /// <summary>People from far to near, each limb the hull of two discs: a polygon between two circles.</summary>
    private static IEnumerable<XElement> People(Eye eye, string kit, IReadOnlyList<Vector3d[]> people)
    {
        for (int who = 0; who < people.Count; who++)
        {
            if (eye.On(people[who][0].Horizontal) is { } feet)
            {
                yield return Svg.Element("ellipse", [("cx", feet.X), ("cy", feet.Y), ("rx", 0.45 * feet.Metre), ("ry", 0.12 * feet.Metre), ("fill", "#06120a"), ("fill-opacity", 0.3)]);
            }

            foreach (PersonLimbs limb in PersonLimbs.Of(people[who], kit, who).OrderBy(limb => (eye.On(0.5 * (limb.From + limb.To))?.Metre) ?? 0))
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

    private static Vector3d[] Way(Track track, double end)
    {
        var way = new List<Vector3d>();
        int next = 0;
        for (int i = 0; i * Frame <= end; i++)
        {
            double time = Math.Min(i * Frame, track.Keys[^1].Time);
            while (next + 2 < track.Keys.Count && track.Keys[next + 1].Time <= time)
            {
                next++;
            }

            way.Add(track.Keys.Count > 1 ? Track.Between(track.Keys[next], track.Keys[next + 1], time) : track.Keys[0].Position);
        }

        return [.. way];
    }

    private static IEnumerable<XElement> Shape(Eye eye, SceneShape shape)
    {
        foreach (Vector3d[] face in shape.Faces)
        {
            yield return Svg.Element("polygon", [("points", Points(eye, face)), ("fill", "#5f7181"), ("stroke", "#3e4c59"), ("fill-opacity", 0.75)]);
        }

        foreach (Vector3d[] line in shape.Lines)
        {
            double width = eye.On(line[0]) is { } first ? 2 * shape.Radius * first.Metre : 0;
            bool net = shape.Kind == SceneShapeKind.Net;
            yield return Svg.Element(
                "polyline",
                [
                    ("points", Points(eye, line)), ("fill", "none"), ("stroke", "#ffffff"), ("stroke-opacity", net ? 0.45 : 0.9),
                    ("stroke-width", Math.Max(net ? 0.6 : 1.6, width)), ("stroke-linecap", "round"),
                ]);
        }
    }

    private static IEnumerable<XElement> Ball(Eye eye, Vector3d[] way, ReplayShot shot, string colour, double total)
    {
        (double X, double Y, double Metre)[] seen = [.. way.Select(eye.On).OfType<(double X, double Y, double Metre)>()];
        double[] shares = [.. seen.Select((_, i) => i * Frame / total), 1];
        string times = string.Join(';', shares.Select(share => share.ToString("0.####", CultureInfo.InvariantCulture)));
        XElement Moved(string attribute, Func<(double X, double Y, double Metre), double> value) => Svg.Element(
            "animate",
            [
                ("attributeName", attribute), ("dur", FormattableString.Invariant($"{total:0.##}s")), ("repeatCount", "indefinite"), ("keyTimes", times),
                ("values", string.Join(';', seen.Append(seen[^1]).Select(value).Select(Svg.Number))),
            ]);
        double Radius((double X, double Y, double Metre) at) => Math.Max(4, shot.Track.Radius * at.Metre);
        yield return Svg.Element("polyline", [("points", string.Join(' ', seen.Select(at => $"{Svg.Number(at.X)},{Svg.Number(at.Y)}"))), ("fill", "none"), ("stroke", colour), ("stroke-width", 2.2), ("stroke-dasharray", shot.Compares ? "5 4" : "none"), ("stroke-opacity", 0.8)]);
        yield return Svg.Element(
            "circle",
            [("cx", seen[0].X), ("cy", seen[0].Y), ("r", Radius(seen[0])), ("fill", "#fdfdfd"), ("stroke", "#20262c"), ("stroke-width", 1.4)],
            Moved("cx", at => at.X),
            Moved("cy", at => at.Y),
            Moved("r", Radius));
    }

    private static string Points(Eye eye, Vector3d[] places) =>
        string.Join(' ', places.Select(eye.On).OfType<(double X, double Y, double Metre)>().Select(at => $"{Svg.Number(at.X)},{Svg.Number(at.Y)}"));
}
