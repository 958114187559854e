using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Netcode;
using FootballPhysics.Prediction;

namespace FootballPhysics.Site.Pictures;

/// <summary>Kicks that arrive late, and balls in engines.</summary>
internal static class GamePictures
{
    private const double Tick = 1.0 / 60;

    /// <summary>The kick of the rollback program: it belongs to tick 43 and arrives at tick 60.</summary>
    public static XElement LateKick()
    {
        var runner = new FixedStepRunner(timeStep: Tick);
        var rollback = new Rollback(runner, ticks: 30);
        for (int i = 0; i < 60; i++)
        {
            runner.Step();
        }

        Vector3d believed = runner.State.Position;
        rollback.ApplyKick(new KickInput(tick: 43, velocity: new Vector3d(3, 7, -20), spin: new Vector3d(0, 40, 0), player: 2));
        PlotPoint[] again = [.. Enumerable.Range(43, 18).Select(tick => Paths.FromSide(rollback.StateAt(tick).Position))];
        var then = new List<PlotPoint> { Paths.FromSide(runner.State.Position) };
        for (int i = 0; i < 60; i++)
        {
            runner.Step();
            then.Add(Paths.FromSide(runner.State.Position));
        }

        Chart chart = Paths.Side("A kick of tick 43 arrives at tick 60", 110);
        chart.Items.Add(new PolylineItem(then) { Width = 2, Label = "later steps" });
        chart.Items.Add(new PolylineItem(again) { Colour = Palette.Orange, Width = 2, Label = "resimulated steps" });
        chart.Items.Add(new ScatterItem(again) { Colour = Palette.Orange, Size = 2 });
        chart.Items.Add(Paths.Marked(Paths.FromSide(believed), "tick 60, before the kick arrived", Palette.Red, Mark.Diamond));
        chart.Items.Add(Paths.Marked(then[0], "tick 60, corrected", Palette.Green, Mark.Diamond));
        return Paths.Picture("A late kick: the ball lay still, and the resimulated steps bring it onto its path within one call", chart);
    }

    /// <summary>How far the drawn ball is from the corrected one, with the rule of the page.</summary>
    public static XElement Correction()
    {
        const double HalfLife = 0.08;
        var runner = new FixedStepRunner(timeStep: Tick);
        var rollback = new Rollback(runner, ticks: 30);
        for (int i = 0; i < 60; i++)
        {
            runner.Step();
        }

        Vector3d drawn = runner.State.Position;
        rollback.ApplyKick(new KickInput(tick: 36, velocity: new Vector3d(3, 7, -20), spin: new Vector3d(0, 40, 0), player: 2));
        Vector3d offset = drawn - runner.State.Position;
        var ball = new List<PlotPoint>();
        var seen = new List<PlotPoint>();
        for (int frame = 0; frame < 45; frame++)
        {
            ball.Add(Paths.FromSide(runner.State.Position));
            seen.Add(Paths.FromSide(runner.State.Position + (Math.Pow(0.5, frame * Tick / HalfLife) * offset)));
            runner.Step();
        }

        Chart chart = Paths.Side("The drawn ball catches up", 110);
        chart.Items.Add(new LinesItem([.. Enumerable.Range(0, 15).Select(i => (PlotPoint[])[ball[2 * i], seen[2 * i]])]) { Colour = Palette.Frame, Label = "the offset, every second frame" });
        chart.Items.Add(new PolylineItem(ball) { Width = 2, Label = "the ball" });
        chart.Items.Add(new PolylineItem(seen) { Colour = Palette.Orange, Width = 2, Label = "drawn" });
        return Paths.Picture("After a correction, the drawn ball starts where it was and joins the path; the offset halves every 80 ms", chart);
    }

    /// <summary>The kick of Unity's script, in Unity's axes.</summary>
    public static XElement UnityKick() => Kick("Kick(27f, new Vector3(0.3f, 0.28f, 1f), -10f, 60f)", new Vector3d(0.3, 0.28, -1), 60, "z (forward), m", "−x (to the left), m");

    /// <summary>The kick of Godot's script, in Godot's axes.</summary>
    public static XElement GodotKick() => Kick("Kick(27.0, Vector3(-0.1, 0.3, -1.0), -10.0, 55.0)", new Vector3d(-0.1, 0.3, -1), 55, "−z (forward), m", "−x (to the left), m");

    /// <summary>A rigid body in Unity's steps of 20 ms.</summary>
    public static XElement UnityAir() => Body("Rigidbody", "Football Air", 0.02, new Vector3d(0.3, 0.28, -1), 60, "z (forward), m", "−x (to the left), m");

    /// <summary>A rigid body in Godot's steps of 1/60 s.</summary>
    public static XElement GodotAir() => Body("RigidBody3D", "FootballAir", Tick, new Vector3d(0.3, 0.28, -1), 60, "−z (forward), m", "−x (to the left), m");

    private static XElement Kick(string code, Vector3d direction, double sideSpin, string along, string across)
    {
        Chart[] charts = [Paths.Side(code), Paths.Above("", 110, along, across)];
        Func<Vector3d, PlotPoint>[] views = [Paths.FromSide, Paths.FromAbove];
        foreach ((double spin, string label, string colour) in new[] { (sideSpin, "this kick", Palette.Blue), (0, "without sidespin", Palette.Frame) })
        {
            var ball = new Ball();
            ball.Kick(27, direction, topSpin: -10, sideSpin: spin);
            Trajectory path = Paths.Of(ball, 2.4, StopAt.Time);
            for (int i = 0; i < 2; i++)
            {
                charts[i].Items.Add(new PolylineItem(Paths.Points(path, views[i])) { Colour = colour, Width = 2, Label = label });
                charts[i].Items.Add(new ScatterItem(Paths.Events(path, views[i], BallEventKind.Impact)) { Colour = Palette.Orange, Size = 2.5, Label = "Impact" });
            }
        }

        Chart.SameScale(charts);
        return Paths.Picture($"The path of {code} from the side and from above, in the axes of the engine", charts);
    }

    /// <summary>The body with and without the air, next to the library's own ball.</summary>
    private static XElement Body(string body, string component, double step, Vector3d direction, double sideSpin, string along, string across)
    {
        var ball = new Ball();
        ball.Kick(27, direction, topSpin: -10, sideSpin: sideSpin);
        (Vector3d velocity, Vector3d spin) = (ball.Velocity, ball.Spin);
        Chart chart = Paths.Above($"A {body} with and without {component}", 130, along, across);
        chart.Items.Add(new PolylineItem(Paths.Points(Paths.Of(ball, 1.3, StopAt.Impact), Paths.FromAbove)) { Colour = Palette.Green, Width = 5, Label = "the library's ball" });
        chart.Items.Add(new PolylineItem(Moved(true)) { Width = 1.8, Label = $"with {component}" });
        chart.Items.Add(new PolylineItem(Moved(false)) { Colour = Palette.Red, Width = 1.8, Label = "without" });
        return Paths.Picture($"From above: a {body} with {component} follows the library's ball, and one without flies straight and too far", chart);

        List<PlotPoint> Moved(bool hasAir)
        {
            var air = new Aerodynamics(new Scene());
            double mass = air.Scene.Ball.Mass;
            var gravity = new Vector3d(0, -9.81, 0);
            Vector3d pull = hasAir ? gravity + (air.Buoyancy / mass) : gravity;
            (Vector3d at, Vector3d v, Vector3d w) = (Paths.Start, hasAir ? air.KickVelocity(Paths.Start, velocity, spin, step, pull) : velocity, spin);
            var points = new List<PlotPoint>();
            while (at.Y >= 0.11 && points.Count * step < 1.3)
            {
                points.Add(Paths.FromAbove(at));
                ForceAndTorque load = hasAir ? air.EvaluateForStep(at, v, w, step, pull) : default;
                v += step * (pull + (load.Force / mass));
                w += step / air.Scene.Ball.MomentOfInertia * load.Torque;
                at += step * v;
            }

            return points;
        }
    }
}
