using FootballPhysics.Labs.Following;
using FootballPhysics.Tracks;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Queries;

/// <summary>The work of a point of the live filter, on streams in which kicks are sought while the ball begins to roll.</summary>
public sealed class FilterWorkTests
{
    /// <summary>The limit of the specification, in flight steps. Without a cut, a point of these streams takes 6900 to 9400.</summary>
    private const double Most = 6000;

    [Theory]
    [InlineData(10, 0.05)]
    [InlineData(87, 0.1)]
    [InlineData(129, 0.02)]
    [InlineData(168, 0.005)]
    public void No_point_exceeds_the_limit_of_its_work(int number, double noise)
    {
        var track = FollowTrack.Simulate(new SeededRandom(SeededRandom.Mix(6, 900_000 + number)), 100, noise);
        var filter = new BallFilter(track.Scene, new BallFilterSettings { Noise = noise });
        double worst = 0;
        foreach (FollowRow row in track.Rows)
        {
            filter.Update(row.Time, row.Measured);
            worst = Math.Max(worst, filter.Work);
        }

        Assert.InRange(worst, 1, Most);
    }
}
