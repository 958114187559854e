using FootballPhysics.Game;

namespace FootballPhysics.Labs.Fuzz;

/// <summary>Changes bytes without regard to their meaning.</summary>
internal static class FuzzBytes
{
    /// <summary>Returns the bytes with a number of changes.</summary>
    public static byte[] Changed(SeededRandom random, ReadOnlySpan<byte> bytes, int changes)
    {
        List<byte> changed = [.. bytes];
        for (int i = 0; i < changes; i++)
        {
            Change(random, changed);
        }

        return [.. changed];
    }

    private static void Change(SeededRandom random, List<byte> bytes)
    {
        int at = random.Below(bytes.Count + 1);
        int length = Math.Min(bytes.Count - at, 1 + random.Below(9));
        switch (random.Below(7))
        {
            case 0 or 1 when at < bytes.Count:
                bytes[at] ^= (byte)(1 << random.Below(8));
                break;
            case 2 when at < bytes.Count:
                bytes[at] = (byte)random.Any(0, 1, 0x7F, 0x80, 0xFF, random.Below(256));
                break;
            case 3:
                bytes.RemoveRange(at, length);
                break;
            case 4:
                bytes.InsertRange(at, bytes.GetRange(at, length));
                break;
            case 5:
                bytes.InsertRange(at, BitConverter.GetBytes(FuzzNumbers.AnyBits(random)));
                break;
            default:
                bytes.RemoveRange(at, bytes.Count - at);
                break;
        }
    }

    /// <summary>Writes the matching checksum, so that the reader does not stop there.</summary>
    public static byte[] Sealed(byte[] bytes)
    {
        if (bytes.Length >= Crc32.Size)
        {
            Crc32.Seal(bytes);
        }

        return bytes;
    }
}

/// <summary>Numbers that often expose errors in programs.</summary>
internal static class FuzzNumbers
{
    private static readonly double[] s_edges =
    [
        0, double.Epsilon, 1e-310, 1e-300, 1e-200, 1e-153, 1e-100, 1e-16, 1e-12, 1e-9, 1e-6, 1e-4, 0.001, 0.01, 0.05, 0.1, 0.25, 0.5, 1, 2, 3, 9.81, 10, 12.19,
        100, 1000, 1e4, 1e6, 1e9, 1e12, 1e15, 1e17, 1e30, 1e35, 1e45, 1e60, 1e75, 1e100, 1e153, 1e200, 1e300, double.MaxValue,
    ];

    /// <summary>Returns one of the numbers, a neighbour of one, or any number.</summary>
    public static double Any(SeededRandom random)
    {
        double number = random.Below(8) switch
        {
            0 => random.Log(1e-12, 1e12),
            1 => random.Uniform(-3, 3),
            2 => Math.BitDecrement(random.Any<double>(s_edges)),
            3 => Math.BitIncrement(random.Any<double>(s_edges)),
            _ => random.Any<double>(s_edges),
        };
        number = Math.Min(number, double.MaxValue);
        return random.Chance(0.3) ? -number : number;
    }

    /// <summary>Returns such a number, or a number with random bits.</summary>
    public static double AnyBits(SeededRandom random) => random.Chance(0.2)
        ? random.Any(double.NaN, double.PositiveInfinity, double.NegativeInfinity, BitConverter.UInt64BitsToDouble(SeededRandom.Mix(random.Below(int.MaxValue), 3)))
        : Any(random);
}

/// <summary>Kick logs: bytes that were changed, and logs written with extreme numbers.</summary>
internal sealed class KickLogFuzz : FuzzTarget
{
    public override string Name => "kick logs";

    /// <summary>Makes a log of a few kicks and restarts, as a game would.</summary>
    public static KickLog Log(SeededRandom random, int ticks)
    {
        var log = new KickLog();
        for (int i = random.Below(6); i > 0; i--)
        {
            Vector3d velocity = random.Velocity(0, 30, 0, 60);
            bool single = random.Chance(0.5);
            log.Add(new KickInput(random.Below(ticks), single ? velocity.ToVector3() : velocity, random.Chance(0.3) ? Vector3d.Zero : 50 * random.Direction(), random.Below(3)));
        }

        for (int i = random.Below(3); i > 0; i--)
        {
            Vector3d place = random.Uniform(0, 60) * random.Direction();
            Vector3d velocity = random.Chance(0.5) ? Vector3d.Zero : random.Velocity(0, 30, 0, 60);
            log.Add(new PlaceInput(random.Below(ticks), random.Below(3), 0, place, velocity, default, random.Chance(0.5) ? null : new Quaterniond(random.Next(), 0, 0, 1)));
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

    /// <summary>Writes restarts in the file format, some of their numbers extreme.</summary>
    public static void WritePlaces(SeededRandom random, ref ByteWriter writer, KickLog log, double wild)
    {
        bool Wild() => random.Chance(wild);
        writer.Integer(Wild() ? Integer(random) : (ulong)log.PlaceCount);
        long last = 0;
        for (int i = 0; i < log.PlaceCount; i++)
        {
            ref readonly PlaceInput place = ref log.PlaceAt(i);
            writer.Integer(Wild() ? Integer(random) : (ulong)(place.Tick - last));
            writer.Integer(Wild() ? Integer(random) : (ulong)place.Player);
            last = place.Tick;
            writer.Bits(Wild() ? (ulong)random.Below(1 << 30) : 0x2AAAAAA, 4);
            Quaterniond q = place.Orientation;
            foreach (double number in (double[])
                [place.Position.X, place.Position.Y, place.Position.Z, place.Velocity.X, place.Velocity.Y, place.Velocity.Z, place.Spin.X, place.Spin.Y, place.Spin.Z, q.X, q.Y, q.Z, q.W])
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
            if (log.PlaceCount > 0)
            {
                WritePlaces(random, ref writer, log, mutations / 30.0);
            }

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
            Must(i == 0 || InputList<KickInput>.Order(in log[i - 1], kick.Tick, kick.Player, kick.Ball) < 0, "kicks are out of order");
            Must(log.FirstAt(kick.Tick) <= i, "a kick is not found");
        }

        for (int i = 0; i < log.PlaceCount; i++)
        {
            ref readonly PlaceInput place = ref log.PlaceAt(i);
            Must(place is { Tick: >= 0, Player: >= 0 } && place.Velocity.Length <= Limits.Speed && place.Spin.Length <= Limits.Spin, "a restart is beyond its limits");
            Must(i == 0 || InputList<PlaceInput>.Order(in log.PlaceAt(i - 1), place.Tick, place.Player, place.Ball) < 0, "restarts are out of order");
            Must(log.FirstPlaceAt(place.Tick) <= i, "a restart is not found");
        }

        byte[] again = log.ToBytes();
        Must(again.AsSpan().SequenceEqual(KickLog.FromBytes(again).ToBytes()), "a log does not come back");
        return false;
    }
}
