using FootballPhysics.Labs.Pipes;

namespace FootballPhysics.Labs.Tests.Things;

/// <summary>The laboratory of pipes, small: balls that roll into quarter pipes and bowls. Times of steps are not asserted; evaluations are bounded by the flight steps.</summary>
public sealed class PipesLabTests
{
    private static readonly PipeOutcome s_good = new(PipeKind.Pipe, true, 70, [1, 2, 3], 1e-4, 0, 0, "");

    [Fact]
    public void No_path_is_cut_short_and_no_step_has_hundreds_of_pieces()
    {
        PipeOutcome[] outcomes = [.. Enumerable.Range(0, 150).Select(i => PipeDraw.Play(72, i))];
        Assert.All(outcomes, outcome => Assert.True(outcome.Holds && outcome.Steps.Max() <= 250, $"{outcome.Steps.Max()} {outcome}"));
        Assert.All(Enum.GetValues<PipeKind>(), kind => Assert.True(outcomes.Count(outcome => outcome.Kind == kind) > 15));
    }

    [Fact]
    public void The_command_judges_each_shape()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "pipes", "--count", "20", "--seed", "7");
        Assert.Equal(4, done.Result.GetProperty("tables")[0].GetProperty("rows").GetArrayLength());
    }

    /// <summary>What the laboratory must find, it finds.</summary>
    [Fact]
    public void A_ball_that_fails_is_judged_so()
    {
        Assert.True(s_good.Holds);
        Assert.False((s_good with { IsWhole = false }).Holds);
        Assert.False((s_good with { Steps = [31, 31, 31] }).Holds);
        Assert.True(s_good.IsFast);
        Assert.False((s_good with { Slowest = 2e-3 }).IsFast);
        Assert.False((s_good with { Sunk = 1e-6 }).Holds);
    }
}
