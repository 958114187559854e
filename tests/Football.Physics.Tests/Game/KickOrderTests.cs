using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Game;

/// <summary>The order of kicks, against a sorted list; and kicks that are for no ball.</summary>
public sealed class KickOrderTests
{
    /// <summary>Kicks added, replaced and taken out at random: the log has those of a sorted dictionary.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void A_log_has_its_kicks_in_order_whatever_is_added_and_taken_out(int seed)
    {
        var log = new KickLog(1);
        var expected = new SortedDictionary<(long Tick, int Player, int Ball), double>();
        int draw = 0;
        int Below(int count) => (int)(count * SplitMix64.At(seed, draw++));
        for (int i = 0; i < 4000; i++)
        {
            (long Tick, int Player, int Ball) key = (Below(60), Below(9), Below(3));
            switch (Below(40))
            {
                case 0:
                    log.RemoveBefore(key.Tick / 4);
                    foreach ((long Tick, int Player, int Ball) gone in expected.Keys.Where(one => one.Tick < key.Tick / 4).ToList())
                    {
                        expected.Remove(gone);
                    }

                    break;
                case 1:
                    long from = 50 + (key.Tick / 4);
                    log.RemoveFrom(from);
                    foreach ((long Tick, int Player, int Ball) gone in expected.Keys.Where(one => one.Tick >= from).ToList())
                    {
                        expected.Remove(gone);
                    }

                    break;
                case < 15:
                    Assert.Equal(expected.Remove(key), log.Remove(key.Tick, key.Player, key.Ball));
                    break;
                default:
                    log.Add(new KickInput(key.Tick, new Vector3d(i % 100, 0, 0), default, key.Player, key.Ball));
                    expected[key] = i % 100;
                    break;
            }

            Assert.Equal(expected.Count, log.Count);
            Assert.Equal(expected.Keys.Count(one => one.Tick < key.Tick), log.FirstAt(key.Tick));
        }

        int place = 0;
        foreach (KeyValuePair<(long Tick, int Player, int Ball), double> one in expected)
        {
            KickInput kick = log[place++];
            Assert.Equal(one.Key, (kick.Tick, kick.Player, kick.Ball));
            Assert.Equal(one.Value, kick.Velocity.X);
        }

        Assert.Equal(log.ToBytes(), KickLog.FromBytes(log.ToBytes()).ToBytes());
        log.Clear();
        Assert.Equal(0, log.Count);
    }

    /// <summary>A hundred thousand kicks of one tick in falling order: with the number squared this test would take minutes.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    public void Kicks_of_one_tick_are_in_order_however_many_arrive_in_whatever_order(int direction)
    {
        const int Count = 100_000;
        var log = new KickLog();
        for (int i = 0; i < Count; i++)
        {
            log.Add(new KickInput(5, new Vector3d(0, 1, -1), default, direction > 0 ? i : Count - 1 - i));
        }

        Assert.Equal(Count, log.Count);
        for (int i = 0; i < Count; i += 997)
        {
            Assert.Equal(i, log[i].Player);
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void A_kick_for_a_ball_that_there_is_not_is_refused_when_it_arrives(int balls)
    {
        var simulator = new Simulator();
        FixedStepRunner runner = balls == 1 ? new FixedStepRunner(simulator) : new FixedStepRunner(new BallGroup(simulator, balls));
        runner.Kicks.Add(new KickInput(3, new Vector3d(0, 1, -4), default, ball: balls - 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.Kicks.Add(new KickInput(3, new Vector3d(0, 1, -4), default, ball: balls)));
        Assert.Equal(1, runner.Kicks.Count);
        for (int i = 0; i < 10; i++)
        {
            runner.Step();
        }

        Assert.NotEqual(MotionState.Rest, runner.StateOf(balls - 1).Motion);
    }

    /// <summary>A segment whose kicks are for a ball that it does not have is broken.</summary>
    [Fact]
    public void A_segment_with_a_kick_for_no_ball_of_its_own_is_refused()
    {
        byte[] Segment(int ball)
        {
            var runner = new FixedStepRunner(new BallGroup(new Simulator(), 2));
            Recording segment = runner.Record();
            runner.Kicks.Add(new KickInput(3, new Vector3d(0, 1, -4), default, ball: 1));
            for (int i = 0; i < 10; i++)
            {
                runner.Step();
            }

            // The ball of the only kick is one byte, after its two of forms; the rest of the bytes is the same.
            byte[] bytes = segment.ToBytes();
            int place = -1;
            for (int i = 0; i + 2 < bytes.Length && place < 0; i++)
            {
                byte[] other = (byte[])bytes.Clone();
                if (bytes[i] == 1)
                {
                    other[i] = 7;
                    Crc32.Seal(other);
                    try
                    {
                        Recording.FromBytes(other);
                    }
                    catch (FormatException refusal) when (refusal.Message.Contains("a ball is kicked", StringComparison.Ordinal))
                    {
                        place = i;
                    }
                    catch (FormatException)
                    {
                        // Another field.
                    }
                }
            }

            Assert.True(place > 0);
            bytes[place] = (byte)ball;
            Crc32.Seal(bytes);
            return bytes;
        }

        Assert.Equal(2, Recording.FromBytes(Segment(1)).Balls);
        Assert.Throws<FormatException>(() => Recording.FromBytes(Segment(2)));
    }

    [Fact]
    public void A_kick_of_new_vectors_is_a_velocity_and_a_spin()
    {
        var runner = new FixedStepRunner();
        runner.QueueKick(new(0, 1, 2), default);
        Assert.Equal(new Vector3d(0, 1, 2), runner.Kicks[0].Velocity);
        var ball = new Ball();
        ball.Kick(new(0, 1, 2), default);
        Assert.Equal(new Vector3d(0, 1, 2), ball.Velocity);
    }
}
