namespace FootballPhysics.Game;

/// <summary>Appends numbers to a byte buffer, little-endian.</summary>
internal struct ByteWriter
{
    private byte[]? _bytes;
    private int _count;

    /// <summary>Appends the low bytes of a word.</summary>
    public void Bits(ulong word, int bytes)
    {
        Reserve(bytes);
        for (int i = 0; i < bytes; i++)
        {
            _bytes![_count++] = (byte)(word >> (i << 3));
        }
    }

    /// <summary>Appends an integer in as many groups of seven bits as it needs.</summary>
    public void Integer(ulong value)
    {
        // 64 bits need at most ten groups of seven.
        Reserve(10);
        for (; value >= 0x80; value >>= 7)
        {
            _bytes![_count++] = (byte)(value | 0x80);
        }

        _bytes![_count++] = (byte)value;
    }

    /// <summary>Appends a state.</summary>
    public void State(in BallState state)
    {
        Reserve(Snapshot.Size);
        Snapshot.Write(in state, _bytes.AsSpan(_count));
        _count += Snapshot.Size;
    }

    /// <summary>Returns the bytes written, followed by their checksum.</summary>
    public byte[] ToArray()
    {
        // Reserve the checksum at the end; it covers all bytes before it.
        Bits(0, Crc32.Size);
        byte[] all = _bytes.AsSpan(0, _count).ToArray();
        Crc32.Seal(all);
        return all;
    }

    private void Reserve(int bytes)
    {
        int needed = _count + bytes;
        if (_bytes is null || needed > _bytes.Length)
        {
            Array.Resize(ref _bytes, Math.Max(needed, 2 * _count));
        }
    }
}
