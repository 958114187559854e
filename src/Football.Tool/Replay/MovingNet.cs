using System.Text;
using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Tool.Replay;

/// <summary>Draws a net that yields to the ball, in an SVG.</summary>
internal static class MovingNet
{
    /// <summary>The width of a bulge, in m; the pages use the same.</summary>
    private const double Width = 0.75;

    /// <summary>The minimum time between two shapes of a moving net, in s.</summary>
    private const double Frame = 0.04;

    /// <summary>Draws the net.</summary>
    /// <param name="eye">The camera.</param>
    /// <param name="net">The net.</param>
    /// <param name="moves">The bulges of the net in order of time; empty for a net at rest.</param>
    /// <param name="total">The period of the animation, in s.</param>
    public static IEnumerable<XElement> Draw(Eye eye, SceneShape net, NetMove[] moves, double total)
    {
        Vector3d[][] lines = [.. Lines(net.Corners!)];
        bool Moves(Vector3d[] line) => moves.Any(move => line.Any(node => (Pushed(node, move.Bulge) - node).Length > 0.02));
        Vector3d[][] moving = [.. lines.Where(Moves)];
        yield return Path(Drawn(eye, [.. lines.Except(moving)], null));
        if (moving.Length == 0)
        {
            yield break;
        }

        // The net is at rest before the first bulge. The last shape stays until the animation repeats.
        List<(double Time, NetBulge? Bulge)> frames = [(0, null)];
        foreach (NetMove move in moves.Where(move => move.Time < total))
        {
            if (move.Time - frames[^1].Time >= Frame)
            {
                frames.Add((move.Time, move.Bulge));
            }
        }

        XElement path = Path(Drawn(eye, moving, null));
        path.Add(SvgAnimation.Steps("d", total, frames.Select(frame => frame.Time), frames.Select(frame => Drawn(eye, moving, frame.Bulge))));
        yield return path;
    }

    private static IEnumerable<Vector3d[]> Lines(IReadOnlyList<Vector3d> corners)
    {
        int columns = SceneShapes.Meshes((corners[1] - corners[0]).Length);
        int rows = SceneShapes.Meshes((corners[3] - corners[0]).Length);
        Vector3d Node(int i, int j) => Vector3d.Lerp(
            Vector3d.Lerp(corners[0], corners[1], (double)i / columns), Vector3d.Lerp(corners[3], corners[2], (double)i / columns), (double)j / rows);
        return
        [
            .. Enumerable.Range(0, columns + 1).Select(i => (Vector3d[])[.. Enumerable.Range(0, rows + 1).Select(j => Node(i, j))]),
            .. Enumerable.Range(0, rows + 1).Select(j => (Vector3d[])[.. Enumerable.Range(0, columns + 1).Select(i => Node(i, j))]),
        ];
    }

    private static Vector3d Pushed(Vector3d node, NetBulge bulge)
    {
        Vector3d d = node - (bulge.Position - (bulge.Depth * bulge.Direction));
        double across = Vector3d.Dot(d, bulge.Direction);
        double far = (d.LengthSquared - (across * across)) / (Width * Width);
        return far > 9 ? node : node + (bulge.Depth * Math.Exp(-far) * bulge.Direction);
    }

    /// <summary>Returns the lines as one path. A straight line consists of its two ends.</summary>
    private static string Drawn(Eye eye, Vector3d[][] lines, NetBulge? bulge)
    {
        var path = new StringBuilder();
        foreach (Vector3d[] line in lines)
        {
            Vector3d[] nodes = bulge is { } pushed ? [.. line.Select(node => Pushed(node, pushed))] : [line[0], line[^1]];
            (double X, double Y, double Metre)[] seen = [.. nodes.Select(eye.On).OfType<(double X, double Y, double Metre)>()];
            for (int i = 0; i < seen.Length; i++)
            {
                path.Append(i == 0 ? 'M' : 'L').Append(Tenth(seen[i].X)).Append(',').Append(Tenth(seen[i].Y));
            }
        }

        return path.ToString();
    }

    private static string Tenth(double value) => Svg.Number(Math.Round(value, 1));

    private static XElement Path(string drawn) => Svg.Element("path", [("d", drawn), ("fill", "none"), ("stroke", "#ffffff"), ("stroke-opacity", 0.5), ("stroke-width", 0.7)]);
}
