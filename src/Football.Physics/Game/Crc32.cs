namespace Football.Physics;

/// <summary>The checksum CRC-32 (IEEE 802.3, as in Ethernet, zip and PNG): it finds every change of up to 32 neighbouring bits.</summary>
internal static class Crc32
{
    /// <summary>Bytes that it takes.</summary>
    public const int Size = 4;

    private const uint Polynomial = 0xEDB88320;

    private static readonly uint[] s_table = Table();

    /// <summary>The checksum of some bytes.</summary>
    public static uint Of(ReadOnlySpan<byte> bytes)
    {
        uint crc = uint.MaxValue;
        foreach (byte next in bytes)
        {
            crc = (crc >> 8) ^ s_table[(byte)(crc ^ next)];
        }

        return ~crc;
    }

    /// <summary>Writes the checksum of all bytes but the last four there, little-endian.</summary>
    public static void Seal(Span<byte> bytes)
    {
        uint crc = Of(bytes[..^Size]);
        for (int i = 0; i < Size; i++)
        {
            bytes[bytes.Length - Size + i] = (byte)(crc >> (i << 3));
        }
    }

    /// <summary>Whether the last four bytes are the checksum of those before.</summary>
    public static bool Holds(ReadOnlySpan<byte> bytes)
    {
        if (bytes.Length < Size)
        {
            return false;
        }

        uint crc = Of(bytes[..^Size]);
        for (int i = 0; i < Size; i++)
        {
            if (bytes[bytes.Length - Size + i] != (byte)(crc >> (i << 3)))
            {
                return false;
            }
        }

        return true;
    }

    private static uint[] Table()
    {
        var table = new uint[256];
        for (uint i = 0; i < table.Length; i++)
        {
            uint crc = i;
            for (int bit = 0; bit < 8; bit++)
            {
                crc = (crc & 1) == 0 ? crc >> 1 : (crc >> 1) ^ Polynomial;
            }

            table[i] = crc;
        }

        return table;
    }
}
