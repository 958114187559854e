using FootballPhysics.Labs.Nets;

namespace FootballPhysics.Labs.Tests.Things;

/// <summary>The laboratory of nets, small: balls that are walked, kicked and pressed into nets.</summary>
public sealed class NetsLabTests
{
    [Fact]
    public void No_ball_is_deeper_than_its_net_gives_or_gains_energy_and_all_rest()
    {
        NetOutcome[] outcomes = [.. Enumerable.Range(0, 150).Select(i => NetDraw.Play(72, i))];
        Assert.All(outcomes, outcome => Assert.True(outcome.Holds, $"{outcome}"));
        Assert.All(Enum.GetValues<NetPlay>(), play => Assert.True(outcomes.Where(outcome => outcome.Play == play).Sum(outcome => outcome.Frames) > 300));
        Assert.True(outcomes.Sum(outcome => outcome.AtEnd) > 20);
        Assert.True(outcomes.Sum(outcome => outcome.Pinned) > 20);
    }

    /// <summary>In these, a ball slides on the end of a net, over its edge and away.</summary>
    [Theory]
    [InlineData(2, 2031)]
    [InlineData(2, 2064)]
    [InlineData(3, 1529)]
    public void A_ball_leaves_the_end_of_a_net_over_its_edge(long seed, long ball)
    {
        NetOutcome outcome = NetDraw.Play(seed, ball);
        Assert.True(outcome.Holds, $"{outcome}");
    }

    [Fact]
    public void The_command_judges_each_play()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "nets", "--count", "20", "--seed", "7");
        Assert.Equal(3, done.Result.GetProperty("tables")[0].GetProperty("rows").GetArrayLength());
        Assert.Equal(0, done.ExitCode);
    }

    /// <summary>What the laboratory must find, it finds.</summary>
    [Theory]
    [InlineData(1e-6, 0.0, true)]
    [InlineData(0.0, 1e-3, true)]
    [InlineData(0.0, 0.0, false)]
    public void A_ball_that_fails_is_judged_so(double beyond, double gain, bool rests) =>
        Assert.False(new NetOutcome(NetPlay.Walked, 1, 1, 0, beyond, gain, rests, 0, "").Holds);
}
