using System.Numerics;
using FootballPhysics.Game;
using FootballPhysics.Scenes;
using FootballPhysics.State;
using FsCheck.Fluent;
using FsCheck;

namespace FootballPhysics.Tests.Game;

/// <summary>Bytes from anywhere: what was changed is refused, and what is accepted is a ball that can be played.</summary>
public sealed class BytesTests
{
    [Fact]
    public void Every_flipped_bit_of_a_kick_log_is_refused()
    {
        byte[] bytes = Log().ToBytes();
        ForEveryBit(bytes, flipped => KickLog.FromBytes(flipped));
        Assert.Equal(3, KickLog.FromBytes(bytes).Count);
    }

    [Fact]
    public void Every_flipped_bit_of_a_snapshot_is_refused()
    {
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(Segment().Start, bytes);
        ForEveryBit(bytes, flipped => Snapshot.Read(flipped));
    }

    [Fact]
    public void Every_flipped_bit_of_a_segment_is_refused()
    {
        byte[] bytes = Segment().ToBytes();
        ForEveryBit(bytes, flipped => Recording.FromBytes(flipped));
    }

    [Fact]
    public void A_cut_or_longer_text_is_refused()
    {
        foreach (byte[] bytes in (byte[][])[Log().ToBytes(), Segment().ToBytes()])
        {
            for (int length = 0; length < bytes.Length; length++)
            {
                Refused(() => KickLog.FromBytes(bytes.AsSpan(0, length)));
                Refused(() => Recording.FromBytes(bytes.AsSpan(0, length)));
            }

            Refused(() => KickLog.FromBytes([.. bytes, 0]));
            Refused(() => Recording.FromBytes([.. bytes, 0]));
        }
    }

    /// <summary>The words of a state in flight: time, place, velocity, motion, axis, rate, angle, orientation, branch.</summary>
    [Theory]
    [InlineData(0, -1.0, "state.time is -1; allowed: 0 … ")]
    [InlineData(0, 1e17, "state.time is 1E+17; allowed: 0 … ")]
    [InlineData(0, double.NaN, "state.time is NaN")]
    [InlineData(1, 1.1e45, "state.position is 1.1E+45; allowed: 0 … 1E+45")]
    [InlineData(2, double.NegativeInfinity, "state.position is ")]
    [InlineData(4, 1.1e30, "state.velocity is ")]
    [InlineData(6, double.NaN, "state.velocity is ")]
    [InlineData(8, 2.0, "state.spinAxis is ")]
    [InlineData(11, -1.0, "state.spinRate is -1; allowed: 0 … ")]
    [InlineData(11, 1e300, "state.spinRate is 1E+300; allowed: 0 … ")]
    [InlineData(12, 1e300, "state.angle is 1E+300; allowed: ")]
    [InlineData(13, 1.0, "state.orientation is ")]
    [InlineData(16, double.NaN, "state.orientation is NaN")]
    public void A_state_that_no_ball_can_have_is_refused_by_name(int word, double value, string says)
    {
        string message = RefusedWith(word, (ulong)BitConverter.DoubleToInt64Bits(value));
        Assert.StartsWith($"The bytes are broken: {says}", message);
        Assert.DoesNotContain("Parameter", message);
    }

    [Theory]
    [InlineData(7, 5, "state.motion is ")]
    [InlineData(7, 1, "state.spinRate is ")]
    [InlineData(17, 5, "state.branch is ")]
    public void A_member_that_an_enumeration_does_not_have_is_refused_by_name(int word, ulong value, string says) =>
        Assert.StartsWith($"The bytes are broken: {says}", RefusedWith(word, value));

    /// <summary>A ball that fell for long, and one that flew away: beyond what a launch may be, and still a ball.</summary>
    [Fact]
    public void A_ball_that_has_got_beyond_the_limits_comes_back_and_can_be_kicked()
    {
        var simulator = new Simulator(Scene.Vacuum with { Gravity = 300 });
        BallState state = simulator.Launch(new Vector3d(1e6, 1e6, 0), new Vector3d(1000, 0, 0), Vector3d.Zero);
        simulator.Step(ref state, 80, new StepLog());
        Assert.True(state.Velocity.Length > Limits.Speed && state.Position.X > Limits.Length);
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(state, bytes);
        BallState read = Snapshot.Read(bytes);
        Assert.True(Snapshot.Same(state, read));
        simulator.Kick(ref read, Vector3d.Up, Vector3d.Zero);
        Assert.Equal((state.Position, Vector3d.Up), (read.Position, read.Velocity));
    }

    [Fact]
    public void A_segment_whose_ball_is_kicked_far_away_is_compared_not_refused()
    {
        var simulator = new Simulator(Scene.Vacuum);
        var runner = new FixedStepRunner(simulator);
        runner.Restore(0, simulator.Launch(new Vector3d(1e6, 500, 0), new Vector3d(1000, 0, 0), Vector3d.Zero));
        runner.Kicks.Add(new KickInput(3, Vector3d.Up, Vector3d.Zero));
        Recording segment = runner.Record();
        Inputs.Play(runner, 10);
        Assert.Null(Recording.FromBytes(segment.ToBytes()).FirstDivergence(simulator));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-0.01)]
    [InlineData(1e300)]
    [InlineData(double.NaN)]
    [InlineData(1e-18)]
    public void A_segment_whose_step_is_none_or_would_not_move_its_clock_is_refused(double timeStep)
    {
        Recording segment = Segment();
        byte[] bytes = segment.ToBytes();

        // Behind the format, the version and its length, and the hash of the scene.
        BitConverter.TryWriteBytes(bytes.AsSpan(5 + 1 + segment.Version.Length + 8), timeStep);
        Crc32.Seal(bytes);
        Assert.StartsWith("The bytes are broken: timeStep is ", Refused(() => Recording.FromBytes(bytes)));
    }

    [Fact]
    public void A_segment_in_short_steps_is_played_again()
    {
        var runner = new FixedStepRunner(timeStep: 1e-9, maximumFrameTime: 1e-6);
        Recording segment = runner.Record();
        runner.Step();
        Assert.Null(Recording.FromBytes(segment.ToBytes()).FirstDivergence(runner.Simulator));
    }

    /// <summary>To sort them would take as long as their number squared: four bytes each, in the worst order.</summary>
    [Fact]
    public void Kicks_out_of_order_are_refused_at_the_first()
    {
        var writer = new ByteWriter();
        const int Count = 1_000_000;
        writer.Integer(Count);
        for (int i = Count; i > 0; i--)
        {
            writer.Integer(0);
            writer.Integer((ulong)i);
            writer.Bits(0, 2);
        }

        byte[] bytes = writer.ToArray();
        Assert.Contains("not in order", Refused(() => KickLog.FromBytes(bytes)));
    }

    [Fact]
    public void A_count_that_the_bytes_cannot_hold_asks_for_no_memory()
    {
        var writer = new ByteWriter();
        writer.Integer(int.MaxValue);
        byte[] bytes = writer.ToArray();
        long before = GC.GetAllocatedBytesForCurrentThread();
        Assert.Contains("end too early", Refused(() => KickLog.FromBytes(bytes)));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1 << 20);
    }

    /// <summary>A body takes 30 times more memory than its shortest form.</summary>
    [Fact]
    public void A_segment_of_too_many_bodies_is_refused_before_it_takes_their_memory()
    {
        Recording segment = Segment();
        byte[] bytes = segment.ToBytes();

        // Behind the format, the version and its length, the hash, the step, four numbers of a byte each and the only ball.
        int at = 5 + 1 + segment.Version.Length + 8 + 8 + 4 + Snapshot.Size;
        Assert.Equal((1, 0), (segment.Balls, bytes[at]));
        var writer = new ByteWriter();
        foreach (byte part in bytes.AsSpan(0, at))
        {
            writer.Bits(part, 1);
        }

        const int Count = 100_001;
        writer.Integer(Count);
        for (int i = 0; i < Count; i++)
        {
            writer.Bits(0, 5);
        }

        byte[] many = writer.ToArray();
        long before = GC.GetAllocatedBytesForCurrentThread();
        Assert.Equal("The bytes are broken: there are more than 100 000 bodies.", Refused(() => Recording.FromBytes(many)));
        Assert.InRange(GC.GetAllocatedBytesForCurrentThread() - before, 0, 1 << 21);
    }

    [Fact]
    public void A_tick_of_a_body_beyond_63_bits_is_refused()
    {
        var writer = new ByteWriter();
        writer.Integer(2);
        foreach (ulong ticks in (ulong[])[long.MaxValue, 1])
        {
            writer.Integer(ticks);
            writer.Integer(0);
            PlacementLog.Write(new RigidMotion { Orientation = Quaterniond.Identity }, ref writer);
        }

        byte[] bytes = writer.ToArray();
        Assert.Equal("The bytes are broken: a tick beyond 63 bits.", Refused(() =>
        {
            var reader = new ByteReader(bytes);
            PlacementLog.Read(ref reader);
        }));
    }

    [Fact]
    public void The_checksum_is_the_one_that_everyone_has() => Assert.Equal(0xCBF43926u, Crc32.Of("123456789"u8));

    [Fact]
    public void States_of_any_match_are_accepted()
    {
        var states = from simulator in Inputs.Simulators from kicks in Inputs.Kicks(300) select Inputs.Play(Inputs.Runner(simulator, kicks), 600);
        Prop.ForAll(states.ToArbitrary(), all =>
        {
            foreach (BallState state in all)
            {
                StateCheck.Validate(in state);
            }
        }).QuickCheckThrowOnFailure();
    }

    private static string RefusedWith(int word, ulong value)
    {
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(Segment().Start, bytes);
        BitConverter.TryWriteBytes(bytes.AsSpan(8 * word), value);
        Crc32.Seal(bytes);
        return Refused(() => Snapshot.Read(bytes));
    }

    private static void ForEveryBit(byte[] bytes, Action<byte[]> read)
    {
        for (int bit = 0; bit < 8 * bytes.Length; bit++)
        {
            byte[] flipped = [.. bytes];
            flipped[bit / 8] ^= (byte)(1 << (bit % 8));
            Assert.Contains("checksum", Refused(() => read(flipped)));
        }
    }

    private static string Refused(Action read) => Assert.Throws<FormatException>(read).Message;

    private static KickLog Log()
    {
        var log = new KickLog();
        log.Add(new KickInput(100, new Vector3(1.1f, 2.2f, -20.3f), new Vector3(3.3f, 40.4f, 0.5f)));
        log.Add(new KickInput(100, new Vector3d(0.1, 2, 0), Vector3d.Zero, 3));
        log.Add(new KickInput(70_000, new Vector3d(0, 9, -21), new Vector3d(0, 0, 1.0 / 3)));
        return log;
    }

    private static Recording Segment()
    {
        var runner = new FixedStepRunner();
        runner.QueueKick(new Vector3d(2, 6, -20), new Vector3d(0, 30, 0));
        runner.Step();
        Recording segment = runner.Record();
        Inputs.Play(runner, 8);
        return segment;
    }
}
