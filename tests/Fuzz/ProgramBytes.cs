using System.Buffers.Binary;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Fuzz;

/// <summary>The bytes of a program, read from first to last; zeros follow.</summary>
/// <param name="bytes">The bytes.</param>
/// <param name="more">Makes further bytes, to write a program by reading it; null for no more.</param>
internal sealed class ProgramBytes(byte[] bytes, SeededRandom? more = null)
{
    /// <summary>A token of a number from here on is followed by its eight bytes.</summary>
    private const int Raw = 0xF0;

    private static readonly double[] s_numbers =
    [
        0, 0.01, 1 / 60.0, 0.11, 0.3, 0.5, 1, 1.5, 2, 3, 5, 8, 12, 20, 28, 60, -0.3, -1, -2, -5, -9, -12, -20, -60, 0.001, 1e-9, 1e-12, 0.25, 400, 1000, 3600, 1e4,
        1e6, 1e12, double.Epsilon, double.MaxValue, double.NaN, double.PositiveInfinity, double.NegativeInfinity, -0.0,
    ];

    private readonly List<byte> _bytes = [.. bytes];
    private int _at;

    public bool IsOver => _at >= _bytes.Count;

    public int Length => _bytes.Count;

    public byte[] ToArray() => [.. _bytes];

    /// <summary>Removes the bytes from a place on.</summary>
    public void Shorten(int length)
    {
        _bytes.RemoveRange(length, _bytes.Count - length);
        _at = length;
    }

    /// <summary>Writes the next byte, of a program that is being made.</summary>
    public void Add(byte value) => _bytes.Add(value);

    public byte Byte()
    {
        if (IsOver && more is not null)
        {
            // Seldom null, a wild count or a number of eight bytes.
            Add((byte)(more.Chance(0.97) ? more.Below(40) : more.Below(256)));
        }

        return IsOver ? (byte)0 : _bytes[_at++];
    }

    public byte[] Take(int count) => [.. Enumerable.Range(0, count).Select(_ => Byte())];

    public long Word() => BinaryPrimitives.ReadInt64LittleEndian(Take(sizeof(long)));

    public double Number() => Byte() is var token && token >= Raw ? BitConverter.Int64BitsToDouble(Word()) : s_numbers[token % s_numbers.Length];
}
