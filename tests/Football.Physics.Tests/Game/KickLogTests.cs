using FsCheck;
using FsCheck.Fluent;

namespace FootballPhysics.Tests.Game;

public sealed class KickLogTests
{
    [Fact]
    public void It_is_sorted_whatever_the_order_of_arrival_and_the_last_word_of_a_player_counts()
    {
        Prop.ForAll(Inputs.Kicks(6).ToArbitrary(), kicks =>
        {
            var log = new KickLog(1);
            foreach (KickInput kick in kicks)
            {
                log.Add(kick);
            }

            var expected = kicks.GroupBy(k => (k.Tick, k.Player)).OrderBy(g => g.Key).Select(g => g.Last()).ToList();
            Assert.Equal(expected, Enumerable.Range(0, log.Count).Select(i => log[i]));
            for (int tick = 0; tick <= 6; tick++)
            {
                Assert.Equal(expected.Count(k => k.Tick < tick), log.FirstAt(tick));
            }
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void Its_bytes_come_back_as_it()
    {
        Prop.ForAll(Inputs.Kicks(100_000).ToArbitrary(), kicks =>
        {
            var log = new KickLog();
            foreach (KickInput kick in kicks)
            {
                log.Add(kick);
            }

            byte[] bytes = log.ToBytes();
            var again = KickLog.FromBytes(bytes);
            Assert.Equal(Enumerable.Range(0, log.Count).Select(i => log[i]), Enumerable.Range(0, again.Count).Select(i => again[i]));
            Assert.Equal(bytes, again.ToBytes());
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void A_kick_of_single_precision_numbers_takes_28_bytes_and_the_log_5()
    {
        var log = new KickLog();
        log.Add(new KickInput(100, new System.Numerics.Vector3(1.1f, 2.2f, -20.3f), new System.Numerics.Vector3(3.3f, 40.4f, 0.5f)));
        Assert.Equal(5 + 28, log.ToBytes().Length);
    }

    [Fact]
    public void Kicks_can_be_taken_out_and_forgotten()
    {
        var log = new KickLog();
        for (int tick = 0; tick < 10; tick++)
        {
            log.Add(new KickInput(tick, Vector3d.Up, Vector3d.Zero));
        }

        Assert.True(log.Remove(4));
        Assert.False(log.Remove(4));
        Assert.False(log.Remove(5, player: 1));
        log.RemoveBefore(6);
        Assert.Equal(4, log.Count);
        Assert.Equal(6, log[0].Tick);
        log.Clear();
        Assert.Equal(0, log.Count);
        Assert.Throws<ArgumentOutOfRangeException>(() => log[0]);
    }

    [Fact]
    public void Kicks_out_of_range_are_refused()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => new KickInput(-1, Vector3d.Up, Vector3d.Zero));
        Assert.Throws<ArgumentOutOfRangeException>(() => new KickInput(0, Vector3d.Up, Vector3d.Zero, -1));
        Assert.Throws<ArgumentOutOfRangeException>(() => new KickInput(0, new Vector3d(double.NaN, 0, 0), Vector3d.Zero));
        Assert.Throws<ArgumentOutOfRangeException>(() => new KickInput(0, Vector3d.Up, new Vector3d(0, 10_001, 0)));
        Assert.Throws<ArgumentOutOfRangeException>(() => new KickLog(0));
    }
}
