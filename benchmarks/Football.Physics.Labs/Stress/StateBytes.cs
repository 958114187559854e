using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using FootballPhysics.Game;
using FootballPhysics.Labs.Fuzz;

namespace FootballPhysics.Labs.Stress;

/// <summary>States of a ball with invalid fields: as a snapshot, or as the memory that C passes.</summary>
/// <param name="isMemory">True if the bytes are the memory of the state, without a checksum.</param>
internal sealed class StateBytes(bool isMemory) : FuzzTarget
{
    /// <summary>The number of steps of each length for an accepted state.</summary>
    private const int Repeats = 3;

    private static readonly double[] s_numbers =
    [
        double.NaN, double.PositiveInfinity, double.NegativeInfinity, double.MaxValue, double.MinValue, double.Epsilon, -double.Epsilon, 1e-310, 0, -0.0, -1, 1, 2, 1e-12, 0.1, 10, 100,
        1e4, 3e4, 1e6, 1e9, 1e15, 1e30, 1e45, -1e-9, -1e4, -1e30,
    ];

    public override string Name => isMemory ? "states of C" : "snapshots";

    public override byte[] Make(SeededRandom random, int mutations)
    {
        Simulator simulator = HallScenes.All[random.Below(HallScenes.All.Count)];
        BallState state = HallScenes.State(random, simulator);
        Span<ulong> words = stackalloc ulong[StateFields.Count];
        StateFields.Read(in state, words);
        for (int i = 0; i < mutations; i++)
        {
            Change(random, words);
        }

        byte[] bytes;
        if (isMemory)
        {
            StateFields.Write(words, ref state);
            bytes = MemoryMarshal.AsBytes(new ReadOnlySpan<BallState>(in state)).ToArray();
        }
        else
        {
            bytes = new byte[Snapshot.Size];
            MemoryMarshal.AsBytes<ulong>(words).CopyTo(bytes);
        }

        // Change some bytes too, as a broken sender would.
        for (int i = random.Chance(0.2) ? 1 + random.Below(3) : 0; i > 0; i--)
        {
            bytes[random.Below(bytes.Length)] ^= (byte)(1 << random.Below(8));
        }

        return isMemory ? bytes : FuzzBytes.Sealed(bytes);
    }

    public override bool Try(byte[] input)
    {
        if (!IsAccepted(() => isMemory ? Unsafe.ReadUnaligned<BallState>(ref MemoryMarshal.GetReference<byte>(input)) : Snapshot.Read(input), out BallState state, "source"))
        {
            return true;
        }

        bool refused = true;
        foreach (Simulator simulator in HallScenes.All)
        {
            try
            {
                simulator.Validate(in state);
            }
            catch (ArgumentOutOfRangeException refusal)
            {
                Must(refusal.ParamName?.StartsWith("state.", StringComparison.Ordinal) == true, "a rejected state is not named");
                continue;
            }

            refused = false;
            BallState played = state;
            for (int i = 0; i < Repeats; i++)
            {
                foreach (double step in HallScenes.Steps)
                {
                    MustBeShort(simulator, ref played, step);
                }
            }
        }

        return refused;
    }

    /// <summary>Changes one field: a number to one that often exposes errors, flags by a bit, an index to another one.</summary>
    private static void Change(SeededRandom random, Span<ulong> words)
    {
        int field = random.Below(StateFields.Count);
        (string name, bool isNumber) = StateFields.NameOf(field);
        if (random.Chance(0.3))
        {
            // Prefer fields that only a scene can check.
            string wanted = random.Any("nets", "netSides", "goalsPassed", "goalsEntered", "carrier", "airDistance", "clearUntil", "clearIn");
            field = StateFields.IndexOf(wanted);
            (name, isNumber) = StateFields.NameOf(field);
        }

        words[field] = isNumber && !random.Chance(0.1)
            ? BitConverter.DoubleToUInt64Bits(random.Chance(0.7) ? random.Any<double>(s_numbers) : FuzzNumbers.AnyBits(random))
            : name switch
            {
                "motion" or "dragRegion" => (ulong)random.Below(8),
                "carrier" => (ulong)random.Below(40),
                _ => words[field] ^ (1UL << random.Below(random.Chance(0.7) ? 10 : 64)),
            };
    }
}

/// <summary>States in the wire form with changed bits: at random, and field by field to the ends of its range.</summary>
internal sealed class WireBytes : FuzzTarget
{
    private const double Tick = 1 / 60.0;
    private const int MostTicks = 60;

    /// <summary>The first bit and the number of bits of each field: motion, goals entered and passed, time, x, z, y, velocity, spin, rotation.</summary>
    private static readonly (int First, int Count)[] s_fields = Fields([3, 2, 2, 22, 18, 18, 16, 16, 16, 16, 13, 13, 13, 2, 7, 7, 7]);

    public override string Name => "wire forms";

    public override byte[] Make(SeededRandom random, int mutations)
    {
        Simulator simulator = HallScenes.All[random.Below(HallScenes.All.Count)];
        var runner = new FixedStepRunner(simulator, Tick) { QuantizationInterval = 1 };
        runner.QueueKick(random.Velocity(1, 25, 0, 50), 50 * random.Direction());
        for (int i = random.Below(MostTicks); i >= 0; i--)
        {
            runner.Step();
        }

        var bytes = new byte[Snapshot.QuantizedSize];
        BallState state = runner.State;
        runner.TryWriteQuantized(in state, bytes);
        for (int i = 0; i < mutations; i++)
        {
            (int first, int count) = s_fields[random.Below(s_fields.Length)];
            ulong value = random.Any(0UL, ulong.MaxValue, 1UL, 1UL << (count - 1), (1UL << (count - 1)) - 1, (ulong)random.Below(int.MaxValue));
            for (int k = 0; k < count; k++)
            {
                int at = first + k;
                bytes[at >> 3] = (byte)((bytes[at >> 3] & ~(1 << (at & 7))) | ((int)(value >> k & 1) << (at & 7)));
            }
        }

        if (random.Chance(0.3))
        {
            bytes[random.Below(bytes.Length)] ^= (byte)(1 << random.Below(8));
        }

        return bytes;
    }

    public override bool Try(byte[] input)
    {
        bool refused = true;
        foreach (Simulator simulator in HallScenes.All)
        {
            var runner = new FixedStepRunner(simulator, Tick) { QuantizationInterval = 1 };
            if (!IsAccepted(() => runner.ReadQuantized(input), out BallState state, "source"))
            {
                continue;
            }

            refused = false;
            var again = new byte[Snapshot.QuantizedSize];
            Must(runner.TryWriteQuantized(in state, again) && again.AsSpan().SequenceEqual(input), "a state does not come back");
            MustBeFinite(in state);
            foreach (double step in HallScenes.Steps)
            {
                MustBeShort(simulator, ref state, step);
            }
        }

        return refused;
    }

    private static (int First, int Count)[] Fields(int[] counts)
    {
        int first = 0;
        return [.. counts.Select(count => (first += count) is var end ? (end - count, count) : default)];
    }
}
