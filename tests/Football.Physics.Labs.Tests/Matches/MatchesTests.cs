using FootballPhysics.Labs.Matches;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Tests.Matches;

/// <summary>Players in time, touches and impacts, a few of each; football lab matches tells of a thousand.</summary>
public sealed class MatchesTests
{
    private const long Seed = 46;

    [Fact]
    public void Late_kicks_among_moving_players_end_where_kicks_in_time_do() => Holds(progress => RollbackCounts.Table(Seed, 4, progress));

    [Fact]
    public void A_dribbled_ball_stays_before_the_player() => Holds(progress => DribbleCounts.Table(Seed, 20, progress));

    [Fact]
    public void A_first_time_shot_hits_where_it_is_said_to() => Holds(progress => FirstTimeCounts.Table(Seed, 20, progress));

    [Fact]
    public void A_trapped_ball_is_dead() => Holds(progress => TrapCounts.Table(Seed, 20, progress));

    [Fact]
    public void A_million_impacts_keep_momentum_and_gain_no_energy() => Holds(progress => ImpactBalances.Table(Seed, 1_000_000, progress));

    private static void Holds(Func<Progress, (LabTable Table, bool Holds)> play)
    {
        (LabTable table, bool holds) = Progress.Show(new Terminal(Stream.Null, Stream.Null, Stream.Null, outputRedirected: true, errorRedirected: true), "test", play);
        Assert.True(holds, table.Name);
    }
}
