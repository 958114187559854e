using FootballPhysics.Labs.Forces;

namespace FootballPhysics.Labs.Tests.Forces;

/// <summary>The laboratory of custom forces, small.</summary>
public sealed class ForcesLabTests
{
    [Theory]
    [InlineData(1, 30)]
    [InlineData(30, 300)]
    [InlineData(300, 3000)]
    public void Forces_are_followed_or_counted(double low, double high)
    {
        ForceOutcome[] outcomes = [.. Enumerable.Range(0, 70).Select(i => ForceDraw.Play(72, i, low, high))];
        Assert.All(outcomes, outcome => Assert.True(outcome.Holds, $"{outcome}"));
        Assert.Equal(Enum.GetValues<ForceKind>().Length, outcomes.Select(outcome => outcome.Kind).Distinct().Count());
    }

    [Fact]
    public void The_command_judges_each_force()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "forces", "--count", "7", "--looks", "20", "--seed", "7");
        Assert.Equal(2, done.Result.GetProperty("tables").GetArrayLength());
        Assert.Equal(4, done.Result.GetProperty("tables")[1].GetProperty("rows").GetArrayLength());
        Assert.Equal(0, done.ExitCode);
    }

    /// <summary>What the laboratory must find, it finds.</summary>
    [Theory]
    [InlineData(100, 0.004, 0.0, 0)]
    [InlineData(100, 0.0, 0.004, 0)]
    [InlineData(100, 0.0, 0.0, 1)]
    [InlineData(1000, 0.004, 0.0, 0)]
    [InlineData(1000, double.NaN, 0.0, 1)]
    public void A_force_that_fails_is_judged_so(double stiffness, double error, double lookError, long stiff) =>
        Assert.False(new ForceOutcome(ForceKind.Spring, stiffness, error, lookError, stiff, 0, 4, 1).Holds);
}
