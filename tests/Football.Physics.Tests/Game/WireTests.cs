namespace FootballPhysics.Tests.Game;

/// <summary>A state in 24 bytes: what rounding changes, that bytes are then the state itself, and that everybody who plays the match has the same bits.</summary>
public sealed class WireTests
{
    private const double Step = 1.0 / 60;

    /// <summary>What <see cref="FixedStepRunner.QuantizationInterval"/> says of each direction: m, m/s, rad/s; a ball that rolls has the spin of its velocity.</summary>
    private static readonly (double Place, double Speed, double Spin, double RollingSpin, double Angle) s_told = (0.5e-3, 1e-3, 0.125, 0.01, 2.5 * Math.PI / 180);

    [Fact]
    public void A_state_comes_back_to_the_last_bit_and_rounding_changes_no_more_than_told()
    {
        int written = 0;
        var worst = default((double Place, double Speed, double Spin, double Angle));
        foreach ((Simulator simulator, BallState state) in States(20_000))
        {
            FixedStepRunner runner = RoundedAtOnce(simulator, state, out BallState before);
            BallState rounded = runner.State;
            var bytes = new byte[Snapshot.QuantizedSize];
            if (!runner.TryWriteQuantized(rounded, bytes))
            {
                // Its clock alone is rounded.
                Assert.Equal(before.Time, rounded.Time, 1e-9);
                before.Time = rounded.Time;
                Assert.True(Snapshot.Same(before, rounded));
                continue;
            }

            // The bytes are the state, and those of what was read are the same.
            written++;
            BallState read = runner.ReadQuantized(bytes);
            Assert.True(Snapshot.Same(rounded, read));
            var again = new byte[Snapshot.QuantizedSize];
            Assert.True(runner.TryWriteQuantized(read, again));
            Assert.Equal(bytes, again);
            simulator.Validate(in read);

            Assert.Equal(before.Motion, rounded.Motion);
            Assert.Equal(before.Time, rounded.Time, 1e-9);
            Vector3d moved = rounded.Position - before.Position;

            // Just above the ground it is put up, not into it.
            bool isLow = before.Position.Y - simulator.ContactHeight < 1e-3;
            Assert.InRange(moved.Y, -s_told.Place, isLow ? 2 * s_told.Place : s_told.Place);
            worst.Place = Math.Max(worst.Place, Largest(moved.Horizontal));
            worst.Speed = Math.Max(worst.Speed, Largest(rounded.Velocity - before.Velocity));
            Vector3d spun = rounded.Spin - before.Spin;
            worst.Spin = Math.Max(worst.Spin, rounded.Motion == MotionState.Rolling ? Math.Abs(spun.Y) : Largest(spun));
            Assert.InRange(rounded.Motion == MotionState.Rolling ? Largest(spun.Horizontal) : 0, 0, s_told.RollingSpin);
            worst.Angle = Math.Max(worst.Angle, Angle(before.Orientation, rounded.Orientation));
        }

        Assert.InRange(written, 18_000, 20_000);
        Assert.InRange(worst.Place, 0.9 * s_told.Place, s_told.Place);
        Assert.InRange(worst.Speed, 0.9 * s_told.Speed, s_told.Speed);
        Assert.InRange(worst.Spin, 0.9 * s_told.Spin, s_told.Spin);
        Assert.InRange(worst.Angle, 0.5 * s_told.Angle, s_told.Angle);
    }

    [Fact]
    public void What_rests_and_what_is_rounded_stays()
    {
        var runner = new FixedStepRunner(timeStep: Step) { QuantizationInterval = 1 };
        runner.QueueKick(speed: 12, direction: new Vector3d(0.3, 0.2, -1), topSpin: 20, sideSpin: 10);
        var bytes = new byte[Snapshot.QuantizedSize];
        for (int tick = 0; tick < 1500; tick++)
        {
            runner.Step();
            Assert.True(runner.TryWriteQuantized(runner.State, bytes), $"tick {tick}");
            Assert.True(Snapshot.Same(runner.State, runner.ReadQuantized(bytes)));
        }

        Assert.Equal(MotionState.Rest, runner.Motion);
        Vector3d at = runner.State.Position;
        for (int tick = 0; tick < 100; tick++)
        {
            runner.Step();
        }

        Assert.Equal(at, runner.State.Position);
    }

    /// <summary>Rotations with two parts of nearly the same size are written without loss too.</summary>
    [Fact]
    public void A_rotation_with_two_largest_parts_is_rounded_to_one_that_can_be_written()
    {
        var random = new Random(5);
        var runner = new FixedStepRunner(timeStep: Step) { QuantizationInterval = 1 };
        var bytes = new byte[Snapshot.QuantizedSize];
        for (int i = 0; i < 20_000; i++)
        {
            double large = 0.5 + (0.2 * random.NextDouble());
            double near = large + (0.02 * (random.NextDouble() - 0.5));
            double[] parts = [large, near, random.NextDouble() - 0.5, random.NextDouble() - 0.5];
            random.Shuffle(parts);
            BallState state = runner.State;
            state.BaseOrientation = new Quaterniond(parts[0], parts[1], parts[2], parts[3]).Normalized();
            runner.Restore(runner.Tick, state);
            runner.Step();
            Assert.True(runner.TryWriteQuantized(runner.State, bytes), $"{i}: {state.BaseOrientation}");
        }
    }

    /// <summary>Without lots a decay of less than half a unit from one tick to the next would never be seen.</summary>
    [Fact]
    public void A_slow_decay_of_the_spin_is_kept_in_the_mean()
    {
        BallState[] ends = [.. new[] { 0, 1 }.Select(wireTicks =>
        {
            var runner = new FixedStepRunner(new Simulator(Scene.Default with { Gravity = 0 }), Step) { QuantizationInterval = wireTicks };
            runner.Restore(0, runner.Simulator.Launch(new Vector3d(0, 20, 0), new Vector3d(0, 0, -20), new Vector3d(0, 30, 0)));
            while (runner.Tick < 180)
            {
                runner.Step();
            }

            return runner.State;
        })];
        double decay = 30 - ends[0].Spin.Y;
        Assert.InRange(decay, 1, 10);
        Assert.InRange(30 - ends[1].Spin.Y, decay - 0.8, decay + 0.8);
        Assert.InRange((ends[0].Position - ends[1].Position).Length, 0, 0.1);
    }

    [Fact]
    public void Who_plays_with_what_was_read_has_the_same_bits_and_so_has_who_rolls_back_and_who_plays_a_segment_again()
    {
        FixedStepRunner server = Match();
        Recording segment = server.Record();
        FixedStepRunner client = Match();
        var rollback = new Rollback(client, 64);
        var late = new KickInput(150, new Vector3d(-3, 4, 11), new Vector3d(0, 20, 5), 2);
        server.Kicks.Add(in late);
        FixedStepRunner guest = Match();
        guest.Kicks.Add(in late);
        var bytes = new byte[Snapshot.QuantizedSize];
        int sent = 0;
        while (server.Tick < 600)
        {
            server.Step();
            client.Step();
            if (client.Tick == 180)
            {
                Assert.Equal(151, rollback.ApplyKick(in late));
            }

            if (server.Tick % server.QuantizationInterval == 0 && server.TryWriteQuantized(server.State, bytes))
            {
                // A guest who knows nothing of the ball but these bytes plays on from them.
                sent++;
                guest.Restore(server.Tick, guest.ReadQuantized(bytes));
            }
            else
            {
                guest.Step();
            }

            Assert.True(server.Tick < 12 || server.Tick == 151 || Snapshot.Same(server.State, guest.State), $"tick {server.Tick}");
            Assert.True(server.Tick is > 150 and < 180 || Snapshot.Same(server.State, client.State), $"tick {server.Tick}");
        }

        Assert.InRange(sent, 80, 100);
        Recording received = Recording.FromBytes(segment.ToBytes());
        Assert.Equal(6, received.QuantizationInterval);
        Assert.Null(received.FirstDivergence(new Simulator(Pitch.Standard.On())));
        Assert.Null(rollback.SyncTest(64));
    }

    [Fact]
    public void Rounding_at_other_ticks_is_refused_while_a_recording_or_a_rollback_repeats_past_ticks()
    {
        FixedStepRunner runner = Match();
        Recording segment = runner.Record();
        runner.QuantizationInterval = segment.QuantizationInterval;
        Assert.Same(segment, runner.Recording);
        Assert.Contains("during a recording", Assert.Throws<InvalidOperationException>(() => runner.QuantizationInterval = 1).Message, StringComparison.Ordinal);
        Assert.Equal((6, segment), (runner.QuantizationInterval, runner.Recording));
        runner.StopRecording();
        runner.QuantizationInterval = 1;
        var rollback = new Rollback(runner);
        runner.Step();
        foreach (int other in new[] { 0, 2, 6 })
        {
            Assert.Contains("a Rollback is attached", Assert.Throws<InvalidOperationException>(() => runner.QuantizationInterval = other).Message, StringComparison.Ordinal);
        }

        runner.QuantizationInterval = 1;
        runner.Step();
        Assert.Null(rollback.SyncTest(2));
    }

    [Fact]
    public void A_ball_in_a_net_is_left_as_it_is_and_takes_a_whole_snapshot()
    {
        var runner = new FixedStepRunner(new Simulator(Pitch.Standard.On()), Step) { QuantizationInterval = 1 };
        runner.Restore(0, runner.Simulator.Launch(new Vector3d(1, 0.11, -46), new Vector3d(1, 4, -24), new Vector3d(20, 30, -10)));
        var bytes = new byte[Snapshot.QuantizedSize];
        int inNet = 0;
        int goal = 0;
        for (int i = 0; i < 300; i++)
        {
            runner.Step();
            bool written = runner.TryWriteQuantized(runner.State, bytes);
            Assert.False(written && runner.State.Nets != 0);
            inNet += written ? 0 : 1;
            goal += written && runner.State.GoalsPassed != 0 ? 1 : 0;
        }

        Assert.True(inNet > 5);
        Assert.True(goal > 0);
    }

    [Fact]
    public void Several_balls_are_rounded_all_or_none_and_keep_one_time()
    {
        var runner = new FixedStepRunner(new BallGroup(new Simulator(Pitch.Standard.On()), 3), Step) { QuantizationInterval = 2 };
        runner.Place(new Vector3d(1, 0.11, -46), 1);
        runner.Place(new Vector3d(5, 0.11, 3), 2);
        runner.QueueKick(new Vector3d(1, 4, -24), new Vector3d(20, 30, -10), 1);
        runner.QueueKick(new Vector3d(9, 4, 2), new Vector3d(20, 30, -10), 2);
        var bytes = new byte[Snapshot.QuantizedSize];
        int all = 0;
        int none = 0;
        while (runner.Tick < 400)
        {
            runner.Step();
            int held = Enumerable.Range(0, 3).Count(i => runner.TryWriteQuantized(runner.StateOf(i), bytes, i));
            all += runner.Tick % 2 == 0 && held == 3 ? 1 : 0;
            none += held == 0 ? 1 : 0;
        }

        Assert.True(all > 50 && none > 10, $"{all} and {none}");
    }

    /// <summary>The bytes do not store the horizontal spin of a roll: it follows from the velocity, so that the ball has no slip.</summary>
    [Fact]
    public void A_ball_that_rolls_is_read_without_slip()
    {
        var runner = new FixedStepRunner(timeStep: Step) { QuantizationInterval = 1 };
        double radius = runner.Simulator.Scene.Ball.Radius;
        runner.Restore(0, runner.Simulator.Launch(new Vector3d(1, radius, 2), new Vector3d(3.1, 0, -1.7), new Vector3d(-1.7 / radius, 4, -3.1 / radius)));
        runner.Step();
        BallState rolls = runner.State;
        Assert.Equal(MotionState.Rolling, rolls.Motion);
        var bytes = new byte[Snapshot.QuantizedSize];
        Assert.True(runner.TryWriteQuantized(in rolls, bytes));
        BallState read = runner.ReadQuantized(bytes);
        Assert.Equal((MotionState.Rolling, rolls.Velocity, rolls.Spin), (read.Motion, read.Velocity, read.Spin));
        Assert.Equal(3.1, read.Velocity.X, 0.05);
        Assert.Equal(4, read.Spin.Y, 0.2);
        Assert.Equal(read.Velocity.Z / radius, read.Spin.X, 1e-12);
        Assert.Equal(-read.Velocity.X / radius, read.Spin.Z, 1e-12);
    }

    [Fact]
    public void Bytes_that_no_state_makes_are_refused_and_any_others_are_a_ball()
    {
        var runner = new FixedStepRunner(timeStep: Step);
        var random = new Random(11);
        var bytes = new byte[Snapshot.QuantizedSize];
        int read = 0;
        for (int i = 0; i < 20_000; i++)
        {
            random.NextBytes(bytes);
            bytes[0] &= 0xF8;
            bytes[^1] &= 0x7F;
            try
            {
                BallState state = runner.ReadQuantized(bytes);
                runner.Simulator.Validate(in state);
                runner.Restore(0, in state);
                runner.Step();
                runner.Simulator.Validate(runner.State);
                read++;
            }
            catch (FormatException)
            {
                continue;
            }
        }

        Assert.InRange(read, 1, 20_000);
        bytes[0] |= 7;
        Assert.Throws<FormatException>(() => runner.ReadQuantized(bytes));
        Assert.Throws<ArgumentException>(() => runner.ReadQuantized(bytes.AsSpan(1)));
        Assert.Throws<ArgumentException>(() => runner.TryWriteQuantized(runner.State, bytes.AsSpan(1)));
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.QuantizationInterval = -1);
        Assert.Throws<ArgumentOutOfRangeException>(() => runner.ReadQuantized(bytes, 1));
    }

    /// <summary>Among players and boards, rounded at every tick: what may lie a hair inside a thing then is a ball all the same.</summary>
    [Fact]
    public void A_match_rounded_at_every_tick_goes_on_as_any_other()
    {
        var bodies = new KinematicBodies();
        KinematicBody[] players = [.. Enumerable.Range(0, 8).Select(i => bodies.Add("player", BodyKind.Player))];
        var runner = new FixedStepRunner(new Simulator(Pitch.Cage.On() with { Bodies = bodies }), Step) { QuantizationInterval = 1 };
        runner.MoveBodies = time =>
        {
            for (int i = 0; i < players.Length; i++)
            {
                double angle = i + (0.7 * time);
                players[i].MoveTo(new Vector3d(4 * Math.Cos(angle), 0, 6 * Math.Sin(angle)), new Vector3d(-2.8 * Math.Sin(angle), 0, 4.2 * Math.Cos(angle)), time);
            }
        };
        var random = new Random(3);
        var bytes = new byte[Snapshot.QuantizedSize];
        int written = 0;
        int events = 0;
        for (int tick = 0; tick < 6000; tick++)
        {
            if (tick % 100 == 0)
            {
                runner.QueueKick((40 * new Vector3d(random.NextDouble() - 0.5, 0.1 * random.NextDouble(), random.NextDouble() - 0.5)) - (0.3 * runner.State.Position.Horizontal), new Vector3d(0, 60 * (random.NextDouble() - 0.5), 0));
            }

            runner.Step();
            events += runner.Events.Count;
            runner.Simulator.Validate(runner.State);
            Assert.InRange(runner.Velocity.Length, 0, 60);
            Assert.InRange(runner.State.Position.Horizontal.Length, 0, 200);
            Assert.InRange(runner.State.Position.Y, runner.Simulator.ContactHeight - 1e-9, 80);
            written += runner.TryWriteQuantized(runner.State, bytes) ? 1 : 0;
        }

        Assert.InRange(written, 3000, 6000);
        Assert.InRange(events, 100, 6000);
    }

    private static FixedStepRunner Match()
    {
        var runner = new FixedStepRunner(new Simulator(Pitch.Standard.On()), Step) { QuantizationInterval = 6 };
        runner.QueueKick(speed: 20, direction: new Vector3d(0.1, 0.3, -1), sideSpin: 30);
        runner.Kicks.Add(new KickInput(330, new Vector3d(8, 1, 9), new Vector3d(0, -30, 5), 4));
        return runner;
    }

    /// <summary>States of every motion, as they come in matches.</summary>
    private static IEnumerable<(Simulator Simulator, BallState State)> States(int count)
    {
        var random = new Random(5);
        Simulator[] simulators = [new(), new(Scene.Published), new(Scene.Windy(new Vector3d(3, 0, 1)) with { Ball = BallProperties.Futsal })];
        while (count > 0)
        {
            Simulator simulator = simulators[count % simulators.Length];
            double Any(double size) => size * ((2 * random.NextDouble()) - 1);
            BallState state = simulator.Launch(
                new Vector3d(Any(60), random.Next(2) == 0 ? 0.11 : 0.11 + (20 * random.NextDouble()), Any(40)),
                new Vector3d(Any(25), random.Next(3) == 0 ? 0 : Any(12), Any(25)),
                new Vector3d(Any(90), Any(90), Any(90)),
                new Quaterniond(Any(1), Any(1), Any(1), Any(1)));
            var log = new StepLog();
            for (int i = 0; i < 10 && count > 0; i++)
            {
                simulator.Step(ref state, Step * random.Next(1, 60), log);
                log.Clear();
                count--;
                yield return (simulator, state);
            }
        }
    }

    /// <summary>A runner whose ball was rounded in its last step, and the ball as it was without.</summary>
    private static FixedStepRunner RoundedAtOnce(Simulator simulator, BallState state, out BallState before)
    {
        var plain = new FixedStepRunner(simulator, Step);
        plain.Restore(0, in state);
        plain.Step();
        before = plain.State;
        var runner = new FixedStepRunner(simulator, Step) { QuantizationInterval = 1 };
        runner.Restore(0, in state);
        runner.Step();
        return runner;
    }

    private static double Largest(Vector3d v) => Math.Max(Math.Abs(v.X), Math.Max(Math.Abs(v.Y), Math.Abs(v.Z)));

    private static double Angle(Quaterniond a, Quaterniond b)
    {
        double dot = Math.Abs((a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W));
        return 2 * Math.Acos(Math.Min(1, dot));
    }
}
