using System.Xml.Linq;
using FootballPhysics.Drawing;
using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Tool.Gallery;

/// <summary>Draws a goal from the front, and the ball in it to scale.</summary>
internal static class GoalDrawing
{
    /// <summary>The distance from the goal line at which the drawn path starts, in m.</summary>
    private const double Before = 8;

    /// <summary>The distance from the goal line within which objects are drawn, in m.</summary>
    private const double Near = 1;

    /// <summary>Draws the goal of a shot; returns null if the ball does not reach it.</summary>
    public static XElement? Draw(GalleryShot shot, Flight flight, IReadOnlyList<SceneShape> shapes, double width)
    {
        if (shot.Scenario.Scene.Goals is not [var goal, ..] || Arrival(flight, goal) is not { } arrival)
        {
            return null;
        }

        double half = (0.5 * goal.Width) + 0.6;
        var chart = new Chart(new Axis("to the right of the middle, m") { Min = -half, Max = half }, new Axis("height, m") { Min = 0, Max = goal.Height + 0.4 })
        {
            Title = "The goal from in front",
            Width = width,
            EqualScales = true,
            PlotHeight = 100,
        };
        PlotPoint Project(Vector3d place) => new(Vector3d.Dot(place - goal.Center, Vector3d.Cross(-goal.Outward(), Vector3d.Up)), place.Y - goal.Center.Y);
        bool IsHere(SceneShape shape) => shape.Kind is SceneShapeKind.Net or SceneShapeKind.Frame
            || (shape.Kind == SceneShapeKind.Obstacle && shape.Points.All(place => Distance(goal, place + (arrival.Time * shape.Velocity)) < Near));
        SceneShape Unnamed(SceneShape shape) => shape.Kind == SceneShapeKind.Frame ? shape with { Name = "" } : shape;
        SceneDrawing.Add(chart, [.. shapes.Where(IsHere).Select(Unnamed), .. shot.OnGoal], Project, fromAbove: false, arrival.Time);
        var names = new Simulator(shot.Scenario.Scene);
        IEnumerable<Vector3d> way = flight.Outcome.Samples!.Where(at => at.Time < arrival.Time && Distance(goal, at.Position) < Before).Select(at => at.Position);
        chart.Items.Add(new PolylineItem([.. way.Append(arrival.Position).Select(Project)]));
        foreach (BallEvent happened in flight.Events.Where(item => item.Time <= arrival.Time && Distance(goal, item.Position) < Near && item.Kind is BallEventKind.Impact or BallEventKind.Goal))
        {
            bool goes = happened.Kind == BallEventKind.Goal;
            chart.Items.Add(new PolygonItem([SceneDrawing.Circle(Project(happened.Position), shot.Scenario.Scene.Ball.Radius)])
            {
                Fill = Palette.Paper,
                Colour = goes ? Palette.Red : Palette.Blue,
                Caption = goes ? "goal" : OfFrame(names.NameOf(happened.ColliderIndex)),
            });
        }

        return chart.Draw();
    }

    /// <summary>Returns the goal, or the first hit of the frame or of an obstacle near the line; null if there is none.</summary>
    private static BallEvent? Arrival(Flight flight, Goal goal)
    {
        IEnumerable<BallEvent> goals = flight.Events.Where(item => item.Kind == BallEventKind.Goal);
        IEnumerable<BallEvent> saves = flight.Events.Where(item => item.Kind == BallEventKind.Impact && item.ColliderIndex != 0 && Distance(goal, item.Position) < Near);
        return goals.Concat(saves).Cast<BallEvent?>().FirstOrDefault();
    }

    /// <summary>Returns "post" or "crossbar". Whether a post is left or right depends on the side of the viewer.</summary>
    private static string OfFrame(string? name)
    {
        string part = name?.Split(' ')[^1] ?? "";
        return part is "post" or "crossbar" ? part : "";
    }

    private static double Distance(Goal goal, Vector3d place) => Math.Abs(Vector3d.Dot(place - goal.Center, goal.Outward()));
}
