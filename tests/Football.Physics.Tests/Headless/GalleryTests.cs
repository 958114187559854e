using System.Xml.Linq;
using Football.Physics.Headless.Gallery;

namespace Football.Physics.Tests.Headless;

/// <summary>The gallery plays every shot to rest and draws it.</summary>
public sealed class GalleryTests
{
    [Fact]
    public void It_writes_a_drawing_a_shot_and_a_sheet_of_all_and_a_line_for_each()
    {
        string folder = Path.Combine(AppContext.BaseDirectory, "gallery-test");
        var done = FootballCommand.Run("", "gallery", "--out", folder);
        Assert.Equal(0, done.ExitCode);
        Assert.InRange(GalleryShots.All.Count, 10, 13);
        Assert.Equal(GalleryShots.All.Select(shot => shot.Id), done.Lines.Select(line => line.GetProperty("name").GetString()));

        var sheet = XDocument.Load(Path.Combine(folder, "index.html"));
        XNamespace svg = "http://www.w3.org/2000/svg";
        Assert.Equal(GalleryShots.All.Count, sheet.Descendants("article").Count(card => card.Element(svg + "svg") is not null));
        foreach (GalleryShot shot in GalleryShots.All)
        {
            var drawing = XDocument.Load(Path.Combine(folder, shot.Id + ".svg"));
            Assert.Contains(drawing.Descendants(svg + "text"), text => text.Value == "From the side");
            Assert.Contains(drawing.Descendants(svg + "text"), text => text.Value == "From above");
            Assert.DoesNotContain("NaN", drawing.ToString());
            Assert.Contains(shot.Name, done.Error);
        }

        Assert.DoesNotContain("src=", sheet.ToString());
        Assert.Contains(Path.Combine(folder, "index.html"), done.Error);
    }

    [Fact]
    public void Every_shot_comes_to_rest_with_figures_that_make_sense()
    {
        foreach (GalleryShot shot in GalleryShots.All)
        {
            var figures = ShotFigures.Of(new Flight(shot.Scenario).Outcome);
            Assert.NotNull(figures.RestTime);
            Assert.InRange(figures.Apex, shot.Scenario.Position.Y, 40);
            Assert.Equal(figures.Bounces > 0, figures.Carry is not null);
            Assert.Equal(figures.Bounces > 0, figures.HangTime is not null);
        }
    }

    [Fact]
    public void Sidespin_deflects_to_its_side_and_none_does_not()
    {
        ShotFigures Figures(string id) => ShotFigures.Of(new Flight(GalleryShots.All.Single(shot => shot.Id == id).Scenario).Outcome);
        Assert.InRange(Figures("free-kick").Deflection!.Value, 2, 10);
        Assert.InRange(Figures("corner").Deflection!.Value, -15, -4);
        Assert.Equal(0, Figures("no-spin-drive").Deflection!.Value, 1e-9);
    }

    [Fact]
    public void The_free_kick_clears_the_wall_and_is_a_goal()
    {
        GalleryShot shot = GalleryShots.All.Single(item => item.Id == "free-kick");
        var flight = new Flight(shot.Scenario);
        Landmark wall = shot.Landmarks.Single(item => item.Name == "wall");
        IEnumerable<Vector3d> over = flight.ToFirstTouchdown.Where(place => ViewFrame.Along(place) >= wall.AlongFrom && ViewFrame.Along(place) <= wall.AlongTo);
        Assert.NotEmpty(over);
        Assert.All(over, place => Assert.InRange(ViewFrame.Left(place), wall.LeftFrom, wall.LeftTo));
        Assert.All(over, place => Assert.True(place.Y > wall.Height + 0.11));
        Assert.StartsWith("A goal", GoalCrossing.Describe(flight, shot.GoalLine!.Value));
        Assert.StartsWith("No goal", GoalCrossing.Describe(new Flight(shot.Comparison!), shot.GoalLine!.Value));
    }
}
