using System.Xml.Linq;
using FootballPhysics.Drawing;

namespace FootballPhysics.Tool.Replay;

/// <summary>Draws shots as an animated SVG that repeats, seen from behind the ball. It is for pages that run no script.</summary>
internal static class MovingDrawing
{
    private const double Width = 720;
    private const double Height = 380;
    private const double Margin = 36;

    /// <summary>The pause before the animation repeats, in s.</summary>
    private const double Pause = 1.2;

    /// <summary>The maximum duration that is shown, in s; a longer roll is cut.</summary>
    private const double Longest = 4;

    /// <summary>The sideways distance of the camera if there is no goal, as a share of the path's length.</summary>
    private const double Aside = 0.3;

    /// <summary>The time between two poses of a goalkeeper, s.</summary>
    private const double PoseStep = 0.06;

    /// <summary>Draws the animation.</summary>
    public static XElement Draw(ReplayPicture picture)
    {
        double end = Math.Min(Longest, picture.Shots.Max(shot => shot.Track.Keys[^1].Time));
        double total = end + Pause;
        Vector3d[] start = [.. SketchedBall.Way(picture.Shots[0].Track, end)];
        SceneShape[] standing = [.. picture.Shapes.Where(shape => shape.Kind is not (SceneShapeKind.Marking or SceneShapeKind.Guide))];
        Vector3d[] frame = [.. standing.Where(shape => shape.Kind == SceneShapeKind.Frame).SelectMany(shape => shape.Points)];
        Vector3d to = frame.Length > 0 ? frame.Aggregate((a, b) => a + b) / frame.Length : start[^1];
        // Paths for comparison may leave the image.
        Vector3d[][] keeper = [.. picture.Keeper.Where(pose => pose.Time <= end).Select(pose => pose.Skeleton)];
        Vector3d[] matter = [.. keeper.SelectMany(skeleton => skeleton.Take(3)), .. picture.Shots.Where(shot => !shot.Compares).SelectMany(shot => SketchedBall.Way(shot.Track, end)), .. standing.SelectMany(shape => shape.Points)];
        // Without a goal, a straight path looks like a line from behind. Move the camera to the side, so that the height is visible.
        double aside = frame.Length > 0 ? 0 : Aside * (to - start[0]).Horizontal.Length;
        var eye = new Eye(start[0], to.Horizontal, matter, Width, Height, Margin, aside: aside);
        SketchedBall[] balls = [.. picture.Shots.Select((shot, i) => new SketchedBall(eye, shot, $"{picture.Id}-{i}", end, total))];
        string Colour(int i) => Palette.Series[i % Palette.Series.Count];

        // Draw each ball after the farther objects and before the nearer ones.
        var layers = new List<XElement>();
        double depth = 0;
        IEnumerable<(double Metre, XElement[] Drawn)> things = SceneSketch.Standing(eye, picture.Shapes, Net, Motion);
        if (keeper.Length > 0 && eye.On(keeper[0][0] + (0.9 * Vector3d.Up)) is { } at)
        {
            things = things.Append((at.Metre, [.. Keeper(eye, picture.Keeper, end, total)])).OrderBy(thing => thing.Metre);
        }

        foreach ((double metre, XElement[] drawn) in things)
        {
            layers.AddRange(balls.SelectMany((ball, i) => ball.Between(depth, metre, Colour(i))));
            layers.AddRange(drawn);
            depth = metre;
        }

        layers.AddRange(balls.SelectMany((ball, i) => ball.Between(depth, double.PositiveInfinity, Colour(i))));
        return Svg.Standing(
            picture.Name,
            Svg.Root(
                Width,
                Height,
                Svg.Element("defs", [], balls.Select(ball => ball.Definition())),
                SceneSketch.Backdrop(eye, start[0], to),
                SceneSketch.Lying(eye, picture.Shapes, Motion),
                picture.Ground is { } ground ? balls.Select(ball => ball.Shadow(ground.HeightAt)) : null,
                layers,
                Svg.Text(Width - 12, Height - 12, picture.Shots[0].Kick, "end", 13, "#ffffff")),
            SceneSketch.Dark);

        // A moving person moves until he meets the ball.
        XElement? Motion(SceneShape shape)
        {
            if (shape.Velocity.Length == 0 || eye.On(shape.Points.First()) is not { } first)
            {
                return null;
            }

            double until = picture.Shots.SelectMany(shot => shot.Track.Events.Where(item => item.Kind == BallEventKind.Impact && shot.Track.SurfaceOf(item) == shape.Name)).Select(item => item.Time).DefaultIfEmpty(end).Min();
            double[] times = [.. Enumerable.Range(0, 11).Select(i => 0.1 * i * until)];
            IEnumerable<string> values = times.Append(until).Select(time => eye.On(shape.Points.First() + (time * shape.Velocity)) ?? first).Select(at => $"{Svg.Number(at.X - first.X)} {Svg.Number(at.Y - first.Y)}");
            return SvgAnimation.Transform("translate", total, SvgAnimation.Times(times.Select(time => time / total).Append(1)), string.Join(';', values));
        }

        IEnumerable<XElement> Net(int net, SceneShape shape) =>
            MovingNet.Draw(eye, shape, [.. picture.Shots.Where(shot => !shot.Compares).SelectMany(shot => shot.Nets).Where(move => move.Net == net && move.Time <= end)], total);
    }

    /// <summary>Draws the poses of a goalkeeper; each is visible until the next.</summary>
    private static IEnumerable<XElement> Keeper(Eye eye, IReadOnlyList<KeeperPose> poses, double end, double total)
    {
        var shown = new List<KeeperPose>();
        foreach (KeeperPose pose in poses.Where(pose => pose.Time <= end))
        {
            if (shown.Count == 0 || pose.Time - shown[^1].Time > PoseStep - 1e-9)
            {
                shown.Add(pose);
            }
        }

        for (int i = 0; i < shown.Count; i++)
        {
            Vector3d[] skeleton = shown[i].Skeleton;
            Vector3d middle = shown[i].Body.Position.Horizontal;
            bool first = i == 0;
            double[] times = [.. ((double[])[0, shown[i].Time, i + 1 < shown.Count ? shown[i + 1].Time : total]).Skip(first ? 1 : 0).Where(time => time < total)];
            string[] values = [.. ((string[])["hidden", "visible", "hidden"]).Skip(first ? 1 : 0).Take(times.Length)];
            yield return Svg.Element(
                "g",
                [("visibility", first ? "visible" : "hidden")],
                times.Length < 2 ? null : SvgAnimation.Steps("visibility", total, times, values),
                eye.On(middle) is { } at ? Svg.Element("ellipse", [("cx", at.X), ("cy", at.Y), ("rx", 0.5 * at.Metre), ("ry", 0.12 * at.Metre), ("fill", "#06120a"), ("fill-opacity", 0.3)]) : null,
                SceneSketch.Person(eye, "keeper", skeleton, 0));
        }
    }
}
