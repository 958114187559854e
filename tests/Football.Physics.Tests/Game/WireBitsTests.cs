using System.Numerics;
using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Game;

/// <summary>The bits of the quantised form, read by a second reader, and the range of each number in it.</summary>
public sealed class WireBitsTests
{
    private const double Step = 1.0 / 60;
    private const int Bits = 8 * Snapshot.QuantizedSize;

    /// <summary>Lowest bit first: motion 3, goals 2 + 2, steps 22, x 18, z 18, height 16, velocity 3 × 16, spin 3 × 13, rotation 2 + 3 × 7, and one bit 0.</summary>
    [Fact]
    public void The_bytes_are_the_numbers_in_their_units()
    {
        var motions = new HashSet<MotionState>();
        foreach ((FixedStepRunner runner, BallState state, byte[] bytes) in Written())
        {
            motions.Add(state.Motion);
            var rest = new BigInteger(bytes, isUnsigned: true);
            long Take(int count)
            {
                long word = (long)(rest & ((BigInteger.One << count) - 1));
                rest >>= count;
                return word;
            }

            double Signed(int count, double units) => (Take(count) - Math.Pow(2, count - 1)) / units;
            bool flies = state.Motion == MotionState.Airborne;
            Assert.Equal((long)state.Motion, Take(3));
            Assert.Equal((0L, 0L), (Take(2), Take(2)));
            Assert.Equal(state.Time, Take(22) * Step);
            Assert.Equal(state.Position.X, Signed(18, 1024));
            Assert.Equal(state.Position.Z, Signed(18, 1024));
            double height = Take(16);
            Assert.Equal(flies ? state.Position.Y : -4, (height / 1024) - 4);
            Assert.Equal(state.Velocity, new Vector3d(Signed(16, 512), Signed(16, 512), Signed(16, 512)));
            Assert.True(flies || state.Position.Y == runner.Simulator.ContactHeight);
            var spin = new Vector3d(Signed(13, 8), Signed(13, 8), Signed(13, 8));
            bool rolls = state.Motion == MotionState.Rolling;
            spin = rolls ? (Vector3d.Cross(Vector3d.Up, state.Velocity) / runner.Simulator.Scene.Ball.Radius) + new Vector3d(spin.X, spin.Y, spin.Z) : spin;
            Assert.InRange(Vector3d.Distance(spin, state.Spin), 0, 1e-9);

            int largest = (int)Take(2);
            double[] parts = [.. Enumerable.Range(0, 4).Select(i => i == largest ? 0 : (Take(7) - 63) / (63 * Math.Sqrt(2)))];
            parts[largest] = Math.Sqrt(1 - parts.Sum(part => part * part));
            Quaterniond q = state.BaseOrientation;
            Assert.Equal(0, Math.Abs(parts[0] - q.X) + Math.Abs(parts[1] - q.Y) + Math.Abs(parts[2] - q.Z) + Math.Abs(parts[3] - q.W), 1e-14);
            Assert.True(parts[largest] >= parts.Max(Math.Abs) - 1e-14);
            Assert.True(rest.IsZero);
        }

        Assert.Equal(4, motions.Count);
    }

    /// <summary>Each state has one encoding: bytes with another bit are another state, or none.</summary>
    [Fact]
    public void Every_flipped_bit_gives_another_state_or_is_refused()
    {
        var again = new byte[Snapshot.QuantizedSize];
        int refused = 0;
        int read = 0;
        foreach ((FixedStepRunner runner, BallState state, byte[] bytes) in Written().Where((_, i) => i % 4 == 0))
        {
            for (int bit = 0; bit < Bits; bit++)
            {
                byte[] flipped = [.. bytes];
                flipped[bit / 8] ^= (byte)(1 << (bit % 8));
                try
                {
                    BallState other = runner.ReadQuantized(flipped);
                    runner.Simulator.Validate(in other);
                    Assert.False(Snapshot.Same(state, other));
                    Assert.True(runner.TryWriteQuantized(in other, again));
                    Assert.Equal(flipped, again);
                    read++;
                }
                catch (FormatException)
                {
                    Assert.True(bit is < 7 or 191 || state.Motion != MotionState.Airborne || (bit >= 65 && bit < 81) || bit >= 168, $"bit {bit} of a flying ball");
                    refused++;
                }
            }
        }

        Assert.True(read > 2000 && refused > 2000, $"{read} and {refused}");
    }

    /// <summary>A number that the form represents is written at every tick: the random rounding never moves it, whatever the clock draws.</summary>
    [Fact]
    public void A_spin_in_whole_units_is_written_at_the_ticks_with_the_most_extreme_random_numbers()
    {
        FixedStepRunner runner = Flying(out BallState state);
        var bytes = new byte[Snapshot.QuantizedSize];
        for (int component = 0; component < 3; component++)
        {
            (long low, long high) = (0, 0);
            for (long clock = 1; clock < 1 << 22; clock++)
            {
                double at = SplitMix64.At(clock, component);
                low = at < SplitMix64.At(low, component) ? clock : low;
                high = at > SplitMix64.At(high, component) ? clock : high;
            }

            Assert.True(SplitMix64.At(low, component) < 3e-6 && SplitMix64.At(high, component) > 1 - 3e-6);
            foreach (long clock in new[] { low, high })
            {
                state.Time = clock * Step;
                Assert.True(runner.TryWriteQuantized(in state, bytes));
                Assert.True(Snapshot.Same(state, runner.ReadQuantized(bytes)));
            }
        }
    }

    [Fact]
    public void A_number_is_written_to_the_ends_of_its_range_and_not_beyond()
    {
        Ends(-128, 128 - (1 / 1024.0), 1 / 1024.0, (ref BallState state, double value) => state.Position = new Vector3d(value, state.Position.Y, state.Position.Z));
        Ends(-128, 128 - (1 / 1024.0), 1 / 1024.0, (ref BallState state, double value) => state.Position = new Vector3d(state.Position.X, state.Position.Y, value));
        Ends(0.5, 60 - (1 / 1024.0), 1 / 1024.0, (ref BallState state, double value) => state.Position = new Vector3d(state.Position.X, value, state.Position.Z), lowIsEnd: false);
        Ends(-64, 64 - (1 / 512.0), 1 / 512.0, (ref BallState state, double value) => state.Velocity = new Vector3d(value, state.Velocity.Y, state.Velocity.Z));
        Ends(-64, 64 - (1 / 512.0), 1 / 512.0, (ref BallState state, double value) => state.Velocity = new Vector3d(state.Velocity.X, value, state.Velocity.Z));
        Ends(-64, 64 - (1 / 512.0), 1 / 512.0, (ref BallState state, double value) => state.Velocity = new Vector3d(state.Velocity.X, state.Velocity.Y, value));
        Ends(-512, 512 - 0.125, 0.125, (ref BallState state, double value) => state.SetFlightSpin(new Vector3d(value, 0, 0)));
        Ends(-512, 512 - 0.125, 0.125, (ref BallState state, double value) => state.SetFlightSpin(new Vector3d(0, value, 0)));
        Ends(-512, 512 - 0.125, 0.125, (ref BallState state, double value) => state.SetFlightSpin(new Vector3d(0, 0, value)));
        Ends(0, ((1 << 22) - 1) * Step, Step, (ref BallState state, double value) => state.Time = value);
    }

    /// <summary>A state that differs in one field which the form does not store is not written.</summary>
    [Fact]
    public void What_the_form_cannot_store_is_not_written()
    {
        var bytes = new byte[Snapshot.QuantizedSize];
        FixedStepRunner runner = Flying(out BallState flying);
        Assert.True(runner.TryWriteQuantized(in flying, bytes));
        Not(flying with { Motion = MotionState.Pinned });
        Not(flying with { Nets = 1 });
        Not(flying with { AirDistance = 1 });
        Not(flying with { GoalsEntered = 4 });
        Not(flying with { GoalsPassed = 4 });
        Not(flying with { Angle = 0.1 });
        Not(flying with { Time = flying.Time + (0.1 * Step) });
        (FixedStepRunner Runner, BallState State, byte[] Bytes) rolling = Written().First(at => at.State.Motion == MotionState.Rolling);
        Not(rolling.State with { Carrier = 1 });
        Not(rolling.State with { Position = rolling.State.Position + new Vector3d(0, 1e-9, 0) });
        Not(rolling.State with { Velocity = rolling.State.Velocity + new Vector3d(0, 1.0 / 512, 0) });

        // The ground of another scene is not level, or not there.
        foreach (Scene scene in new[] { new Scene { Ground = new Ground { Normal = new Vector3d(0.1, 1, 0) } }, new Scene { Ground = Ground.None } })
        {
            var other = new FixedStepRunner(new Simulator(scene), Step);
            Assert.False(other.TryWriteQuantized(in rolling.State, bytes));
            Assert.Throws<FormatException>(() => other.ReadQuantized(rolling.Bytes));
        }

        void Not(BallState state) => Assert.False(runner.TryWriteQuantized(in state, bytes));
    }

    private delegate void Setter(ref BallState state, double value);

    private static void Ends(double low, double high, double unit, Setter set, bool lowIsEnd = true)
    {
        FixedStepRunner runner = Flying(out BallState state);
        var bytes = new byte[Snapshot.QuantizedSize];
        foreach ((double value, bool isIn) in new[] { (low, true), (high, true), (low - unit, !lowIsEnd), (high + unit, false), (0.5 * (low + high) + (0.5 * unit), false) })
        {
            BallState ball = state;
            set(ref ball, value);
            bool written = runner.TryWriteQuantized(in ball, bytes);
            Assert.True(written == isIn || (0.5 * (low + high) + (0.5 * unit) == value && 2 * Math.Round(value / unit) == 2 * value / unit), $"{value}: {written}");
            Assert.True(!written || Snapshot.Same(ball, runner.ReadQuantized(bytes)));
        }
    }

    /// <summary>A flying ball in whole units, with a runner that can write it.</summary>
    private static FixedStepRunner Flying(out BallState state)
    {
        (FixedStepRunner runner, state, _) = Written().First(at => at.State.Motion == MotionState.Airborne && at.State.Position.Y > 2);
        return runner;
    }

    /// <summary>States of every motion as matches round them, with their bytes.</summary>
    private static IEnumerable<(FixedStepRunner Runner, BallState State, byte[] Bytes)> Written()
    {
        var random = new Random(9);
        double Any(double size) => size * ((2 * random.NextDouble()) - 1);
        for (int i = 0; i < 40; i++)
        {
            var runner = new FixedStepRunner(timeStep: Step) { QuantizationInterval = 1 };
            runner.Restore(0, runner.Simulator.Launch(
                new Vector3d(Any(60), i % 2 == 0 ? 0 : 5, Any(40)), new Vector3d(Any(15), i % 2 == 0 ? 0 : Any(12), Any(15)), new Vector3d(Any(60), Any(60), Any(60)), new Quaterniond(Any(1), Any(1), Any(1), Any(1))));
            for (int tick = 0; tick < 600; tick++)
            {
                runner.Step();
                var bytes = new byte[Snapshot.QuantizedSize];
                if (tick % 75 == 0 && runner.TryWriteQuantized(runner.State, bytes))
                {
                    yield return (runner, runner.State, bytes);
                }
            }
        }
    }
}
