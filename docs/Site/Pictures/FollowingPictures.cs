using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Live;

namespace FootballPhysics.Site.Pictures;

/// <summary>A ball that is followed live, from the feed of samples/Live.</summary>
internal static class FollowingPictures
{
    private const int Seed = 1;

    /// <summary>The number of pictures after a kick at which the live picture is drawn.</summary>
    private const int PicturesAfter = 7;

    /// <summary>The least upward velocity of the drawn flight, in m/s.</summary>
    private const double Upward = 4;

    /// <summary>The duration of the feed over whose kicks the errors are averaged, and the number of pictures after each kick, in s.</summary>
    private const double Minutes = 4;
    private const int Shown = 20;

    /// <summary>The page of samples/Live a moment after a kick, from the side and from above.</summary>
    public static XElement Live()
    {
        List<Picture> pictures = Pictures(60);
        int at = Moment(pictures);
        var follower = new Follower();
        Frame frame = follower.Follow(pictures[0]);
        for (int i = 1; i <= at; i++)
        {
            frame = follower.Follow(pictures[i]);
        }

        var past = new List<Vector3d>();
        var future = new List<Vector3d>();
        int ahead = (int)Math.Round(Follower.Duration / Feed.Interval);
        for (int i = at - ahead; i <= at + ahead; i++)
        {
            (i <= at ? past : future).Add(pictures[i].Truth.Position);
        }

        var side = new Chart(new Axis("to the right, m"), new Axis("height, m") { Min = 0 }) { Title = "From the side", Width = DocPictures.Width, EqualScales = true, PlotHeight = 90 };
        var above = new Chart(new Axis("to the right, m"), new Axis("away, m")) { Title = "From above", Width = DocPictures.Width, EqualScales = true, PlotHeight = 110, Background = Palette.Grass };
        Add(side, frame, past, future, p => new PlotPoint(p.X, p.Y));
        Add(above, frame, past, future, p => new PlotPoint(p.X, -p.Z));
        Chart.SameScale(side, above);
        double since = pictures[at].Time - pictures[at].Kicked;
        return Svg.Standing(
            FormattableString.Invariant($"A ball {1000 * since:F0} ms after a kick: the estimate with its tube of two standard deviations follows the true path ahead, a constant velocity leaves it"),
            Figure.Stack("", side.Draw(), above.Draw()));
    }

    /// <summary>The error of the velocity after the kicks of the feed, for both filters, and the standard deviation that the filter reports.</summary>
    public static XElement AfterKicks()
    {
        var follower = new Follower();
        var squares = new double[Shown + 1, 3];
        var counts = new int[Shown + 1];
        double kick = double.NegativeInfinity;
        int after = 0;
        foreach (Picture picture in Pictures(60 * Minutes))
        {
            follower.Follow(picture);
            after = picture.Kicked > kick ? 1 : after + 1;
            kick = picture.Kicked;
            if (double.IsFinite(kick) && after <= Shown && Array.TrueForAll(picture.Pixels, pixel => pixel is not null))
            {
                counts[after]++;
                squares[after, 0] += (follower.Filter.Estimate.State.Velocity - picture.Truth.Velocity).LengthSquared;
                squares[after, 1] += (follower.Simple.Velocity - picture.Truth.Velocity).LengthSquared;
                squares[after, 2] += 3 * follower.Filter.Estimate.VelocityDeviation * follower.Filter.Estimate.VelocityDeviation;
            }
        }

        var chart = new Chart(new Axis("pictures after a kick, 50 per second") { Min = 1, Max = Shown }, new Axis("error of the velocity, m/s") { Scale = AxisScale.Logarithmic, Min = 0.2, Max = 30 }) { Title = "How soon the velocity is known", Width = DocPictures.Width, PlotHeight = 220 };
        chart.Items.Add(new PolylineItem(Curve(1)) { Colour = Palette.Orange, Width = 2, Label = "constant velocity" });
        chart.Items.Add(new PolylineItem(Curve(2)) { Colour = Palette.Blue, Width = 1.4, Dash = "5 4", Label = "BallFilter: its reported deviation" });
        chart.Items.Add(new PolylineItem(Curve(0)) { Colour = Palette.Blue, Width = 2, Label = "BallFilter: its error" });
        return Svg.Standing("The error of the velocity after a kick: a constant velocity stays off by 2 m/s, BallFilter is within 1 m/s after five pictures", Figure.Stack("", chart.Draw()));

        PlotPoint[] Curve(int of) => [.. Enumerable.Range(1, Shown).Where(i => counts[i] > 0).Select(i => new PlotPoint(i, Math.Sqrt(squares[i, of] / counts[i])))];
    }

    private static List<Picture> Pictures(double seconds)
    {
        var feed = new Feed(Seed);
        return [.. Enumerable.Range(0, (int)(seconds / Feed.Interval)).Select(_ => feed.Next())];
    }

    /// <summary>The index of a picture a few pictures after a kick into the air, without another kick within the time ahead.</summary>
    private static int Moment(List<Picture> pictures)
    {
        int ahead = (int)Math.Round(Follower.Duration / Feed.Interval);
        return Enumerable.Range(ahead, pictures.Count - (2 * ahead)).First(i =>
            pictures[i].Kicked > pictures[i - PicturesAfter - 1].Time && pictures[i].Kicked <= pictures[i - PicturesAfter].Time
            && pictures[i + ahead].Kicked.Equals(pictures[i].Kicked) && pictures[i].Truth.Velocity.Y > Upward);
    }

    private static void Add(Chart chart, Frame frame, List<Vector3d> past, List<Vector3d> future, Func<Vector3d, PlotPoint> seen)
    {
        PlotPoint[] path = Seen(frame.Path);
        chart.Items.Add(new PolygonItem([Tube(path, frame.Path)]) { Colour = Palette.Object, Label = "two standard deviations" });
        chart.Items.Add(new PolylineItem([.. past.Select(seen)]) { Colour = Palette.Frame, Width = 1.6, Label = "true path so far" });
        chart.Items.Add(new PolylineItem(Seen(frame.Line)) { Colour = Palette.Orange, Width = 2, Label = "constant velocity" });
        chart.Items.Add(new PolylineItem(path) { Colour = Palette.Blue, Width = 2, Label = "BallFilter" });
        chart.Items.Add(new ScatterItem([.. future.Where((_, i) => i % 5 == 4).Select(seen)]) { Colour = Palette.Ink, Mark = Mark.Ring, Size = 2.4, Label = "true ball, each 0.1 s from now on" });

        PlotPoint[] Seen(Ahead[] points) => [.. points.Select(p => seen(new Vector3d(p.X, p.Y, p.Z)))];
    }

    /// <summary>The outline of the tube: two deviations to both sides of the path, and half a circle at its end.</summary>
    private static PlotPoint[] Tube(PlotPoint[] path, Ahead[] points)
    {
        var left = new List<PlotPoint>();
        var right = new List<PlotPoint>();
        double angle = 0;
        for (int i = 0; i < path.Length; i++)
        {
            (PlotPoint from, PlotPoint to) = (path[Math.Max(0, i - 1)], path[Math.Min(path.Length - 1, i + 1)]);
            bool moves = Math.Abs(to.X - from.X) + Math.Abs(to.Y - from.Y) > 1e-9;
            angle = moves ? Math.Atan2(to.Y - from.Y, to.X - from.X) : angle;
            left.Add(Beside(i, 90));
            right.Add(Beside(i, -90));
        }

        IEnumerable<PlotPoint> end = Enumerable.Range(1, 11).Select(k => Beside(path.Length - 1, 90 - (15 * k)));
        return [.. left, .. end, .. Enumerable.Reverse(right)];

        PlotPoint Beside(int i, double degrees)
        {
            (double sin, double cos) = Math.SinCos(angle + (degrees * Math.PI / 180));
            return new PlotPoint(path[i].X + (2 * points[i].Deviation * cos), path[i].Y + (2 * points[i].Deviation * sin));
        }
    }
}
