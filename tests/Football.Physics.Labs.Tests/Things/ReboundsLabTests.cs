using FootballPhysics.Labs.Rebounds;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Things;

/// <summary>The laboratory of second impacts, small: each impact against an event integrator.</summary>
public sealed class ReboundsLabTests
{
    [Fact]
    public void Each_impact_obeys_the_law_however_soon_it_follows_another()
    {
        ReboundOutcome[] outcomes = [.. Enumerable.Range(0, 400).Select(i => MeetingPlay.Play(new SeededRandom(SeededRandom.Mix(72, i)), i))];
        ReboundOutcome[] judged = [.. outcomes.Where(outcome => outcome.LeftOut == ReboundLeftOut.None)];
        Assert.All(judged, outcome => Assert.True(outcome.Error <= MeetingPlay.Tolerance, outcome.At));
        Assert.InRange(judged.Length, 380, 400);
        Assert.True(judged.Sum(outcome => outcome.Soon) > 300, $"{judged.Sum(outcome => outcome.Soon)}");
    }

    [Fact]
    public void The_command_judges_the_errors_and_the_share_left_out()
    {
        FootballCommand done = FootballCommand.Run("", "lab", "rebounds", "--count", "100", "--seed", "5");
        string?[] verdicts = [.. done.Result.GetProperty("tables")[0].GetProperty("rows").EnumerateArray().Select(row => row.GetProperty("verdict").GetString())];
        Assert.Equal(2, verdicts.Count(verdict => verdict == "reached"));
        Assert.Equal(0, done.ExitCode);
    }
}
