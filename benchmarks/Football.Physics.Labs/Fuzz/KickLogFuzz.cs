using FootballPhysics.Game;

namespace FootballPhysics.Labs.Fuzz;

/// <summary>Kick logs: bytes that were changed, and logs written with extreme numbers.</summary>
internal sealed class KickLogFuzz : FuzzTarget
{
    public override string Name => "kick logs";

    /// <summary>Makes a log of a few kicks, as a game would.</summary>
    public static KickLog Log(SeededRandom random, int ticks)
    {
        var log = new KickLog();
        for (int i = random.Below(6); i > 0; i--)
        {
            Vector3d velocity = random.Velocity(0, 30, 0, 60);
            bool single = random.Chance(0.5);
            log.Add(new KickInput(random.Below(ticks), single ? velocity.ToVector3() : velocity, random.Chance(0.3) ? Vector3d.Zero : 50 * random.Direction(), random.Below(3)));
        }

        return log;
    }

    /// <summary>Writes kicks in the file format, some of their numbers extreme.</summary>
    public static void Write(SeededRandom random, ref ByteWriter writer, KickLog log, double wild)
    {
        bool Wild() => random.Chance(wild);
        writer.Integer(Wild() ? Integer(random) : (ulong)log.Count);
        long last = 0;
        for (int i = 0; i < log.Count; i++)
        {
            ref readonly KickInput kick = ref log[i];
            writer.Integer(Wild() ? Integer(random) : (ulong)(kick.Tick - last));
            writer.Integer(Wild() ? Integer(random) : (ulong)kick.Player);
            last = kick.Tick;
            writer.Bits(Wild() ? (ulong)random.Below(1 << 16) : 0xAAA, 2);
            foreach (double number in (double[])[kick.Velocity.X, kick.Velocity.Y, kick.Velocity.Z, kick.Spin.X, kick.Spin.Y, kick.Spin.Z])
            {
                writer.Bits(BitConverter.DoubleToUInt64Bits(Wild() ? FuzzNumbers.AnyBits(random) : number), 8);
            }
        }
    }

    /// <summary>Returns an integer at the end of some range.</summary>
    public static ulong Integer(SeededRandom random) =>
        random.Any<ulong>(0, 1, 2, 127, 128, int.MaxValue, uint.MaxValue, long.MaxValue, 1UL << 53, 1UL << 62, ulong.MaxValue, (ulong)random.Below(1000));

    public override byte[] Make(SeededRandom random, int mutations)
    {
        KickLog log = Log(random, 1000);
        if (random.Chance(0.5))
        {
            var writer = new ByteWriter();
            Write(random, ref writer, log, mutations / 30.0);
            return writer.ToArray();
        }

        byte[] changed = FuzzBytes.Changed(random, log.ToBytes(), mutations);
        return random.Chance(0.7) ? FuzzBytes.Sealed(changed) : changed;
    }

    public override bool Try(byte[] input)
    {
        if (!IsAccepted<KickLog>(() => KickLog.FromBytes(input), out KickLog? log))
        {
            return true;
        }

        Must(Crc32.Holds(input), "changed bytes are accepted");
        for (int i = 0; i < log.Count; i++)
        {
            ref readonly KickInput kick = ref log[i];
            Must(kick is { Tick: >= 0, Player: >= 0 } && kick.Velocity.Length <= Limits.Speed && kick.Spin.Length <= Limits.Spin, "a kick is beyond its limits");
            Must(i == 0 || log[i - 1].Order(kick.Tick, kick.Player, kick.Ball) < 0, "kicks are out of order");
            Must(log.FirstAt(kick.Tick) <= i, "a kick is not found");
        }

        byte[] again = log.ToBytes();
        Must(again.AsSpan().SequenceEqual(KickLog.FromBytes(again).ToBytes()), "a log does not come back");
        return false;
    }
}
