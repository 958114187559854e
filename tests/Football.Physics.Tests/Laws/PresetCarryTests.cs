using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Laws;

/// <summary>The balls fly in their measured order.</summary>
public sealed class PresetCarryTests
{
    /// <summary>Of the match balls, in the order of <see cref="BallProperties.Presets"/>.</summary>
    private static readonly string[] s_others = ["youthFootball", "futsal", "beachBall", "medicineBall"];

    [Theory]
    [InlineData("telstar18", 51.6, 67.5, 46.0, 57.2)]
    [InlineData("fussballliebe", 51.2, 65.9, 48.5, 59.9)]
    [InlineData("trionda", 55.1, 72.1, 50.4, 63.1)]
    [InlineData("flight2020", 56.5, 74.8, 52.3, 65.8)]
    public void A_ball_carries_as_far_as_it_must(string preset, double slow, double fast, double slowWithBackspin, double fastWithBackspin)
    {
        BallProperties ball = BallProperties.Presets[preset];
        Assert.Equal(slow, Carry(ball, 30, 0), 0.05001);
        Assert.Equal(fast, Carry(ball, 38, 0), 0.05001);
        Assert.Equal(slowWithBackspin, Carry(ball, 30, 30), 0.05001);
        Assert.Equal(fastWithBackspin, Carry(ball, 38, 30), 0.05001);
    }

    /// <summary>Missed: one study (KJSS 2024) has Jabulani longest of ten; with its measured curve it is not, and studies disagree.</summary>
    [Fact]
    public void The_match_balls_fly_in_their_measured_order()
    {
        double Of(string preset) => Carry(BallProperties.Presets[preset], 38, 0);
        string[] matchBalls = [.. BallProperties.Presets.Keys.Except(s_others)];
        Assert.Equal("fussballliebe", matchBalls.MinBy(Of));
        Assert.InRange(1 - (Of("telstar18") / Of("brazuca")), 0.08, 0.10);
        Assert.All(["brazuca", "telstar18", "jabulani"], shorter => Assert.True(Of("alRihla") > Of(shorter), shorter));
        Assert.InRange(Of("alRihla") - Of("trionda"), 2, 8);
        Assert.NotEqual("jabulani", matchBalls.MaxBy(Of));
    }

    private static double Carry(BallProperties ball, double speed, double backspin)
    {
        double angle = 35 * Math.PI / 180;
        return Flight.ToImpact(
            new Scene { Ball = ball }, Integrator.Rk4, 0.0025, new Vector3d(0, ball.Radius, 0), new Vector3d(speed * Math.Cos(angle), speed * Math.Sin(angle), 0), new Vector3d(0, 0, backspin)).Position.X;
    }
}
