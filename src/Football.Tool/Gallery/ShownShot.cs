using System.Xml.Linq;
using FootballPhysics.Tool.Replay;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>A shot with its simulation and its drawings.</summary>
internal sealed record ShownShot(GalleryShot Shot, ShotFigures Figures, string Remark, XElement Drawing, ReplayPicture Moving)
{
    /// <summary>Simulates and draws a shot.</summary>
    public static ShownShot Make(GalleryShot shot)
    {
        var flight = new Flight(shot.Scenario);
        Flight? comparison = shot.Comparison is null ? null : new Flight(shot.Comparison);

        // After a save, the rest of the ball's path does not matter.
        bool saved = shot.Keeper is not null && flight.Events.All(item => item.Kind != BallEventKind.Goal);
        string remark = shot.Scenario.Scene.Goals.Count > 0 && !saved ? GoalCrossing.Describe(flight, shot.Scenario.Scene.Goals[0]) : "";
        if (shot.DrawnTo is not null && ViewFrame.Along(flight.Outcome.Final.Position) is var end && end > shot.DrawnTo)
        {
            remark += FormattableString.Invariant($" It rests beyond the drawing, {end:0} m along.");
        }

        IReadOnlyList<KeeperPose> keeper = shot.Keeper is null ? [] : KeeperPose.Of(shot.Scenario, shot.Keeper);
        ReplayPicture moving = Picture(shot, flight, comparison) with { Keeper = keeper };
        return new ShownShot(shot, ShotFigures.Of(flight.Outcome), remark, ShotDrawing.Draw(shot, flight, comparison, keeper), moving);
    }

    private static ReplayPicture Picture(GalleryShot shot, Flight flight, Flight? comparison)
    {
        List<(string Name, Scenario Scenario, Outcome Outcome)> played = [(shot.Name, shot.Scenario, flight.Outcome)];
        if (comparison is not null)
        {
            played.Add((shot.ComparisonName, shot.Comparison!, comparison.Outcome));
        }

        var picture = ReplayPicture.Of(shot.Id, shot.Name, played);
        return picture with
        {
            About = shot.About,
            Shapes = [.. shot.Markings, .. shot.OnGoal, .. picture.Shapes],
            Shots = [.. picture.Shots.Select((item, i) => item with { Compares = i > 0 })],
            Targets = shot.Points,
        };
    }
}
