using FootballPhysics.Labs.Motions;

namespace FootballPhysics.Labs.Tests.Things;

/// <summary>The laboratory of changes of motions, small, and its judgement of single steps.</summary>
public sealed class MotionsLabTests
{
    [Fact]
    public void Each_change_has_an_event()
    {
        MotionOutcome[] outcomes = [.. Enumerable.Range(0, 200).Select(i => MotionDraw.Play(71, i))];
        Assert.All(outcomes, outcome => Assert.Equal("", outcome.Missing > 0 ? outcome.First : ""));
        Assert.True(outcomes.Sum(outcome => outcome.Changes) > 300);
        Assert.Equal(6, outcomes.Select(outcome => outcome.Kind).Distinct().Count());
    }

    /// <summary>In these, a roll was pressed onto the ground and slid, or a ball woke, without an event.</summary>
    [Theory]
    [InlineData(1, 300)]
    [InlineData(1, 306)]
    [InlineData(1, 604)]
    [InlineData(2, 3702)]
    public void These_have_theirs(long seed, long scene) => Assert.Equal(0, MotionDraw.Play(seed, scene).Missing);

    [Fact]
    public void The_command_judges_each_kind()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "motions", "--count", "60", "--seed", "7");
        Assert.Equal(6, done.Result.GetProperty("tables")[0].GetProperty("rows").GetArrayLength());
        Assert.Equal(0, done.ExitCode);
    }

    /// <summary>An impact explains a flight, but no slide; the last event names the motion.</summary>
    [Theory]
    [InlineData(MotionState.Rolling, MotionState.Sliding, false, BallEventKind.Impact)]
    [InlineData(MotionState.Rolling, MotionState.Sliding, true, BallEventKind.Impact, BallEventKind.Slide)]
    [InlineData(MotionState.Rolling, MotionState.Airborne, true, BallEventKind.Impact)]
    [InlineData(MotionState.Rolling, MotionState.Airborne, false)]
    [InlineData(MotionState.Airborne, MotionState.Rolling, false, BallEventKind.Roll, BallEventKind.Slide)]
    [InlineData(MotionState.Rest, MotionState.Airborne, true, BallEventKind.ContactEnd)]
    [InlineData(MotionState.Rolling, MotionState.Rolling, true)]
    public void A_step_is_judged_by_its_last_event(MotionState before, MotionState after, bool explained, params BallEventKind[] kinds)
    {
        var buffer = new EventBuffer();
        foreach (BallEventKind kind in kinds)
        {
            buffer.Add(new BallEvent(kind, 0, default, 0, default, default, default, default, default));
        }

        Assert.Equal(explained, MotionDraw.Explains(new BallState { Motion = before }, new BallState { Motion = after }, buffer, 0));
    }
}
