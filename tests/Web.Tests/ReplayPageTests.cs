using FootballPhysics.Tool.Gallery;
using FootballPhysics.Tool.Replay;

namespace FootballPhysics.Web.Tests;

/// <summary>The page of football replay and of the gallery, while it plays.</summary>
public sealed class ReplayPageTests(Browser browser, ITestOutputHelper told)
{
    [Fact]
    public async Task A_story_ends_a_moment_after_the_goal_and_begins_again()
    {
        ShownShot shown = ShownShot.Make(GalleryShots.All.Single(shot => shot.Id == "off-the-bar"));
        string page = Path.Combine(Browser.Pictures, "replay.html");
        await File.WriteAllTextAsync(page, ReplayPage.Html("Off the bar", [shown.Moving]), TestContext.Current.CancellationToken);
        await using Window window = await browser.Open(page);
        double goal = shown.Moving.Shots[0].Track.Events.First(item => item.Kind == FootballPhysics.BallEventKind.Goal).Time;
        double rest = shown.Moving.Shots[0].Track.Keys[^1].Time;
        await window.Page.SelectOptionAsync("#speed", "2");

        // Frame by frame until the time has gone back twice.
        double[] seen = await window.Page.EvaluateAsync<double[]>("""
            () => new Promise(done => {
              const times = [];
              let back = 0;
              const look = () => {
                const time = JSON.parse(document.getElementById("stage").dataset.drawn).time;
                if (times.length > 0 && time < times[times.length - 1]) back++;
                times.push(time);
                if (back === 2) done(times); else requestAnimationFrame(look);
              };
              look();
            })
            """);
        Assert.InRange(seen.Max(), goal + 1, Math.Min(goal + 3, rest - 0.2));
        Assert.Equal("Pause", await window.Page.GetAttributeAsync("#play", "aria-label"));
        Assert.Empty(window.Errors);
        told.WriteLine(FormattableString.Invariant($"a goal after {goal:F2} s, at rest after {rest:F2} s: the story ends at {seen.Max():F2} s and begins again; {seen.Length} frames"));
    }
}
