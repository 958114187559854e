using FootballPhysics.Labs.People;

namespace FootballPhysics.Labs.Tests.Things;

/// <summary>A ball among players, boards, posts and nets, two of them at a time, by checks that know nothing of the library's contacts.</summary>
public sealed class PeopleTests
{
    private const long Seed = 46;

    [Theory]
    [InlineData("Board")]
    [InlineData("Corner")]
    [InlineData("Post")]
    [InlineData("Net")]
    public void A_player_presses_no_ball_into_what_stands_still(string against)
    {
        var presses = new Presses(Enum.Parse<PressKind>(against));
        for (int i = 0; i < 25; i++)
        {
            presses.Play(Seed, i);
        }

        Assert.Equal(25, presses.Cases);
        Assert.All(presses.Claims, claim => Assert.True(claim.Holds));
        Assert.InRange(presses.Meter.Events.Most, 1, StepMeter.MostAllowed);
        Assert.InRange(presses.Inside.Worst, 0, 1e-9);
    }

    /// <summary>Presses that were found to tremble in a corner, to be let go by a net and to be pressed deep into one: what a step tells and takes is bounded.</summary>
    [Theory]
    [InlineData("Corner", 20261129, 57, 1000)]
    [InlineData("Net", 20261126, 22, 5000)]
    [InlineData("Net", 20261125, 243, 3000)]
    [InlineData("Net", 20261125, 524, 5000)]
    public void A_ball_that_trembles_tells_and_takes_no_more_than_others(string against, long seed, int index, long mostEvaluations)
    {
        var presses = new Presses(Enum.Parse<PressKind>(against));
        presses.Play(seed, index);
        Assert.InRange(presses.Meter.Events.Most, 1, StepMeter.MostAllowed);
        Assert.InRange(presses.Meter.Evaluations.Most, 1, mostEvaluations);
        Assert.Equal((1, 0, 0), (presses.Cases, presses.Inside.Count, presses.Behind.Count));
    }

    /// <summary>Two pinches that were a quarter of a percent too fast, by what gravity did to a squeezed ball.</summary>
    [Fact]
    public void Gravity_makes_a_squeezed_ball_no_faster_than_it_falls()
    {
        var pinches = new Pinches();
        pinches.Play(20261125, 2364);
        Assert.True(pinches.TooFast.Holds);
    }

    [Fact]
    public void Two_players_make_no_ball_faster_than_they_may_and_let_it_go()
    {
        var pinches = new Pinches();
        for (int i = 0; i < 100; i++)
        {
            pinches.Play(Seed, i);
        }

        Assert.Equal((100, 0, 0, 0), (pinches.Cases, pinches.Unending.Count, pinches.Beyond20.Count, pinches.TooFast.Count));
        Assert.True(pinches is { Squeezed.Count: > 20, InGround.Worst: < 1e-9 });
        Assert.InRange(pinches.Meter.Events.Most, 1, StepMeter.MostAllowed);
    }

    [Fact]
    public void One_that_moves_pushes_it_along_or_away()
    {
        var meetings = new Meetings();
        for (int i = 0; i < 60; i++)
        {
            meetings.Play(Seed, i);
        }

        Assert.Equal((60, 0), (meetings.Cases, meetings.TooFast.Count));
        Assert.True(meetings is { InGround.Worst: < 1e-9, Overlap.Worst: < 1e-5 });
        Assert.InRange(meetings.Meter.Events.Most, 1, StepMeter.MostAllowed);
    }

    [Fact]
    public void Flat_into_the_edge_of_board_and_ground_it_rests_as_soon_as_on_open_ground()
    {
        var hits = new FlatHits();
        for (int i = 0; i < 90; i++)
        {
            hits.Play(Seed, i);
        }

        Assert.True(hits.Cases > 50);
        Assert.All(hits.Claims, claim => Assert.True(claim.Holds));
    }

    /// <summary>Two minutes at whose end a net presses the ball against a post, 110 times in a step it was; and a minute and a half at whose end a player squeezes it round one.</summary>
    [Theory]
    [InlineData(4, 133)]
    [InlineData(28, 93)]
    public void A_ball_pressed_against_a_post_stays_on_it_and_goes_round_it(int match, double seconds)
    {
        var matches = new StadiumMatches();
        matches.Play(1234, match, seconds, _ => { });
        Assert.Equal((0, 0, 0, 0), (matches.Inside.Count, matches.Made.Count, matches.Elsewhere.Count, matches.RewoundElsewhere.Count));
        Assert.InRange(matches.Meter.Events.Most, 1, StepMeter.MostAllowed);
    }

    [Fact]
    public void A_minute_of_a_match_keeps_what_any_match_must()
    {
        var matches = new StadiumMatches();
        matches.Play(Seed, 0, 60, _ => { });
        matches.Play(Seed, 1, 60, _ => { });
        Assert.All(matches.Claims, claim => Assert.True(claim.Holds));
        Assert.True(matches is { Kicks.Count: > 5, Restless.Of: 2, Made.Of: > 1000, RewoundElsewhere.Of: > 5000 });
        Assert.InRange(matches.Meter.Events.Most, 1, StepMeter.MostAllowed);
    }
}
