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
