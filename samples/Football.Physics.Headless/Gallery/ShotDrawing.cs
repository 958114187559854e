using System.Xml.Linq;
using Football.Physics.Headless.Drawing;

namespace Football.Physics.Headless.Gallery;

/// <summary>Draws a shot from the side and from above.</summary>
internal static class ShotDrawing
{
    /// <summary>The colour of lines on the grass.</summary>
    private const string Marking = "#b5cbaa";

    public static XElement Draw(GalleryShot shot, Flight flight, Flight? comparison) => Figure.Stack(
        shot.Name,
        FromTheSide(shot, flight, comparison).Draw(),
        FromAbove(shot, flight, comparison).Draw());

    private static Axis AlongAxis(GalleryShot shot) => new("along, m") { Min = shot.DrawnTo is null ? null : -1, Max = shot.DrawnTo };

    private static Chart FromTheSide(GalleryShot shot, Flight flight, Flight? comparison)
    {
        var chart = new Chart(AlongAxis(shot), new Axis("height, m") { Min = 0, Margin = 0.08 })
        {
            Title = "From the side",
            EqualScales = true,
            PlotHeight = 90,
        };
        foreach (Landmark mark in shot.Landmarks.Where(mark => mark.Height > 0))
        {
            chart.Items.Add(new RectangleItem(new Bounds(mark.AlongFrom, mark.AlongTo, 0, mark.Height)) { Colour = Palette.Frame, Caption = mark.Name });
        }

        AddFlight(chart, shot, flight, comparison, place => new PlotPoint(ViewFrame.Along(place), place.Y), legend: true);
        return chart;
    }

    private static Chart FromAbove(GalleryShot shot, Flight flight, Flight? comparison)
    {
        var chart = new Chart(AlongAxis(shot), new Axis("to the left, m") { Margin = 0.15 })
        {
            Title = "From above",
            EqualScales = true,
            PlotHeight = 110,
            MaximumPlotHeight = 280,
            Background = Palette.Grass,
        };
        foreach (Landmark mark in shot.Landmarks)
        {
            bool flat = mark.Height == 0;
            chart.Items.Add(new RectangleItem(new Bounds(mark.AlongFrom, mark.AlongTo, mark.LeftFrom, mark.LeftTo))
            {
                Colour = flat ? Marking : Palette.Frame,
                Fill = flat ? "none" : Palette.Object,
                Caption = mark.Name,
                NeedsRoom = !flat,
            });
        }

        Vector3d direction = flight.Outcome.Samples![0].Velocity;
        double along = ViewFrame.Along(direction);
        if (along > 0 && flight.Outcome.Bounces > 0)
        {
            double end = ViewFrame.Along(flight.Events[0].Position);
            chart.Items.Add(new PolylineItem([new(0, 0), new(end, end * ViewFrame.Left(direction) / along)])
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

        AddFlight(chart, shot, flight, comparison, place => new PlotPoint(ViewFrame.Along(place), ViewFrame.Left(place)), legend: false);
        return chart;
    }

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
            chart.Items.Add(new PolylineItem([.. points.Select(project)])
            {
                Width = 2,
                Colour = motion switch
                {
                    MotionState.Airborne => Palette.Blue,
                    MotionState.Sliding => Palette.Orange,
                    _ => Palette.Green,
                },
                Label = !legend ? null : motion switch
                {
                    MotionState.Airborne => "flies",
                    MotionState.Sliding => "slides",
                    _ => "rolls",
                },
            });
        }

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

        AddMarks(chart, flight, project, BallEventKind.Impact, Mark.Ring, Palette.Blue, legend ? "touchdown" : null);
        AddMarks(chart, flight, project, BallEventKind.Slide, Mark.Triangle, Palette.Orange, legend ? "slide begins" : null);
        AddMarks(chart, flight, project, BallEventKind.Roll, Mark.Square, Palette.Green, legend ? "roll begins" : null);
        AddMarks(chart, flight, project, BallEventKind.Rest, Mark.Cross, Palette.Red, legend ? "rest" : null);
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
