using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Prediction;

namespace FootballPhysics.Site.Pictures;

/// <summary>What spin and air do to a ball, and what a bounce tells.</summary>
internal static class FlightPictures
{
    private static readonly Vector3d s_start = new(0, 0.11, 0);

    /// <summary>The same kick with topspin, backspin and none from the side, with sidespin from above.</summary>
    public static XElement Spin()
    {
        var side = new Chart(new Axis("along, m"), new Axis("height, m") { Min = 0 }) { Title = "From the side", Width = DocPictures.Width, EqualScales = true, PlotHeight = 90 };
        foreach ((double spin, string name, string colour) in new[] { (-50.0, "backspin (topSpin: -50)", Palette.Green), (0.0, "none", Palette.Frame), (50.0, "topspin (topSpin: 50)", Palette.Red) })
        {
            side.Items.Add(new PolylineItem([.. Way(topSpin: spin, sideSpin: 0).Select(at => new PlotPoint(-at.Z, at.Y))]) { Colour = colour, Width = 2, Label = name });
        }

        var above = new Chart(new Axis("along, m"), new Axis("to the left, m")) { Title = "From above", Width = DocPictures.Width, EqualScales = true, PlotHeight = 110, Background = Palette.Grass };
        foreach ((double spin, string name, string colour) in new[] { (50.0, "sideSpin: 50", Palette.Blue), (0.0, "none", Palette.Frame), (-50.0, "sideSpin: -50", Palette.Orange) })
        {
            above.Items.Add(new PolylineItem([.. Way(topSpin: 0, sideSpin: spin).Select(at => new PlotPoint(-at.Z, -at.X))]) { Colour = colour, Width = 2, Label = name });
        }

        Chart.SameScale(side, above);
        return Svg.Standing("The same kick, 25 m/s at 14 degrees, with top-, back- and sidespin of 50 rad/s", Figure.Stack("", side.Draw(), above.Draw()));
    }

    /// <summary>Drag and lift by speed, in the weights of the ball.</summary>
    public static XElement Air()
    {
        var drag = new Chart(new Axis("speed, m/s") { Min = 0, Max = 36 }, new Axis("drag, weights of the ball") { Min = 0, Max = 1.7 }) { Title = "Drag without spin", Width = DocPictures.Width, PlotHeight = 190 };
        var lift = new Chart(new Axis("speed, m/s") { Min = 0, Max = 36 }, new Axis("side force, weights") { Min = 0, Max = 1.2 }) { Title = "Side force with a sidespin of 50 rad/s", Width = DocPictures.Width, PlotHeight = 190 };
        foreach ((Scene scene, string name, string colour) in new[]
        {
            (Scene.Measured, "Football", Palette.Blue), (Scene.Measured with { Ball = BallProperties.Jabulani }, "Jabulani", Palette.Orange),
            (Scene.Measured with { Ball = BallProperties.Brazuca }, "Brazuca", Palette.Green), (Scene.Published, "published laws", Palette.Frame),
        })
        {
            double[] speeds = [.. Enumerable.Range(1, 140).Select(i => 0.25 * i)];
            drag.Items.Add(new PolylineItem([.. speeds.Select(speed => new PlotPoint(speed, Force(scene, speed, 0).Z))]) { Colour = colour, Width = 2, Label = name });
            lift.Items.Add(new PolylineItem([.. speeds.Select(speed => new PlotPoint(speed, -Force(scene, speed, 50).X))]) { Colour = colour, Width = 2, Label = name });
        }

        return Svg.Standing("Drag and side force by speed, for three balls and the published laws", Figure.Stack("", drag.Draw(), lift.Draw()));
    }

    /// <summary>A low ball that bounces until it rolls, with its events.</summary>
    public static XElement Bounce()
    {
        var simulator = new Simulator();
        var path = new Trajectory();
        simulator.LookAhead(simulator.Launch(s_start, new Vector3d(0, 4.6, -7.7), Vector3d.Zero), new LookAheadRequest { Duration = 12, StopAt = StopAt.Rest }, path);
        var chart = new Chart(new Axis("along, m"), new Axis("height, m") { Min = 0, Max = 1.5 }) { Title = "9 m/s at 31°, no spin", Width = DocPictures.Width, PlotHeight = 190 };
        chart.Items.Add(new PolylineItem([.. Times(path.EndTime, 0.01).Select(time => path.PositionAt(time)).Select(at => new PlotPoint(-at.Z, at.Y))]) { Width = 2 });
        var caption = new Dictionary<BallEventKind, (Mark Mark, string Colour, string Name)>
        {
            [BallEventKind.Impact] = (Mark.Ring, Palette.Blue, "Impact"),
            [BallEventKind.Slide] = (Mark.Triangle, Palette.Orange, "Slide"),
            [BallEventKind.Roll] = (Mark.Square, Palette.Green, "Roll"),
            [BallEventKind.Rest] = (Mark.Cross, Palette.Red, "Rest"),
        };
        foreach (IGrouping<BallEventKind, BallEvent> kind in path.Events.Span.ToArray().GroupBy(happened => happened.Kind))
        {
            (Mark mark, string colour, string name) = caption[kind.Key];
            BallEvent[] all = [.. kind];
            chart.Items.Add(new ScatterItem([.. all.Select(at => new PlotPoint(-at.Position.Z, at.Position.Y))])
            {
                Mark = mark,
                Colour = colour,
                Size = 4,
                Label = name,
                Captions = [.. all.Select((at, i) => (kind.Key, i) switch
                {
                    (BallEventKind.Impact, 0 or 1) => FormattableString.Invariant($"{at.Time:F2} s, {at.VelocityBefore.Length:F1} → {at.Velocity.Length:F1} m/s"),
                    (BallEventKind.Rest, _) => FormattableString.Invariant($"{at.Time:F2} s"),
                    _ => "",
                })],
            });
        }

        return Svg.Standing("A ball that bounces, slides, rolls and rests, with its events", Figure.Stack("", chart.Draw()));
    }

    private static IEnumerable<Vector3d> Way(double topSpin, double sideSpin)
    {
        var simulator = new Simulator();
        var path = new Trajectory();
        (double up, double level) = Math.SinCos(14 * Math.PI / 180);
        simulator.LookAhead(simulator.Launch(s_start, 25 * new Vector3d(0, up, -level), new Vector3d(-topSpin, sideSpin, 0)), new LookAheadRequest { Duration = 4, StopAt = StopAt.Impact }, path);
        return Times(path.EndTime, 0.02).Select(time => path.PositionAt(time));
    }

    /// <summary>The air's force on a ball that flies along −z, in its weights, from how a microsecond changes its velocity.</summary>
    private static Vector3d Force(Scene scene, double speed, double sideSpin)
    {
        const double moment = 1e-6;
        var simulator = new Simulator(scene with { Ground = Ground.None });
        BallState state = simulator.Launch(new Vector3d(0, 50, 0), new Vector3d(0, 0, -speed), new Vector3d(0, sideSpin, 0));
        Vector3d before = state.Velocity;
        simulator.Step(ref state, moment, new StepLog());
        return (state.Velocity - before) / (moment * 9.81);
    }

    private static IEnumerable<double> Times(double end, double step) => Enumerable.Range(0, (int)(end / step) + 1).Select(i => i * step).Append(end);
}
