using System.Buffers.Binary;
using System.Runtime.InteropServices;

namespace FootballPhysics.Game;

/// <summary>The CRC-32 checksum (IEEE 802.3, as in Ethernet, zip and PNG), which detects every error burst of up to 32 bits.</summary>
internal static class Crc32
{
    /// <summary>The size of the checksum, in bytes.</summary>
    public const int Size = 4;

    private const uint Polynomial = 0xEDB88320;

    private static readonly uint[] s_table = Table();

    /// <summary>Returns the checksum of the bytes. Uses a pointer, because older Mono runtimes cannot index a read-only span.</summary>
    public static unsafe uint Of(ReadOnlySpan<byte> bytes)
    {
        uint crc = uint.MaxValue;
        fixed (byte* first = &MemoryMarshal.GetReference(bytes))
        {
            for (int i = 0; i < bytes.Length; i++)
            {
                // Process one byte at a time. Bits are reflected (lowest bit first), as in zip files.
                crc = (crc >> 8) ^ s_table[(byte)(crc ^ first[i])];
            }
        }

        return ~crc;
    }

    /// <summary>Writes the checksum of all bytes except the last four into those four, little-endian.</summary>
    public static void Seal(Span<byte> bytes) => BinaryPrimitives.WriteUInt32LittleEndian(bytes[^Size..], Of(bytes[..^Size]));

    /// <summary>True if the last four bytes are the checksum of the bytes before them.</summary>
    public static bool Holds(ReadOnlySpan<byte> bytes) =>
        bytes.Length >= Size && BinaryPrimitives.ReadUInt32LittleEndian(bytes[^Size..]) == Of(bytes[..^Size]);

    private static uint[] Table()
    {
        var table = new uint[256];
        for (uint i = 0; i < table.Length; i++)
        {
            // Compute the remainder of each byte value by shifting out its eight bits.
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
