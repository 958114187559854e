using FootballPhysics.Labs.Fuzz;

namespace FootballPhysics.Labs.Stress;

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
