using System.Buffers.Binary;
using System.Runtime.InteropServices;

namespace FootballPhysics;

/// <summary>The checksum CRC-32 (IEEE 802.3, as in Ethernet, zip and PNG): it finds every change of up to 32 neighbouring bits.</summary>
internal static class Crc32
{
    /// <summary>Bytes that it takes.</summary>
    public const int Size = 4;

    private const uint Polynomial = 0xEDB88320;

    private static readonly uint[] s_table = Table();

    /// <summary>The checksum of some bytes. By their address: the items of a read-only span cannot be asked for on older runtimes of Mono.</summary>
    public static unsafe uint Of(ReadOnlySpan<byte> bytes)
    {
        uint crc = uint.MaxValue;
        fixed (byte* first = &MemoryMarshal.GetReference(bytes))
        {
            for (int i = 0; i < bytes.Length; i++)
            {
                // A byte at a time; the bits are reflected, lowest first, as in zip.
                crc = (crc >> 8) ^ s_table[(byte)(crc ^ first[i])];
            }
        }

        return ~crc;
    }

    /// <summary>Writes the checksum of all bytes but the last four there, little-endian.</summary>
    public static void Seal(Span<byte> bytes) => BinaryPrimitives.WriteUInt32LittleEndian(bytes[^Size..], Of(bytes[..^Size]));

    /// <summary>True when the last four bytes are the checksum of those before.</summary>
    public static bool Holds(ReadOnlySpan<byte> bytes) =>
        bytes.Length >= Size && BinaryPrimitives.ReadUInt32LittleEndian(bytes[^Size..]) == Of(bytes[..^Size]);

    private static uint[] Table()
    {
        var table = new uint[256];
        for (uint i = 0; i < table.Length; i++)
        {
            // The remainder of each byte, by shifting out its eight bits.
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
