using System.Text.RegularExpressions;
using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Gallery;

namespace FootballPhysics.Tool.Tests;

/// <summary>The captions of the gallery describe what happens: each claim is checked against the events of the shot.</summary>
public sealed class CaptionTests
{
    /// <summary>Words of a caption that claim an event. A caption with one of them needs a row below.</summary>
    private static readonly Regex s_claims = new(@"\b(goal|in|post|posts|bar|keeper|wall|board|headed|head|bounce|saves|beaten)\b", RegexOptions.IgnoreCase);

    /// <summary>The objects that the ball hits and the goal, in order, as a pattern; consecutive hits of one object are one.</summary>
    private static readonly Dictionary<string, string> s_stories = new()
    {
        ["free-kick"] = "^goal",
        ["found-free-kick"] = "^goal",
        ["off-the-bar"] = "^crossbar ground goal|^crossbar goal",
        ["off-both-posts"] = "^right post left post goal",
        ["headed-corner"] = "^head (ground )?goal",
        ["round-the-wall"] = "^(ground )?goal",
        ["over-the-keeper"] = "^(ground )?goal",
        ["down-the-slope"] = "^board",
        ["keeper-beaten"] = "^(ground )?goal",
        ["keeper-saves"] = "^(ground )?keeper(?!.* goal)",
        ["one-bounce-pass"] = "^ground",
        ["in-off-the-post"] = "^left post (ground )?goal",
        ["penalty-ellipse"] = "^goal",
    };

    /// <summary>Captions with a claiming word that claim no event, with the reason.</summary>
    private static readonly Dictionary<string, string> s_silent = new()
    {
        ["corner"] = "it swings back towards the goal",
        ["goal-kick"] = "the name of the kick",
        ["goal-kick-in-vacuum"] = "the name of the kick",
        ["high-ball-in-the-wind"] = "in the wind",
        ["driven-pass"] = "no object",
        ["chip"] = "a bounce on the ground, which every shot has",
        ["dropped-with-topspin"] = "bounces on the ground, which every shot has",
    };

    public static TheoryData<string> Shots => [.. GalleryShots.All.Select(shot => shot.Id)];

    [Theory]
    [MemberData(nameof(Shots))]
    public void A_caption_claims_what_the_events_show(string id)
    {
        GalleryShot shot = GalleryShots.All.Single(item => item.Id == id);
        var flight = new Flight(shot.Scenario);
        string story = Story(flight.Outcome);
        string caption = $"{shot.Name}. {shot.About}";
        if (s_stories.TryGetValue(id, out string? pattern))
        {
            Assert.Matches(pattern, story);
        }
        else
        {
            Assert.True(!s_claims.IsMatch(caption) || s_silent.ContainsKey(id), $"{id} claims an event: {caption} Its events are: {story}");
        }

        // The remark is computed; it must agree with the goal event.
        if (shot.Scenario.Scene.Goals.Count > 0)
        {
            string remark = GoalCrossing.Describe(flight, shot.Scenario.Scene.Goals[0]);
            Assert.Equal(story.Split(' ').Contains("goal"), remark.StartsWith("A goal", StringComparison.Ordinal));
        }
    }

    private static string Story(Outcome outcome)
    {
        var parts = new List<string>();
        foreach (BallEvent item in outcome.Events.Where(item => item.Kind is BallEventKind.Impact or BallEventKind.Goal))
        {
            string part = item.Kind == BallEventKind.Goal ? "goal" : outcome.SurfaceOf(in item) ?? "";
            if (parts.Count == 0 || parts[^1] != part)
            {
                parts.Add(part);
            }
        }

        return string.Join(' ', parts);
    }
}
