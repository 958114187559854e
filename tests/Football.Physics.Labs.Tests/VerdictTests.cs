using FootballPhysics.Labs.Verdicts;
using FootballPhysics.Tracks;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests;

/// <summary>The verdict of match fits, on matches by an integrator that is not the library's. The laboratory "verdicts" measures thousands.</summary>
public sealed class VerdictTests
{
    private static readonly Scene s_scene = new() { Ball = BallProperties.Tunnel };

    [Theory]
    [InlineData(0)]
    [InlineData(6)]
    public void A_clean_track_is_good_for_launches_and_spins(int number)
    {
        MatchFitResult fit = Fit(number, TrackFault.None);
        Assert.Equal(TrackSuspicions.None, fit.Suspicions);
        Assert.True(fit.GoodFor.HasFlag(MatchAnswers.Launches | MatchAnswers.Spins), fit.Explanation);
    }

    [Theory]
    [InlineData(1, TrackFault.Clock)]
    [InlineData(11, TrackFault.Heights)]
    public void A_wrong_clock_or_scale_is_suspected(int number, object fault)
    {
        MatchFitResult fit = Fit(number, (TrackFault)fault);
        Assert.True(fit.Suspicions.HasFlag(TrackSuspicions.Scale), fit.Explanation);
        Assert.Equal(MatchAnswers.None, fit.GoodFor);
        Assert.StartsWith("where the ball flew and about how fast; it falls with ", fit.Explanation, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(5, TrackFault.Lines, TrackSuspicions.Lines)]
    [InlineData(7, TrackFault.Held, TrackSuspicions.Held)]
    public void Drawn_points_are_left_out(int number, object fault, TrackSuspicions suspicion)
    {
        MatchFitResult fit = Fit(number, (TrackFault)fault);
        Assert.True(fit.Suspicions.HasFlag(suspicion), fit.Explanation);
        Assert.Contains("were left out", fit.Explanation, StringComparison.Ordinal);
    }

    private static MatchFitResult Fit(int number, TrackFault fault)
    {
        var match = VerdictMatch.Play(new SeededRandom(SeededRandom.Mix(1, number)), number);
        Assert.Equal(fault, match.Fault);
        return new MatchFit(s_scene).Find(match.Track);
    }
}
