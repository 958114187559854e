using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Prediction;

namespace FootballPhysics.Site.Pictures;

/// <summary>The seams of a ball, and the drag curves and carries of all presets.</summary>
internal static class BallPictures
{
    private static readonly Vector3d s_start = new(0, 0.11, 0);

    /// <summary>The same kick without spin in four orientations of the ball, from above, and with a slow spin.</summary>
    public static XElement Knuckle()
    {
        var simulator = new Simulator(new Scene { Forces = ForceSet.Measured with { KnuckleSeed = 1 } });
        var above = new Chart(new Axis("along, m"), new Axis("to the left, m")) { Title = "29 m/s at 12°, no spin, from above", Width = DocPictures.Width, PlotHeight = 170, Background = Palette.Grass };
        for (int i = 0; i < 4; i++)
        {
            var orientation = Quaterniond.FromAxisAngle(new Vector3d(0, 1, 0), i * Math.PI / 4);
            above.Items.Add(Way(simulator, in orientation, 0, $"turned by {45 * i}°", Palette.Series[i]));
        }

        var slow = new Chart(new Axis("along, m"), new Axis("to the left, m")) { Title = "one orientation, by spin about the vertical", Width = DocPictures.Width, PlotHeight = 170, Background = Palette.Grass };
        int colour = 0;
        foreach (double spin in new[] { 0.0, 3, 6 })
        {
            slow.Items.Add(Way(simulator, Quaterniond.Identity, spin, $"{spin} rad/s", Palette.Series[colour++]));
        }

        Chart.SameScale(above, slow);
        return Svg.Standing("A knuckleball: the same kick in four orientations of the ball, and with a slow spin", Figure.Stack("", above.Draw(), slow.Draw()));
    }

    /// <summary>The drag curves of all presets, and their carries at 35° with and without backspin.</summary>
    public static XElement Presets()
    {
        double[] speeds = [.. Enumerable.Range(0, 121).Select(i => 5 + (0.25 * i))];
        var drag = new Chart(new Axis("speed, m/s"), new Axis("C_D without spin") { Min = 0 }) { Title = "Drag curves of all presets", Width = DocPictures.Width, PlotHeight = 230 };
        var carry = new Chart(new Axis("carry at 38 m/s, m"), new Axis("with backspin of 30 rad/s, m")) { Title = "Carries at 35°", Width = DocPictures.Width, PlotHeight = 230 };
        int i = 0;
        foreach ((string name, BallProperties ball) in BallProperties.Presets)
        {
            string colour = Palette.Series[i % Palette.Series.Count];
            string dash = (i / Palette.Series.Count) switch { 0 => "none", 1 => "5 3", _ => "2 2" };
            drag.Items.Add(new PolylineItem([.. speeds.Select(speed => new PlotPoint(speed, Drag(ball, speed)))]) { Colour = colour, Dash = dash, Label = name });
            carry.Items.Add(new ScatterItem([new PlotPoint(Carry(ball, 0), Carry(ball, 30))]) { Colour = colour, Mark = (Mark)(i / Palette.Series.Count), Label = name });
            i++;
        }

        return Svg.Standing("Drag by speed, and the carries of all presets", Figure.Stack("", drag.Draw(), carry.Draw()));
    }

    private static PolylineItem Way(Simulator simulator, in Quaterniond orientation, double spin, string label, string colour)
    {
        double angle = 12 * Math.PI / 180;
        var path = new Trajectory();
        BallState ball = simulator.Launch(s_start, new Vector3d(0, 29 * Math.Sin(angle), -29 * Math.Cos(angle)), new Vector3d(0, spin, 0), orientation);
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 0.9, StopAt = StopAt.Impact }, path);
        return new PolylineItem([.. Enumerable.Range(0, 91).Select(i => path.PositionAt(path.EndTime * i / 90)).Select(at => new PlotPoint(-at.Z, -at.X))])
        {
            Colour = colour,
            Width = 2,
            Label = label,
        };
    }

    private static double Drag(BallProperties ball, double speed)
    {
        var scene = new Scene { Ball = ball };
        double area = Math.PI * ball.Radius * ball.Radius;
        return new Aerodynamics(scene).Evaluate(Vector3d.Zero, new Vector3d(speed, 0, 0), Vector3d.Zero).Force.Length / (0.5 * scene.Air.Density * area * speed * speed);
    }

    private static double Carry(BallProperties ball, double backspin)
    {
        double angle = 35 * Math.PI / 180;
        var simulator = new Simulator(new Scene { Ball = ball });
        var path = new Trajectory();
        BallState kicked = simulator.Launch(
            new Vector3d(0, ball.Radius, 0), new Vector3d(38 * Math.Cos(angle), 38 * Math.Sin(angle), 0), new Vector3d(0, 0, backspin));
        simulator.LookAhead(in kicked, new LookAheadRequest { Duration = 20, StopAt = StopAt.Impact }, path);
        return path.PositionAt(path.EndTime).X;
    }
}
