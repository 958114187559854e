using FsCheck;
using FsCheck.Fluent;

namespace FootballPhysics.Tests.Game;

public sealed class RollbackTests
{
    private const int Ticks = 180;

    private static Gen<(Simulator Simulator, KickInput[] Kicks)> Matches =>
        from simulator in Inputs.Simulators
        from kicks in Inputs.Kicks(Ticks)
        select (simulator, kicks);

    [Fact]
    public void Rewinding_at_random_gives_identical_bytes()
    {
        var plays =
            from match in Matches
            from moves in (from steps in Gen.Choose(1, 40) from back in Gen.Choose(0, 60) select (steps, back)).ListOf(30)
            select (match, moves);
        Prop.ForAll(plays.ToArbitrary(), play =>
        {
            BallState[] expected = Inputs.Play(Inputs.Runner(play.match.Simulator, play.match.Kicks), Ticks);
            FixedStepRunner runner = Inputs.Runner(play.match.Simulator, play.match.Kicks);
            var saved = new BallState[Ticks + 1];
            saved[0] = runner.State;
            foreach ((int steps, int back) in play.moves)
            {
                for (int i = 0; i < steps && runner.Tick < Ticks; i++)
                {
                    runner.Step();
                    saved[runner.Tick] = runner.State;
                    Assert.True(Snapshot.Same(expected[runner.Tick], runner.State), $"tick {runner.Tick}");
                    Assert.Equal(Bytes(expected[runner.Tick]), Bytes(runner.State));
                }

                long tick = Math.Max(0, runner.Tick - back);
                runner.Restore(tick, saved[tick]);
            }
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void Kicks_that_arrive_late_and_in_any_order_end_in_the_same_state()
    {
        var plays =
            from match in Matches
            from order in Gen.Shuffle(match.Kicks)
            from late in Gen.Choose(0, 20).ArrayOf(match.Kicks.Length)
            select (match, order, late);
        Prop.ForAll(plays.ToArbitrary(), play =>
        {
            KickInput[] distinct = [.. play.order.DistinctBy(k => (k.Tick, k.Player))];
            BallState expected = Inputs.Play(Inputs.Runner(play.match.Simulator, distinct), Ticks)[Ticks];

            FixedStepRunner runner = Inputs.Runner(play.match.Simulator, []);
            var saved = new BallState[Ticks + 1];
            for (int now = 0; now <= Ticks; now++)
            {
                for (int i = 0; i < distinct.Length; i++)
                {
                    KickInput kick = distinct[i];
                    if (Math.Min(kick.Tick + play.late[i], Ticks) == now)
                    {
                        runner.Kicks.Add(kick);
                        if (kick.Tick < runner.Tick)
                        {
                            runner.Restore(kick.Tick, saved[kick.Tick]);
                            Catch(runner, now, saved);
                        }
                    }
                }

                saved[runner.Tick] = runner.State;
                if (now < Ticks)
                {
                    runner.Step();
                }
            }

            Assert.True(Snapshot.Same(expected, runner.State));
        }).QuickCheckThrowOnFailure();

        static void Catch(FixedStepRunner runner, int now, BallState[] saved)
        {
            while (runner.Tick < now)
            {
                saved[runner.Tick] = runner.State;
                runner.Step();
            }
        }
    }

    [Fact]
    public void A_recorded_segment_replays_to_the_bit_also_from_its_bytes()
    {
        var plays = from match in Matches from start in Gen.Choose(0, Ticks / 2) select (match, start);
        Prop.ForAll(plays.ToArbitrary(), play =>
        {
            Recording segment = Record(play.match.Simulator, play.match.Kicks, play.start);
            Assert.Equal(play.start, segment.StartTick);
            Assert.Equal(Ticks, segment.EndTick);
            Assert.Null(segment.FirstDivergence(play.match.Simulator));

            byte[] bytes = segment.ToBytes();
            var again = Recording.FromBytes(bytes);
            Assert.Null(again.FirstDivergence(play.match.Simulator));
            Assert.Equal(bytes, again.ToBytes());
            Assert.Equal(segment.HashAt(Ticks), again.HashAt(Ticks));
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void The_first_tick_that_diverges_is_named()
    {
        var plays =
            from match in Matches
            from extra in Inputs.Kick(Ticks)
            where match.Kicks.All(k => k.Tick != extra.Tick)
            select (match, extra);
        Prop.ForAll(plays.ToArbitrary(), play =>
        {
            BallState[] left = Inputs.Play(Inputs.Runner(play.match.Simulator, play.match.Kicks), Ticks);
            BallState[] right = Inputs.Play(Inputs.Runner(play.match.Simulator, [.. play.match.Kicks, play.extra]), Ticks);
            int first = Enumerable.Range(0, Ticks + 1).FirstOrDefault(t => !Snapshot.Same(left[t], right[t]), -1);

            Recording segment = Record(play.match.Simulator, play.match.Kicks, 0);
            segment.Kicks.Add(play.extra);
            Assert.Equal(first < 0 ? null : first, segment.FirstDivergence(play.match.Simulator));
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void Another_scene_is_told_to_be_another()
    {
        KickInput[] kicks = [new(20, new Vector3d(2, 6, -20), new Vector3d(0, 30, 0))];
        Recording segment = Record(new Simulator(Scene.Published), kicks, 0);
        var windy = new Simulator(Scene.Published with { Air = new Air { Wind = new Vector3d(0, 0, 1) } });
        Assert.StartsWith("The scene differs from the recorded one (balls 1, hash ", Assert.Throws<ArgumentException>(() => segment.FirstDivergence(windy)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_rollback_rewinds_the_recording_and_a_foreign_state_ends_it()
    {
        var runner = new FixedStepRunner();
        runner.QueueKick(new Vector3d(2, 6, -20), new Vector3d(0, 30, 0));
        Recording segment = runner.Record();
        BallState[] states = Inputs.Play(runner, 50);
        runner.Restore(30, states[30]);
        Assert.Same(segment, runner.Recording);
        Assert.Equal(30, segment.EndTick);
        runner.QueueKick(new Vector3d(-8, 3, 0), Vector3d.Zero);
        Inputs.Play(runner, 40);
        Assert.Equal(70, segment.EndTick);
        Assert.Null(segment.FirstDivergence(runner.Simulator));

        runner.Restore(40, states[40]);
        Assert.Null(runner.Recording);
        Assert.Null(segment.FirstDivergence(runner.Simulator));
    }

    [Fact]
    public void Broken_bytes_are_refused_whatever_is_broken()
    {
        KickInput[] kicks = [new(3, new Vector3d(2.5, 6, -20), new Vector3d(0, 30.1, 0)), new(9, new Vector3d(1, 2, 3), Vector3d.Zero, 2)];
        byte[] bytes = Record(new Simulator(Scene.Published), kicks, 0).ToBytes();
        for (int length = 0; length < bytes.Length; length++)
        {
            Assert.Throws<FormatException>(() => Recording.FromBytes(bytes.AsSpan(0, length)));
        }

        Assert.Throws<FormatException>(() => Recording.FromBytes([.. bytes, 0]));
        var random = new Random(1);
        int refused = 0;
        for (int i = 0; i < 20_000; i++)
        {
            byte[] broken = [.. bytes];
            broken[random.Next(Math.Min(broken.Length, 300))] = (byte)random.Next(256);
            try
            {
                Recording.FromBytes(broken);
            }
            catch (FormatException)
            {
                // the one thing that may happen
                refused++;
            }
        }

        Assert.InRange(refused, 2_000, 20_000);
    }

    private static Recording Record(Simulator simulator, KickInput[] kicks, int start)
    {
        FixedStepRunner runner = Inputs.Runner(simulator, kicks);
        Inputs.Play(runner, start);
        Recording segment = runner.Record();
        Inputs.Play(runner, Ticks - start);
        return segment;
    }

    private static byte[] Bytes(BallState state)
    {
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(state, bytes);
        return bytes;
    }
}
