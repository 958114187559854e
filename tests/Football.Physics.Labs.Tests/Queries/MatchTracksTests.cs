using FootballPhysics.Labs.Play;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Queries;

/// <summary>Simulated minutes and damaged files, a few of each; football lab play --matches 1000 --damaged 10000 tells of more.</summary>
public sealed class MatchTracksTests
{
    [Fact]
    public void Flights_of_a_simulated_minute_are_found_and_the_truth_is_where_the_fit_says()
    {
        var check = new SyntheticCheck();
        for (int i = 0; i < 2; i++)
        {
            check.Run(SyntheticMatch.Play(new SeededRandom(SeededRandom.Mix(1, i)), noise: 0.005));
        }

        Assert.InRange(check.Counts.Percent("flights found", "flights"), 95, 100);
        Assert.InRange(check.Counts.Percent("impacts found", "impacts"), 90, 100);
        Assert.InRange(check.Counts.Percent("launches within", "launches"), 80, 100);
    }

    [Fact]
    public void Damaged_files_are_fitted_or_refused()
    {
        var check = new DamagedTracks();
        SyntheticMatch match = SyntheticMatch.Play(new SeededRandom(5L), noise: 0.01);
        for (int i = 0; i < 60; i++)
        {
            check.Run(new SeededRandom(SeededRandom.Mix(5, i)), match);
        }

        Assert.Empty(check.Faults);
        Assert.True(check.Counts["fitted"] > 0 && check.Counts["refused by the reader"] > 0);
    }
}
