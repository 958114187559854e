using System.Xml.Linq;

namespace Football.Physics.Headless.Gallery;

/// <summary>A shot that was played and drawn.</summary>
internal sealed record ShownShot(GalleryShot Shot, ShotFigures Figures, string Remark, XElement Drawing)
{
    /// <summary>Plays and draws a shot.</summary>
    public static ShownShot Make(GalleryShot shot)
    {
        var flight = new Flight(shot.Scenario);
        Flight? comparison = shot.Comparison is null ? null : new Flight(shot.Comparison);
        string remark = shot.GoalLine is { } line ? GoalCrossing.Describe(flight, line) : "";
        if (shot.DrawnTo is not null && ViewFrame.Along(flight.Outcome.Final.Position) is var end && end > shot.DrawnTo)
        {
            remark += FormattableString.Invariant($" It rests beyond the drawing, {end:0} m along.");
        }

        return new ShownShot(shot, ShotFigures.Of(flight.Outcome), remark, ShotDrawing.Draw(shot, flight, comparison));
    }
}
