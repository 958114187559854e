using FootballPhysics.Labs.Stability;
using FootballPhysics.Labs.Stability.Things;

namespace FootballPhysics.Labs.Tests.Stability;

/// <summary>A few of the scenes of football lab stability --things.</summary>
public sealed class ThingsStressTests
{
    private const int Seed = 2;
    private const int Scenes = 60;

    [Fact]
    public void Every_invariant_holds_among_obstacles_bodies_nets_and_slopes()
    {
        StressOutcome[] runs = [.. Enumerable.Range(0, Scenes).Select(index => ThingsRun.Play(Seed, index))];
        Assert.Equal([], runs.Select((run, i) => run.Failure is { } failure ? $"scene {i}, {run.Kind}: {failure.Check}, {failure.Detail}" : "").Where(text => text.Length > 0));
        Assert.True(runs.Sum(run => run.Tally.Impacts) > 2 * Scenes, $"{runs.Sum(run => run.Tally.Impacts)} impacts");
        Assert.True(runs.Sum(run => run.Tally.InNets) > 5, $"{runs.Sum(run => run.Tally.InNets)} frames in nets");
    }

    /// <summary>Scenes that the laboratory has found to break an invariant once, and what was wrong then.</summary>
    [Theory]
    [InlineData(1, 1793, "a flight pressed onto uneven ground went off it in one long piece")]
    [InlineData(1, 2038, "beyond the edge of a box the acceleration is no end of the path to it")]
    [InlineData(1, 3161, "a step of first order went astray along curved ground")]
    [InlineData(2, 2599, "the same over the end of a capsule")]
    [InlineData(2, 4463, "a roll over an edge ended before the edge, by rounding, again and again")]
    [InlineData(2, 10757, "on curved ground a wall let a ball go which it guides, and caught it again at once")]
    [InlineData(2, 27695, "the same, with a method of first order")]
    [InlineData(2, 18743, "semi-implicit Euler falls twice as far in a step as was taken for clear")]
    [InlineData(2, 25577, "put back onto the ground the ball was in the wall that it met")]
    [InlineData(2, 26729, "put out of the wall the ball was in the ground")]
    [InlineData(3, 3988, "four walls touched at once, of which two are one: the fourth was forgotten")]
    [InlineData(3, 22421, "a ball that leaves slower than gravity takes it back was hit again and again")]
    [InlineData(3, 48907, "the same between a wall that carries the ball and the ground")]
    [InlineData(4, 24019, "in a sharp corner the ball was put out of one surface into the other")]
    [InlineData(8, 58601, "put back onto the ground a ball was in the wall that it was just leaving")]
    [InlineData(201, 70241, "put back onto a slope a flight was in the wall that it had just left")]
    [InlineData(201, 95681, "put back onto a post that it slid along, a flight was in the ground")]
    [InlineData(203, 84824, "two limits ended at one edge, the second before it: pieces without length")]
    [InlineData(301, 1862, "wedged between a body and the ground it was hit for ever")]
    [InlineData(301, 50744, "a step that was watched had used up its evaluations sooner")]
    [InlineData(302, 109238, "in a narrow groove too few rounds put it onto both sides")]
    public void What_the_laboratory_found_once_holds(int seed, int index, string wrong)
    {
        StressOutcome run = ThingsRun.Play(seed, index);
        Assert.True(run.Failure is null, $"{wrong}: {run.Failure?.Check}, {run.Failure?.Detail}");
    }
}
