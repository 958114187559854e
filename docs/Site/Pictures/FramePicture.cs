using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Site.Pictures;

/// <summary>The frame of the library on a pitch: x, y, −z, and which way angles and spins count.</summary>
internal static class FramePicture
{
    private const double Height = 300;
    private const string Right = "#c8382b";
    private const string Up = "#00875f";
    private const string Forward = "#0061a8";
    private const string Spin = "#7a3f8c";

    public static XElement Draw()
    {
        var scene = new Scene { Goals = [new Goal { Center = new Vector3d(0, 0, -16), Facing = new Vector3d(0, 0, 1) }] };
        IReadOnlyList<SceneShape> shapes = SceneShapes.Of(scene);
        var start = new Vector3d(0, 0.11, 0);
        var eye = new Eye(new Vector3d(3.2, 0, 1), new Vector3d(-2.2, 0, -13), [new(-4.2, 0, -1), new(4.4, 0, 0), new(3.4, 3.2, -16), new(0, 0, 2.4)], DocPictures.Width, Height, 12, above: 4.6);
        Vector3d[] kick = [.. Flown(start, 19, sideSpin: 0)];
        Vector3d[] bent = [.. Flown(start, 19, sideSpin: 90)];
        return Svg.Standing(
            "The frame: x to the right, y up, minus z forwards; azimuth and sidespin count to the left",
            Svg.Root(
                DocPictures.Width,
                Height,
                SceneSketch.Backdrop(eye, start, new Vector3d(0, 0, -16)),
                SceneSketch.Lying(eye, shapes, _ => null),
                SceneSketch.Standing(eye, shapes, (_, net) => MovingNet.Draw(eye, net, [], 1), _ => null).SelectMany(item => item.Drawn),
                SceneSketch.Line(eye, kick, "#ffffff", 0.8, 1.6),
                SceneSketch.Line(eye, bent, Spin, 1, 2.4),
                Label(eye, bent[bent.Length / 2], "sideSpin > 0: to the left", Spin, "end", -6, -10),
                Label(eye, kick[kick.Length * 3 / 4], "without spin", "#2b3640", "start", 8, 12),
                Arrow(eye, start, new Vector3d(4.2, 0.11, 0), Right),
                Label(eye, new Vector3d(4.2, 0.11, 0), "x: right", Right, "end", -14, -14),
                Arrow(eye, start, new Vector3d(0, 2.9, 0), Up),
                Label(eye, new Vector3d(0, 2.9, 0), "y: up", Up, "start", 8, 6),
                Arrow(eye, start, new Vector3d(0, 0.11, -9), Forward),
                Label(eye, new Vector3d(0, 0.11, -9), "−z: forwards", Forward, "start", 10, 4),
                SceneSketch.Line(eye, [.. Arc(3.2, 0, 30)], "#20262c", 1, 1.6),
                SceneSketch.Line(eye, [start, start + (3.6 * new Vector3d(-0.5, 0, -0.866))], "#20262c", 0.8, 1),
                Label(eye, Arc(3.2, 30, 30).First(), "azimuth > 0", "#20262c", "end", -4, -4),
                Ball(eye, start),
                Text(10, Height - 25, "topSpin > 0: dips; topSpin < 0 (backspin): holds up", "start"),
                Text(10, Height - 9, "metres, seconds, m/s, rad/s (1 rad/s = 9.55 rpm)", "start")),
            SceneSketch.Dark);
    }

    private static IEnumerable<Vector3d> Flown(Vector3d start, double speed, double sideSpin)
    {
        var simulator = new Simulator();
        BallState ball = simulator.Launch(start, new Vector3d(0, 0.27 * speed, -speed), new Vector3d(0, sideSpin, 0));
        var log = new StepLog();
        yield return ball.Position;
        while (log.Events.Count == 0)
        {
            simulator.Step(ref ball, 0.03, log);
            yield return ball.Position;
        }
    }

    /// <summary>On the grass around the ball, by degrees to the left.</summary>
    private static IEnumerable<Vector3d> Arc(double radius, double from, double to) => Enumerable.Range(0, 13)
        .Select(i => Math.SinCos((from + (i * (to - from) / 12)) * Math.PI / 180)).Select(at => new Vector3d(-radius * at.Sin, 0.01, -radius * at.Cos));

    private static IEnumerable<XElement> Arrow(Eye eye, Vector3d from, Vector3d to, string colour)
    {
        yield return SceneSketch.Line(eye, [from, to], colour, 1, 3);
        (double X, double Y, double Metre) a = eye.On(from)!.Value;
        (double X, double Y, double Metre) b = eye.On(to)!.Value;
        double length = Math.Sqrt(((b.X - a.X) * (b.X - a.X)) + ((b.Y - a.Y) * (b.Y - a.Y)));
        (double dx, double dy) = ((b.X - a.X) / length, (b.Y - a.Y) / length);
        string At(double along, double aside) => $"{Svg.Number(b.X + (along * dx) - (aside * dy))},{Svg.Number(b.Y + (along * dy) + (aside * dx))}";
        yield return Svg.Element("polygon", [("points", $"{At(9, 0)} {At(-3, 5)} {At(-3, -5)}"), ("fill", colour)]);
    }

    private static XElement Label(Eye eye, Vector3d place, string text, string colour, string anchor, double right, double down)
    {
        (double X, double Y, double Metre) at = eye.On(place)!.Value;
        return Text(at.X + right, at.Y + down, text, anchor, colour);
    }

    private static XElement Text(double x, double y, string text, string anchor, string colour = "#16202a")
    {
        XElement written = Svg.Text(x, y, text, anchor, 13, colour, bold: true);
        written.Add(new XAttribute("stroke", "#f4f8f2"), new XAttribute("stroke-width", 3), new XAttribute("stroke-linejoin", "round"), new XAttribute("paint-order", "stroke"));
        return written;
    }

    private static XElement Ball(Eye eye, Vector3d place)
    {
        (double X, double Y, double Metre) at = eye.On(place)!.Value;
        return Svg.Element("circle", [("cx", at.X), ("cy", at.Y), ("r", 7.0), ("fill", "#fdfdfd"), ("stroke", "#20262c"), ("stroke-width", 1.4)]);
    }
}
