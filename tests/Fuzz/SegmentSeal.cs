using FootballPhysics.Labs.Fuzz;

namespace FootballPhysics.Fuzz;

/// <summary>Writes the checksums of a recording: those of the states at its start, then its own.</summary>
internal static class SegmentSeal
{
    /// <summary>Bytes before the version; between version and first tick: scene and time step; after the quantisation: whether an engine moved colliders.</summary>
    private const int Format = 5;

    private const int SceneAndStep = 16;
    private const int Flag = 1;

    /// <summary>The offset of the hash of the scene; negative if the bytes end before it.</summary>
    public static int SceneAt(ReadOnlySpan<byte> bytes)
    {
        int at = Format;
        long length = Integer(bytes, ref at);
        return length >= 0 && length < bytes.Length && at + length + SceneAndStep <= bytes.Length ? at + (int)length : -1;
    }

    public static byte[] Sealed(byte[] bytes)
    {
        byte[] whole = [.. bytes];
        int at = SceneAt(whole);
        if (at >= 0)
        {
            at += SceneAndStep;
            Integer(whole, ref at);
            Integer(whole, ref at);
            at += Flag;
            long balls = Integer(whole, ref at);
            for (; balls > 0 && at + Snapshot.Size <= whole.Length; balls--, at += Snapshot.Size)
            {
                FuzzBytes.Sealed(whole[at..(at + Snapshot.Size)]).CopyTo(whole, at);
            }
        }

        return FuzzBytes.Sealed(whole);
    }

    /// <summary>An integer in groups of seven bits; -1 at the end of the bytes.</summary>
    private static long Integer(ReadOnlySpan<byte> bytes, ref int at)
    {
        long value = 0;
        for (int shift = 0; shift < 63 && at < bytes.Length; shift += 7)
        {
            byte part = bytes[at++];
            value |= (long)(part & 0x7F) << shift;
            if (part < 0x80)
            {
                return value;
            }
        }

        return -1;
    }
}
