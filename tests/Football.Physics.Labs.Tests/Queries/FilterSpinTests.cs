using FootballPhysics.Labs.Following;
using FootballPhysics.Tracks;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Queries;

/// <summary>Balls that slide or bounce, and whose points fit two spins almost equally well for a while.</summary>
public sealed class FilterSpinTests
{
    /// <summary>The time between two reports of different kicks, in s.</summary>
    private const double Apart = 0.1;

    [Theory]
    [InlineData(1, 25, 0.005)]
    [InlineData(19, 100, 0.005)]
    [InlineData(39, 100, 0.02)]
    [InlineData(107, 100, 0.05)]
    public void A_wrong_spin_is_replaced_and_no_kick_is_reported(int number, double rate, double noise)
    {
        var track = FollowTrack.Simulate(new SeededRandom(SeededRandom.Mix(7702, number)), rate, noise);
        var filter = new BallFilter(track.Scene, new BallFilterSettings { Noise = noise });
        double reported = double.NegativeInfinity;
        int kicks = 0;
        foreach (FollowRow row in track.Rows)
        {
            filter.Update(row.Time, row.Measured);
            BallEstimate estimate = filter.Estimate;
            if (estimate.HasKick && estimate.KickTime - reported > Apart)
            {
                reported = estimate.KickTime;
                kicks++;
                double tolerance = (2 / rate) + 0.05 + (3 * estimate.KickDeviation);
                Assert.Contains(track.Kicks, kick => Math.Abs(kick.Time - reported) < tolerance);
            }
        }

        Assert.InRange(kicks, 1, track.Kicks.Count);
    }
}
