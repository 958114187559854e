using System.Globalization;
using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Tool.Replay;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>Draws a side view and a top view of a shot at the same scale, and a front view of a goal that the ball reaches.</summary>
internal static class ShotDrawing
{
    /// <summary>The width of a drawing, in pixels: a phone shows it at almost full size.</summary>
    private const double Width = 430;

    public static XElement Draw(GalleryShot shot, Flight flight, Flight? comparison, IReadOnlyList<KeeperPose> keeper)
    {
        SceneShape[] diving = keeper.Count == 0 ? [] : [KeeperPose.At(keeper, flight.FirstMeeting).Shape];
        IReadOnlyList<SceneShape> shapes = [.. shot.Markings, .. SceneShapes.Of(shot.Scenario.Scene), .. diving];
        Chart side = FromTheSide(shot, flight, comparison, shapes);
        Chart above = FromAbove(shot, flight, comparison, shapes);
        Chart.SameScale(side, above);
        List<XElement> views = [side.Draw(), above.Draw()];
        if (GoalDrawing.Draw(shot, flight, shapes, Width) is { } goal)
        {
            views.Add(goal);
        }

        return Svg.Standing(shot.Name, Figure.Stack("", views));
    }

    private static Axis AlongAxis(GalleryShot shot) => new("along, m") { Min = shot.DrawnTo is null ? null : -1, Max = shot.DrawnTo };

    private static Chart FromTheSide(GalleryShot shot, Flight flight, Flight? comparison, IReadOnlyList<SceneShape> shapes)
    {
        Ground ground = shot.Scenario.Scene.Ground;
        var chart = new Chart(AlongAxis(shot), new Axis("height, m") { Min = ground.IsLevel && ground.Height == 0 ? 0 : null, Margin = 0.08 })
        {
            Title = "From the side",
            Width = Width,
            EqualScales = true,
            PlotHeight = 84,
            MaximumPlotHeight = 260,
        };
        PlotPoint Project(Vector3d place) => new(ViewFrame.Along(place), place.Y);
        SceneDrawing.Add(chart, shapes, Project, fromAbove: false, flight.FirstMeeting);
        if (!ground.IsLevel)
        {
            chart.Items.Add(new PolylineItem([.. Under(ground, flight).Select(Project)]) { Colour = Palette.Green, Width = 1.2, Label = "ground" });
        }

        AddFlight(chart, shot, flight, comparison, Project, legend: true);
        return chart;
    }

    private static Chart FromAbove(GalleryShot shot, Flight flight, Flight? comparison, IReadOnlyList<SceneShape> shapes)
    {
        var chart = new Chart(AlongAxis(shot), new Axis("to the left, m") { Margin = 0.15 })
        {
            Title = "From above",
            Width = Width,
            EqualScales = true,
            PlotHeight = 100,
            MaximumPlotHeight = 320,
            Background = Palette.Grass,
        };
        PlotPoint Project(Vector3d place) => new(ViewFrame.Along(place), ViewFrame.Left(place));
        SceneDrawing.Add(chart, shapes, Project, fromAbove: true, flight.FirstMeeting);
        Vector3d direction = flight.Outcome.Samples![0].Velocity;
        double along = ViewFrame.Along(direction);
        if (along > 0 && Flight.FirstTouchdown(flight.Outcome) is { } touchdown)
        {
            double end = ViewFrame.Along(touchdown.Position - flight.Start);
            (double fromAlong, double fromLeft) = (ViewFrame.Along(flight.Start), ViewFrame.Left(flight.Start));
            chart.Items.Add(new PolylineItem([new(fromAlong, fromLeft), new(fromAlong + end, fromLeft + (end * ViewFrame.Left(direction) / along))])
            {
                Colour = Palette.Faint,
                Width = 0.8,
                Dash = "2 3",
                Label = "launch direction",
            });
        }

        Vector3d wind = shot.Scenario.Scene.Air.Wind;
        if (wind.Length > 0)
        {
            chart.Items.Add(new ArrowItem(ViewFrame.Along(wind), ViewFrame.Left(wind), FormattableString.Invariant($"wind {wind.Length:0.#} m/s")) { Colour = Palette.Purple });
        }

        AddFlight(chart, shot, flight, comparison, Project, legend: false);
        return chart;
    }

    private static IEnumerable<Vector3d> Under(Ground ground, Flight flight) => flight.Legs.SelectMany(leg => leg.Points)
        .Select(place => new Vector3d(place.X, SceneShapes.GroundAt(ground, place.X, place.Z), place.Z));

    private static void AddFlight(Chart chart, GalleryShot shot, Flight flight, Flight? comparison, Func<Vector3d, PlotPoint> project, bool legend)
    {
        if (comparison is not null)
        {
            chart.Items.Add(new PolylineItem([.. comparison.ToFirstTouchdown.Select(project)])
            {
                Colour = Palette.Faint,
                Width = 1.1,
                Dash = "5 3",
                Label = legend ? shot.ComparisonName : null,
            });
        }

        foreach ((MotionState motion, IReadOnlyList<Vector3d> points) in flight.Legs)
        {
            (string colour, string does) = motion switch
            {
                MotionState.Airborne => (Palette.Blue, "flies"),
                MotionState.Sliding => (Palette.Orange, "slides"),
                MotionState.Rolling => (Palette.Green, "rolls"),
                MotionState.Rest => (Palette.Green, "rests"),
                MotionState.Pinned => (Palette.Red, "is squeezed"),
                _ => throw new ArgumentOutOfRangeException(nameof(flight), motion, null),
            };
            chart.Items.Add(new PolylineItem([.. points.Select(project)]) { Width = 2, Colour = colour, Label = legend ? does : null });
        }

        (IReadOnlyList<Vector3d[]> bulges, double depth) = DeepestBulges.Of(shot.Scenario);
        if (bulges.Count > 0)
        {
            chart.Items.Add(new LinesItem([.. bulges.Select(line => line.Select(project).ToArray())]) { Colour = Palette.Ink, Width = 0.8, Caption = legend ? FormattableString.Invariant($"net, {depth:0.0} m deep") : "" });
        }

        AddSeconds(chart, flight, project);
        if (shot.Points.Count > 0)
        {
            chart.Items.Add(new ScatterItem([.. shot.Points.Select(project)])
            {
                Mark = Mark.Diamond,
                Colour = Palette.Purple,
                Label = legend ? "aimed at" : null,
                Size = 3.4,
            });
        }

        AddMarks(chart, flight, project, BallEventKind.Impact, Mark.Ring, Palette.Blue, legend ? "impact" : null);
        AddMarks(chart, flight, project, BallEventKind.Net, Mark.Ring, Palette.Frame, legend ? "net" : null);
        AddMarks(chart, flight, project, BallEventKind.Goal, Mark.Diamond, Palette.Red, legend ? "goal" : null);
        AddMarks(chart, flight, project, BallEventKind.ContactEnd, Mark.Triangle, Palette.Blue, legend ? "leaves the ground" : null);
        AddMarks(chart, flight, project, BallEventKind.Slide, Mark.Triangle, Palette.Orange, legend ? "slide begins" : null);
        AddMarks(chart, flight, project, BallEventKind.Roll, Mark.Square, Palette.Green, legend ? "roll begins" : null);
        AddMarks(chart, flight, project, BallEventKind.Rest, Mark.Cross, Palette.Red, legend ? "rest" : null);
    }

    /// <summary>Adds dots at whole seconds, while the ball moves far enough in a second to separate them.</summary>
    private static void AddSeconds(Chart chart, Flight flight, Func<Vector3d, PlotPoint> project)
    {
        IReadOnlyList<Moment> samples = flight.Outcome.Samples!;
        double far = 0.09 * samples.Max(sample => (sample.Position - flight.Start).Length);
        var places = new List<PlotPoint>();
        var names = new List<string>();
        Vector3d last = flight.Start;
        for (int second = 1; second < samples[^1].Time; second++)
        {
            Moment at = samples.MinBy(sample => Math.Abs(sample.Time - second));
            if ((at.Position - last).Length >= far)
            {
                places.Add(project(at.Position));
                names.Add(string.Create(CultureInfo.InvariantCulture, $"{second} s"));
                last = at.Position;
            }
        }

        chart.Items.Add(new ScatterItem(places) { Captions = names, Mark = Mark.Dot, Colour = Palette.Ink, Size = 1.8 });
    }

    private static void AddMarks(Chart chart, Flight flight, Func<Vector3d, PlotPoint> project, BallEventKind kind, Mark mark, string colour, string? label)
    {
        List<PlotPoint> points = [.. flight.Events.Where(item => item.Kind == kind).Select(item => project(item.Position))];
        if (points.Count > 0)
        {
            chart.Items.Add(new ScatterItem(points) { Mark = mark, Colour = colour, Label = label, Size = mark == Mark.Ring ? 2.6 : 3.2 });
        }
    }
}
