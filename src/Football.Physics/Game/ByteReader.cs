namespace FootballPhysics.Game;

/// <summary>Reads numbers from untrusted bytes; invalid input throws <see cref="FormatException"/>.</summary>
internal struct ByteReader
{
    private readonly byte[] _bytes;
    private readonly int _end;
    private int _at;

    /// <summary>Starts at the first byte of a byte sequence that ends with its checksum.</summary>
    /// <exception cref="FormatException">The checksum does not match.</exception>
    public ByteReader(ReadOnlySpan<byte> bytes)
    {
        // Copy the bytes, so that nobody can change them between the check and the read.
        byte[] copy = bytes.ToArray();
        if (!Crc32.Holds(copy))
        {
            throw Damaged();
        }

        _bytes = copy;
        _end = copy.Length - Crc32.Size;
        _at = 0;
    }

    public static FormatException Broken(string what) => new($"The bytes are broken: {what}.");

    /// <summary>Returns the exception for a number that is out of range.</summary>
    public static FormatException Broken(ArgumentOutOfRangeException refusal)
    {
        // Remove the parameter suffix that the runtime appends, because it contains an internal name.
        string message = refusal.Message;
        int end = message.LastIndexOf(". (Parameter", StringComparison.Ordinal);
        return new FormatException($"The bytes are broken: {(end > 0 ? message[..end] : message)}.", refusal);
    }

    public static FormatException Damaged() => Broken("their checksum does not hold");

    public ulong Bits(int bytes)
    {
        Need(bytes);
        ulong word = 0;
        for (int i = 0; i < bytes; i++)
        {
            word |= (ulong)_bytes[_at++] << (i << 3);
        }

        return word;
    }

    public long Long()
    {
        ulong value = 0;

        // Read groups of seven bits, lowest group first; the top bit of each byte is set if another byte follows.
        for (int shift = 0; shift < 63; shift += 7)
        {
            Need(1);
            byte part = _bytes[_at++];
            value |= (ulong)(part & 0x7F) << shift;
            if (part < 0x80)
            {
                return (long)value;
            }
        }

        throw Broken("an integer beyond 63 bits");
    }

    public int Int()
    {
        long value = Long();
        return value <= int.MaxValue ? (int)value : throw Broken("an integer beyond 31 bits");
    }

    /// <summary>Reads a number of items of at least the given size; rejects the number, before any allocation, if the items need more bytes than are left.</summary>
    public int Count(int smallest)
    {
        int count = Int();
        return count <= (_end - _at) / smallest ? count : throw Broken("they end too early");
    }

    public BallState State()
    {
        Need(Snapshot.Size);
        BallState state = Snapshot.Read(_bytes.AsSpan(_at));
        _at += Snapshot.Size;
        return state;
    }

    /// <summary>True if all bytes before the checksum are read.</summary>
    public readonly bool IsAtEnd => _at == _end;

    public readonly void End()
    {
        if (!IsAtEnd)
        {
            throw Broken("something follows their end");
        }
    }

    private readonly void Need(int bytes)
    {
        if (_end - _at < bytes)
        {
            throw Broken("they end too early");
        }
    }
}
