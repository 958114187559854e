using System.Buffers;
using System.Text;

namespace FootballPhysics.Tool.Sweep.Formats;

/// <summary>
/// Writes structures in Thrift's compact protocol, for Parquet's headers and footers. Fields are in ascending order, each with its type and the
/// difference of its number from that of the field before.
/// </summary>
internal sealed class ThriftWriter
{
    private const int Whole32 = 5;
    private const int Whole64 = 6;
    private const int Binary = 8;
    private const int List = 9;
    private const int Structure = 12;

    private readonly ArrayBufferWriter<byte> _to = new();
    private readonly Stack<int> _before = new();
    private int _last;

    /// <summary>The bytes written, including the end of the outermost structure.</summary>
    public byte[] End() => [.. _to.WrittenSpan, 0];

    public ThriftWriter Number(int field, int value)
    {
        Field(field, Whole32);
        Variable(Zigzag(value));
        return this;
    }

    public ThriftWriter Number(int field, long value)
    {
        Field(field, Whole64);
        Variable(Zigzag(value));
        return this;
    }

    public ThriftWriter Text(int field, string value)
    {
        Field(field, Binary);
        Text(value);
        return this;
    }

    /// <summary>Writes a structure as a field.</summary>
    public ThriftWriter Struct(int field, Action<ThriftWriter> members)
    {
        Field(field, Structure);
        Members(members);
        return this;
    }

    /// <summary>Writes a list of structures.</summary>
    public ThriftWriter Structs<T>(int field, IReadOnlyList<T> items, Action<ThriftWriter, T> members)
    {
        Begin(field, items.Count, Structure);
        foreach (T item in items)
        {
            Members(to => members(to, item));
        }

        return this;
    }

    public ThriftWriter Numbers(int field, params ReadOnlySpan<int> items)
    {
        Begin(field, items.Length, Whole32);
        foreach (int item in items)
        {
            Variable(Zigzag(item));
        }

        return this;
    }

    public ThriftWriter Texts(int field, params ReadOnlySpan<string> items)
    {
        Begin(field, items.Length, Binary);
        foreach (string item in items)
        {
            Text(item);
        }

        return this;
    }

    private static ulong Zigzag(long value) => (ulong)((value << 1) ^ (value >> 63));

    private void Members(Action<ThriftWriter> members)
    {
        _before.Push(_last);
        _last = 0;
        members(this);
        Byte(0);
        _last = _before.Pop();
    }

    private void Begin(int field, int count, int type)
    {
        Field(field, List);
        Byte((byte)((Math.Min(count, 15) << 4) | type));
        if (count >= 15)
        {
            Variable((ulong)count);
        }
    }

    private void Field(int field, int type)
    {
        // The field numbers of Parquet's structures differ by at most 15 from that of the field before.
        Byte((byte)(((field - _last) << 4) | type));
        _last = field;
    }

    private void Text(string value)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(value);
        Variable((ulong)bytes.Length);
        _to.Write(bytes);
    }

    private void Variable(ulong value)
    {
        for (; value >= 0x80; value >>= 7)
        {
            Byte((byte)(value | 0x80));
        }

        Byte((byte)value);
    }

    private void Byte(byte value)
    {
        _to.GetSpan(1)[0] = value;
        _to.Advance(1);
    }
}
