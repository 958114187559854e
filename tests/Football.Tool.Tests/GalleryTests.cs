using System.Text.Json;
using System.Xml.Linq;
using FootballPhysics.Tool.Gallery;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Tests;

/// <summary>The gallery plays every shot to rest and draws it.</summary>
public sealed class GalleryTests
{
    [Fact]
    public void It_writes_a_drawing_a_shot_and_a_sheet_of_all_and_a_line_for_each()
    {
        string folder = Path.Combine(AppContext.BaseDirectory, "gallery-test");
        var done = FootballCommand.Run("", "gallery", "--out", folder);
        Assert.Equal(0, done.ExitCode);
        Assert.InRange(GalleryShots.All.Count, 10, 30);
        Assert.Equal(GalleryShots.All.Select(shot => shot.Id), done.Lines.Select(line => line.GetProperty("name").GetString()));

        var sheet = XDocument.Load(Path.Combine(folder, "index.html"));
        XNamespace svg = "http://www.w3.org/2000/svg";
        Assert.Equal(GalleryShots.All.Count, sheet.Descendants("article").Count(card => card.Descendants(svg + "svg").Any()));
        foreach (GalleryShot shot in GalleryShots.All)
        {
            var drawing = XDocument.Load(Path.Combine(folder, shot.Id + ".svg"));
            Assert.Contains(drawing.Descendants(svg + "text"), text => text.Value == "From the side");
            Assert.Contains(drawing.Descendants(svg + "text"), text => text.Value == "From above");
            Assert.DoesNotContain("NaN", drawing.ToString());
            Assert.Contains(shot.Name, done.Error);
        }

        Assert.DoesNotContain("src=", sheet.ToString());
        Assert.All(GalleryShots.All, shot => Assert.Contains($"replay.html#picture={shot.Id}", sheet.ToString()));
        Assert.All(GalleryShots.All, shot => Assert.Contains($"\"id\":\"{shot.Id}\"", File.ReadAllText(Path.Combine(folder, "replay.html"))));
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
        AssertPassesOver(flight.ToFirstTouchdown, shot);
        Goal goal = shot.Scenario.Scene.Goals[0];
        Assert.StartsWith("A goal", GoalCrossing.Describe(flight, goal));
        Assert.StartsWith("No goal", GoalCrossing.Describe(new Flight(shot.Comparison!), goal));
    }

    [Fact]
    public void A_metre_is_as_long_from_the_side_as_from_above_and_the_axis_along_is_the_same()
    {
        foreach (GalleryShot shot in GalleryShots.All)
        {
            XElement[] views = [.. ShownShot.Make(shot).Drawing.Elements().Where(part => part.Name.LocalName == "svg")];
            string[][] along = [.. views.Select(view => view.Elements().Where(text => text.Name.LocalName == "text" && text.Attribute("text-anchor")!.Value == "middle")
                .Select(text => $"{text.Value} at {text.Attribute("x")!.Value}").ToArray())];
            Assert.InRange(along.Length, 2, 3);
            Assert.NotEmpty(along[0]);
            Assert.Equal(along[0], along[1]);
        }
    }

    [Fact]
    public void A_legend_names_only_what_is_to_be_seen()
    {
        string[] Legend(string id) => [.. ShownShot.Make(GalleryShots.All.Single(shot => shot.Id == id)).Drawing.Descendants().Where(text => text.Name.LocalName == "text").Select(text => text.Value)];
        Assert.Contains("flies", Legend("free-kick"));
        Assert.DoesNotContain("launch direction", Legend("ground-pass"));
        Assert.DoesNotContain("flies", Legend("ground-pass"));
        Assert.DoesNotContain("impact", Legend("ground-pass"));
        Assert.DoesNotContain("rest", Legend("goal-kick-in-vacuum"));
    }

    [Fact]
    public void Posts_bar_nets_and_wall_are_drawn_and_every_drawing_has_a_title_and_a_dark_form()
    {
        XElement drawing = ShownShot.Make(GalleryShots.All.Single(shot => shot.Id == "free-kick")).Drawing;
        Assert.Equal("img", drawing.Attribute("role")!.Value);
        Assert.Equal("Free kick over the wall", drawing.Elements().First().Value);
        Assert.Contains("prefers-color-scheme: dark", drawing.Elements().ElementAt(1).Value);
        Assert.Equal(3 * 3, drawing.Descendants().Count(part => part.Attribute("stroke")?.Value == FootballPhysics.Drawing.Palette.Posts));
        Assert.Contains(drawing.Descendants(), part => part.Value == "wall");
        Assert.Contains(drawing.Descendants(), part => part.Value == "1 s");
    }

    [Fact]
    public void The_kick_that_is_shown_is_the_kick_that_is_played()
    {
        foreach (GalleryShot shot in GalleryShots.All)
        {
            var kick = KickNumbers.Of(shot.Scenario);
            kick.Vectors(out Vector3d velocity, out Vector3d spin);
            Assert.InRange((velocity - shot.Scenario.Velocity).Length, 0, 1e-9);
            Assert.InRange((spin - shot.Scenario.Spin).Length, 0, 1e-9);
            Assert.StartsWith("ball.Kick(speed: ", kick.Code);
        }
    }

    [Fact]
    public void A_shot_that_comes_to_a_goal_is_seen_from_in_front_of_it_too()
    {
        string[] Texts(string id) => [.. ShownShot.Make(GalleryShots.All.Single(shot => shot.Id == id)).Drawing.Descendants().Where(text => text.Name.LocalName == "text").Select(text => text.Value)];
        Assert.DoesNotContain("The goal from in front", Texts("goal-kick"));
        Assert.Contains("The goal from in front", Texts("free-kick"));
        Assert.Superset(new HashSet<string> { "post", "goal" }, Texts("off-both-posts").ToHashSet());
        Assert.Contains("one and two standard deviations", Texts("penalty-ellipse"));
    }

    [Fact]
    public void The_keeper_who_saves_is_met_by_the_ball_and_the_one_who_is_beaten_is_not()
    {
        Outcome Played(string id) => new Flight(GalleryShots.All.Single(shot => shot.Id == id).Scenario).Outcome;
        Assert.Contains(Played("keeper-beaten").Events, item => item.Kind == BallEventKind.Goal);
        Assert.DoesNotContain(Played("keeper-saves").Events, item => item.Kind == BallEventKind.Goal);
        Assert.Contains(Played("keeper-saves").Events, item => item.Kind == BallEventKind.Impact && item.ColliderIndex != 0);
    }

    internal static void AssertPassesOver(IEnumerable<Vector3d> way, GalleryShot shot)
    {
        var wall = (BoxShape)shot.Scenario.Scene.Obstacles.Single(item => item.Name == "wall").Shape;
        Vector3d[] over = [.. way.Where(place => Math.Abs(place.Z - wall.Center.Z) <= wall.HalfSize.Z)];
        Assert.NotEmpty(over);
        Assert.All(over, place => Assert.InRange(Math.Abs(place.X - wall.Center.X), 0, wall.HalfSize.X));
        Assert.All(over, place => Assert.True(place.Y > wall.Center.Y + wall.HalfSize.Y + 0.11));
    }
}
