using System.Text;
using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Tool.Replay;

/// <summary>Draws a moving ball in an SVG. Its panels turn with the spin, its shadow shows its height, and nearer objects hide it.</summary>
internal sealed class SketchedBall
{
    /// <summary>The time between two positions of the ball, in s.</summary>
    public const double Frame = 0.02;

    /// <summary>The number of frames between two turns of the panels.</summary>
    private const int Turned = 2;

    /// <summary>The minimum radius of a drawn ball, in pixels.</summary>
    private const double Least = 4.5;

    private static readonly (Vector3d Middle, Vector3d[] Corners)[] s_panels = Panels();

    private readonly Eye _eye;
    private readonly string _id;
    private readonly ReplayShot _shot;
    private readonly double _total;
    private readonly (double X, double Y, double Metre)[] _seen;
    private readonly bool[] _isSeen;
    private readonly Vector3d[] _way;
    private readonly Quaterniond[] _turns;
    private readonly string _times;

    /// <summary>Prepares the drawing of a ball.</summary>
    /// <param name="eye">The camera.</param>
    /// <param name="shot">The shot.</param>
    /// <param name="id">An identifier that is unique in the drawing.</param>
    /// <param name="end">The end of the path to show, in s.</param>
    /// <param name="total">The period of the animation, in s.</param>
    public SketchedBall(Eye eye, ReplayShot shot, string id, double end, double total)
    {
        (_eye, _shot, _id, _total) = (eye, shot, id, total);
        (Vector3d Place, Quaterniond Turn)[] frames = [.. Frames(shot.Track, end)];
        _way = [.. frames.Select(frame => frame.Place)];
        _turns = [.. frames.Select(frame => frame.Turn)];

        // Behind the camera, the ball is invisible. It waits at its last visible position or, if there is none yet, at the first one.
        (double X, double Y, double Metre)?[] seen = [.. _way.Select(eye.On)];
        (double X, double Y, double Metre) last = seen.FirstOrDefault(at => at is not null) ?? default;
        _isSeen = [.. seen.Select(at => at is not null)];
        _seen = [.. seen.Select(at => last = at ?? last)];
        _times = SvgAnimation.Times(_seen.Select((_, i) => i * Frame / total).Append(1));
    }

    /// <summary>Returns the positions of the ball, frame by frame.</summary>
    public static IEnumerable<Vector3d> Way(Track track, double end) => Frames(track, end).Select(frame => frame.Place);

    /// <summary>Returns the definition of the moving ball, to which other elements refer; null if the ball is never visible.</summary>
    public XElement? Definition()
    {
        if (!_isSeen.Contains(true))
        {
            return null;
        }

        string r = Values(_seen.Select(at => Radius(at)));
        int[] turned = [.. Enumerable.Range(0, (_seen.Length + Turned - 1) / Turned)];
        return Svg.Element(
            "g",
            [("id", _id)],
            Transform("translate", Values(_seen.Select(at => $"{Svg.Number(at.X)} {Svg.Number(at.Y)}"))),
            Svg.Element(
                "g",
                [],
                Transform("scale", r),
                Svg.Element("circle", [("r", 1.0), ("fill", "#fdfdfd"), ("stroke", "#20262c"), ("stroke-width", 0.16)]),
                Svg.Element(
                    "path",
                    [("d", Drawn(_turns[0])), ("fill", "#20262c")],
                    SvgAnimation.Steps("d", _total, turned.Select(i => i * Turned * Frame), turned.Select(i => Drawn(_turns[i * Turned]))))));
    }

    /// <summary>Draws the shadow below the ball: the higher the ball, the wider and fainter the shadow. Returns null if the ball is never visible.</summary>
    public XElement? Shadow(Func<Vector3d, double> groundAt)
    {
        if (!_isSeen.Contains(true))
        {
            return null;
        }

        (double X, double Y, double Metre)[] below = [.. _way.Select((place, i) => (_isSeen[i] ? _eye.On(new Vector3d(place.X, groundAt(place), place.Z)) : null) ?? _seen[i])];
        double[] heights = [.. _way.Select(place => Math.Max(0, place.Y - groundAt(place) - _shot.Track.Radius))];
        return Svg.Element(
            "g",
            [],
            Transform("translate", Values(below.Select(at => $"{Svg.Number(at.X)} {Svg.Number(at.Y)}"))),
            Svg.Element(
                "ellipse",
                [("rx", 1.0), ("ry", 0.3), ("fill", "#06120a"), ("fill-opacity", 0.5)],
                Transform("scale", Values(below.Select((at, i) => Radius(at) * (1.2 + (0.2 * heights[i]))))),
                SvgAnimation.Change("fill-opacity", _total, _times, Values(heights.Select((height, i) => _isSeen[i] ? 0.55 / (1 + (0.3 * height)) : 0)))));
    }

    /// <summary>Draws the path and the ball where they are between two depths.</summary>
    /// <param name="from">The size of a metre at the farther depth; included.</param>
    /// <param name="to">The size of a metre at the nearer depth; excluded.</param>
    /// <param name="colour">The colour of the path.</param>
    public IEnumerable<XElement> Between(double from, double to, string colour)
    {
        bool[] here = [.. _seen.Select((at, i) => _isSeen[i] && at.Metre >= from && at.Metre < to)];
        if (!here.Contains(true))
        {
            yield break;
        }

        for (int i = 0; i < here.Length; i++)
        {
            int first = i;
            for (; i < here.Length && here[i]; i++)
            {
            }

            if (i > first)
            {
                yield return Svg.Element(
                    "polyline",
                    [
                        ("points", string.Join(' ', _seen[Math.Max(0, first - 1)..Math.Min(_seen.Length, i)].Select(at => $"{Svg.Number(at.X)},{Svg.Number(at.Y)}"))), ("fill", "none"), ("stroke", colour),
                        ("stroke-width", 2.2), ("stroke-dasharray", _shot.Compares ? "5 4" : "none"), ("stroke-opacity", 0.8), ("stroke-linejoin", "round"),
                    ]);
            }
        }

        int[] changes = [.. Enumerable.Range(0, here.Length).Where(i => i == 0 || here[i] != here[i - 1])];
        yield return Svg.Element(
            "use",
            [("href", "#" + _id), ("visibility", here[0] ? "visible" : "hidden")],
            changes.Length == 1
                ? null
                : SvgAnimation.Steps("visibility", _total, changes.Select(i => i * Frame), changes.Select(i => here[i] ? "visible" : "hidden")));
    }

    private static IEnumerable<(Vector3d Place, Quaterniond Turn)> Frames(Track track, double end)
    {
        int next = 0;
        for (int i = 0; i * Frame <= end; i++)
        {
            double time = Math.Min(i * Frame, track.Keys[^1].Time);
            while (next + 2 < track.Keys.Count && track.Keys[next + 1].Time <= time)
            {
                next++;
            }

            TrackKey key = track.Keys[next];
            yield return track.Keys.Count > 1 ? (Track.Between(in key, track.Keys[next + 1], time), Track.Turned(in key, time)) : (key.Position, key.Orientation);
        }
    }

    /// <summary>Returns the twelve pentagons around the corners of an icosahedron.</summary>
    private static (Vector3d Middle, Vector3d[] Corners)[] Panels()
    {
        Vector3d[] corners = Gltf.Mesh.Icosahedron;
        return [.. corners.Select(corner =>
        {
            Vector3d[] near = [.. corners.Where(other => Math.Abs((other - corner).Length - 2) < 1e-6)];
            Vector3d axis = corner.Normalized();
            Vector3d u = Vector3d.Cross(axis, near[0]).Normalized();
            Vector3d v = Vector3d.Cross(axis, u);
            return (axis, (Vector3d[])[.. near.OrderBy(other => Math.Atan2(Vector3d.Dot(other, v), Vector3d.Dot(other, u))).Select(other => ((2 * corner) + other).Normalized())]);
        })];
    }

    /// <summary>Returns the visible panels of a ball of radius 1.</summary>
    private string Drawn(Quaterniond turn)
    {
        var path = new StringBuilder();
        foreach ((Vector3d middle, Vector3d[] corners) in s_panels)
        {
            if (_eye.Towards(turn.Rotate(middle)).Near < -0.2)
            {
                continue;
            }

            for (int i = 0; i < corners.Length; i++)
            {
                (double right, double up, double near) = _eye.Towards(turn.Rotate(corners[i]));
                // Points on the far side are drawn at the rim.
                double s = near < 0 ? 1 / Math.Max(1e-9, Math.Sqrt((right * right) + (up * up))) : 1;
                path.Append(i == 0 ? 'M' : 'L').Append(Svg.Number(s * right)).Append(',').Append(Svg.Number(-s * up));
            }

            path.Append('Z');
        }

        return path.ToString();
    }

    private double Radius((double X, double Y, double Metre) at) => Math.Max(Least, _shot.Track.Radius * at.Metre);

    private XElement Transform(string type, string values) => SvgAnimation.Transform(type, _total, _times, values);

    private static string Values(IEnumerable<double> values) => Values(values.Select(Svg.Number));

    /// <summary>Returns the values of an animation. The last value stays until the animation repeats.</summary>
    private static string Values(IEnumerable<string> values)
    {
        string[] all = [.. values];
        return string.Join(';', all.Append(all[^1]));
    }
}
