using System.Buffers.Binary;
using System.Runtime.InteropServices;

namespace FootballPhysics.Tracks;

/// <summary>The bytes of a filter: the same calls measure, write or read them.</summary>
internal ref struct FilterStream
{
    private readonly Span<byte> _bytes;
    private readonly bool _reads;

    /// <summary>Creates a stream that writes; an empty span only measures.</summary>
    public FilterStream(Span<byte> bytes, bool reads)
    {
        _bytes = bytes;
        _reads = reads;
        Count = 0;
    }

    /// <summary>The number of bytes so far.</summary>
    public int Count { get; private set; }

    public readonly bool Reads => _reads;

    public void Number(ref double value)
    {
        if (_bytes.Length > 0)
        {
            Span<byte> at = _bytes.Slice(Count, sizeof(double));
            if (_reads)
            {
                value = BitConverter.Int64BitsToDouble(BinaryPrimitives.ReadInt64LittleEndian(at));
            }
            else
            {
                BinaryPrimitives.WriteInt64LittleEndian(at, BitConverter.DoubleToInt64Bits(value));
            }
        }

        Count += sizeof(double);
    }

    public void Whole(ref int value)
    {
        if (_bytes.Length > 0)
        {
            Span<byte> at = _bytes.Slice(Count, sizeof(int));
            if (_reads)
            {
                value = BinaryPrimitives.ReadInt32LittleEndian(at);
            }
            else
            {
                BinaryPrimitives.WriteInt32LittleEndian(at, value);
            }
        }

        Count += sizeof(int);
    }

    public void Flag(ref bool value)
    {
        int number = value ? 1 : 0;
        Whole(ref number);
        value = number != 0;
    }

    public void Numbers(scoped Span<double> values)
    {
        for (int i = 0; i < values.Length; i++)
        {
            Number(ref values[i]);
        }
    }

    public double Number(double value)
    {
        Number(ref value);
        return value;
    }

    public int Whole(int value)
    {
        Whole(ref value);
        return value;
    }

    public bool Flag(bool value)
    {
        Flag(ref value);
        return value;
    }

    /// <summary>The bytes of plain values, such as states.</summary>
    public void Plain<T>(scoped Span<T> values)
        where T : unmanaged
    {
        Span<byte> bytes = MemoryMarshal.AsBytes(values);
        if (_bytes.Length > 0)
        {
            Span<byte> at = _bytes.Slice(Count, bytes.Length);
            if (_reads)
            {
                at.CopyTo(bytes);
            }
            else
            {
                bytes.CopyTo(at);
            }
        }

        Count += bytes.Length;
    }
}
