using FootballPhysics.Game;
using FootballPhysics.Yardsticks;

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
