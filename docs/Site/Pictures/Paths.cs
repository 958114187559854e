using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Prediction;

namespace FootballPhysics.Site.Pictures;

/// <summary>Paths as the pictures of the guides draw them: from the side, from above, with a mark at each event.</summary>
internal static class Paths
{
    private const double Interval = 0.02;

    /// <summary>Where a kick begins: the centre of a ball on the ground.</summary>
    public static Vector3d Start { get; } = new(0, 0.11, 0);

    public static Chart Side(string title, double height = 90) => new(new Axis("along, m"), new Axis("height, m") { Min = 0 })
    {
        Title = title,
        Width = DocPictures.Width,
        EqualScales = true,
        PlotHeight = height,
    };

    public static Chart Above(string title, double height = 110, string along = "along, m", string across = "to the left, m") => new(new Axis(along), new Axis(across))
    {
        Title = title,
        Width = DocPictures.Width,
        EqualScales = true,
        PlotHeight = height,
        Background = Palette.Grass,
    };

    /// <summary>A chart of a value over another, whose scales have nothing in common.</summary>
    public static Chart Plot(string title, Axis across, Axis up, double height = 180) => new(across, up) { Title = title, Width = DocPictures.Width, PlotHeight = height };

    public static PlotPoint FromSide(Vector3d at) => new(-at.Z, at.Y);

    public static PlotPoint FromAbove(Vector3d at) => new(-at.Z, -at.X);

    /// <summary>The path of a ball that has just been kicked.</summary>
    public static Trajectory Of(Ball ball, double duration = 20, StopAt stop = StopAt.Rest)
    {
        var path = new Trajectory();
        ball.LookAhead(new LookAheadRequest { Duration = duration, StopAt = stop }, path);
        return path;
    }

    /// <summary>The path of a launch in a scene.</summary>
    public static Trajectory Of(Scene scene, Vector3d velocity, Vector3d spin, double duration = 20, StopAt stop = StopAt.Rest)
    {
        var ball = new Ball(scene);
        ball.Launch(Start, velocity, spin);
        return Of(ball, duration, stop);
    }

    /// <summary>The points of a path between two times, the second excluded if it is not the end.</summary>
    public static PlotPoint[] Points(Trajectory path, Func<Vector3d, PlotPoint> view, double from = 0, double to = double.PositiveInfinity)
    {
        double end = Math.Min(to, path.EndTime);
        return [.. Enumerable.Range(0, (int)((end - from) / Interval) + 1).Select(i => view(path.PositionAt(from + (i * Interval)))), view(path.PositionAt(end))];
    }

    /// <summary>The positions of the events of one kind on a path.</summary>
    public static PlotPoint[] Events(Trajectory path, Func<Vector3d, PlotPoint> view, BallEventKind kind)
    {
        var points = new List<PlotPoint>();
        foreach (BallEvent happened in path.Events)
        {
            if (happened.Kind == kind)
            {
                points.Add(view(happened.Position));
            }
        }

        return [.. points];
    }

    /// <summary>The time of the first event of a kind.</summary>
    public static double TimeOf(Trajectory path, BallEventKind kind)
    {
        foreach (BallEvent happened in path.Events)
        {
            if (happened.Kind == kind)
            {
                return happened.Time;
            }
        }

        throw new InvalidOperationException($"The path has no event {kind}.");
    }

    public static ScatterItem Marked(PlotPoint at, string caption, string colour = Palette.Ink, Mark mark = Mark.Dot) =>
        new([at]) { Colour = colour, Mark = mark, Size = 3.5, Captions = [caption] };

    public static XElement Picture(string words, params IReadOnlyList<Chart> charts) => Svg.Standing(words, Figure.Stack("", [.. charts.Select(chart => chart.Draw())]));
}
