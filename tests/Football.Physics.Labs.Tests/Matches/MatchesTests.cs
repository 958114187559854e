using FootballPhysics.Labs.Matches;
using FootballPhysics.Labs.Peers;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Tests.Matches;

/// <summary>Players in time, touches and impacts, a few of each; football lab matches tells of a thousand.</summary>
public sealed class MatchesTests
{
    private const long Seed = 46;

    [Fact]
    public void Late_kicks_among_moving_players_end_where_kicks_in_time_do() => Holds(run => RollbackCounts.Play(run, 4));

    [Fact]
    public void Two_peers_over_a_bad_line_agree_on_the_ball_and_the_score()
    {
        LabRun run = Holds(run => PeersLab.Play(run, 16));
        long Count(string what) => (long)run.Tables[0].Rows.Single(row => what.Equals(row[0]))[1]!;
        Assert.All(["kicks", "restarts", "goals that count", "late inputs", "inputs that came again", "lost", "doubled", "inputs 16 to 20 ticks late"], what => Assert.True(Count(what) > 0, what));
    }

    [Fact]
    public void A_dribbled_ball_stays_before_the_player() => Holds(run => new TouchCounts(run, 20).Dribbles());

    [Fact]
    public void A_first_time_shot_hits_where_it_is_said_to() => Holds(run => new TouchCounts(run, 20).FirstTimeShots());

    [Fact]
    public void A_trapped_ball_is_dead() => Holds(run => new TouchCounts(run, 20).Traps());

    [Fact]
    public void A_million_impacts_keep_momentum_and_gain_no_energy() => Holds(run => ImpactBalances.Play(run, 1_000_000));

    private static LabRun Holds(Action<LabRun> play)
    {
        LabRun run = Progress.Show(new Terminal(Stream.Null, Stream.Null, Stream.Null, outputRedirected: true, errorRedirected: true), "test", progress =>
        {
            var run = new LabRun("test", Seed, progress);
            play(run);
            return run;
        });
        Assert.False(run.Failed, string.Join('\n', [run.Tables[0].Name, .. run.Notes]));
        return run;
    }
}
