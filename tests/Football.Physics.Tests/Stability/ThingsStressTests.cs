using Football.Physics.Headless.Lab.Stability.Things;

namespace Football.Physics.Tests.Stability;

/// <summary>A few of the scenes of football lab stability --things.</summary>
public sealed class ThingsStressTests
{
    private const int Seed = 2;
    private const int Scenes = 60;

    [Fact]
    public void Every_invariant_holds_among_obstacles_bodies_nets_and_slopes()
    {
        ThingsRun[] runs = [.. Enumerable.Range(0, Scenes).Select(index => ThingsRun.Play(Seed, index))];
        Assert.Equal([], runs.Select((run, i) => run.Failure is { } failure ? $"scene {i}, {run.Kind}: {failure.Check}, {failure.Detail}" : "").Where(text => text.Length > 0));
        Assert.True(runs.Sum(run => run.Impacts) > 2 * Scenes, $"{runs.Sum(run => run.Impacts)} impacts");
        Assert.True(runs.Sum(run => run.InNets) > 5, $"{runs.Sum(run => run.InNets)} frames in nets");
    }
}
