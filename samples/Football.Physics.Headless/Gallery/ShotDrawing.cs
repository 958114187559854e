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

    private static Chart FromTheSide(GalleryShot shot, Flight flight, Flight? comparison)
    {
        var chart = new Chart(new Axis("along, m"), new Axis("height, m") { Min = 0, Margin = 0.08 })
        {
            Title = "From the side",
            EqualScales = true,
            PlotHeight = 90,
        };
        foreach (Landmark mark in shot.Landmarks.Where(mark => mark.Height > 0))
        {
            chart.Items.Add(new RectangleItem(new Bounds(mark.AlongFrom, mark.AlongTo, 0, mark.Height)) { Colour = Palette.Frame, Caption = mark.Name });
        }

        AddFlight(chart, shot, flight, comparison, place => new PlotPoint(ViewFrame.Along(place), place.Y));
        return chart;
    }

    private static Chart FromAbove(GalleryShot shot, Flight flight, Flight? comparison)
    {
        var chart = new Chart(new Axis("along, m"), new Axis("to the left, m") { Margin = 0.15 })
        {
            Title = "From above",
            EqualScales = true,
            PlotHeight = 110,
            MaximumPlotHeight = 230,
            Background = Palette.Grass,
        };
        double far = flight.Legs.SelectMany(leg => leg.Points).Max(ViewFrame.Along);
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
            double end = far - ViewFrame.Along(flight.Start);
            chart.Items.Add(new PolylineItem([new(0, 0), new(end, end * ViewFrame.Left(direction) / along)])
            {
                Colour = Palette.Faint,
                Width = 0.8,
                Dash = "2 3",
                Label = "launch direction",
            });
        }

        AddFlight(chart, shot, flight, comparison, place => new PlotPoint(ViewFrame.Along(place), ViewFrame.Left(place)));
        return chart;
    }

    private static void AddFlight(Chart chart, GalleryShot shot, Flight flight, Flight? comparison, Func<Vector3d, PlotPoint> project)
    {
        if (comparison is not null)
        {
            chart.Items.Add(new PolylineItem([.. comparison.Legs.SelectMany(leg => leg.Points).Select(project)])
            {
                Colour = Palette.Faint,
                Width = 1.1,
                Dash = "5 3",
                Label = shot.ComparisonName,
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
                Label = motion switch
                {
                    MotionState.Airborne => "flies",
                    MotionState.Sliding => "slides",
                    _ => "rolls",
                },
            });
        }

        AddMarks(chart, flight, project, BallEventKind.Impact, Mark.Ring, Palette.Blue, "touches down");
        AddMarks(chart, flight, project, BallEventKind.Slide, Mark.Triangle, Palette.Orange, "stays down, slides");
        AddMarks(chart, flight, project, BallEventKind.Roll, Mark.Square, Palette.Green, "begins to roll");
        AddMarks(chart, flight, project, BallEventKind.Rest, Mark.Cross, Palette.Red, "rests");
    }

    private static void AddMarks(Chart chart, Flight flight, Func<Vector3d, PlotPoint> project, BallEventKind kind, Mark mark, string colour, string label)
    {
        List<PlotPoint> points = [.. flight.Events.Where(item => item.Kind == kind).Select(item => project(item.Position))];
        if (points.Count > 0)
        {
            chart.Items.Add(new ScatterItem(points) { Mark = mark, Colour = colour, Label = label, Size = mark == Mark.Ring ? 2.6 : 3.2 });
        }
    }
}
