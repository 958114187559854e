using System.Runtime.CompilerServices;

namespace FootballPhysics.Netcode;

/// <summary>Operations that rollback and lockstep need of a <see cref="BallState"/>: sameness to the bit, a hash, and bytes to send.</summary>
/// <remarks>The snapshot itself is a copy of the struct. Hash and bytes are the same on every runtime, byte order included.</remarks>
public static class Snapshot
{
    /// <summary>How many bytes <see cref="Write"/> makes of a state: its fields, and a checksum of four bytes.</summary>
    public const int Size = Fields + Crc32.Size;

    /// <summary>How many bytes <see cref="FixedStepRunner.TryWriteQuantized"/> makes of a state.</summary>
    public const int QuantizedSize = WireForm.Size;

    private const int Fields = StateFields.Count * sizeof(ulong);

    /// <summary>A 64-bit hash over the bits of every field: equal states have equal hashes, and one flipped bit changes it.</summary>
    /// <param name="state">The state.</param>
    public static ulong Hash(in BallState state)
    {
        BallState copy = state;
        var hasher = new FieldHasher { Hash = FieldHasher.Start };
        StateFields.Visit(ref copy, ref hasher);
        return hasher.Result;
    }

    /// <summary>The hash of several states: that of the one where there is one.</summary>
    /// <param name="states">The states.</param>
    /// <exception cref="ArgumentNullException"><paramref name="states"/> is null.</exception>
    public static ulong Hash(BallState[] states)
    {
        Check.Given(nameof(states), states);
        ulong hash = 0;
        for (int i = 0; i < states.Length; i++)
        {
            // A hash of hashes: multiplied in between, so that the order of the balls counts.
            ulong own = Hash(in states[i]);
            hash = i == 0 ? own : ((hash ^ own) * 0x9FB21C651E98DF25UL) ^ (hash >> 32);
        }

        return hash;
    }

    /// <summary>True when two states are the same to the last bit; unlike ==, 0 and −0 differ and NaN equals itself.</summary>
    /// <param name="a">One state.</param>
    /// <param name="b">The other state.</param>
    public static bool Same(in BallState a, in BallState b)
    {
        // Words are compared, not numbers: every field counts, and each bit of it.
        Span<ulong> left = stackalloc ulong[StateFields.Count];
        Span<ulong> right = stackalloc ulong[StateFields.Count];
        StateFields.Read(in a, left);
        StateFields.Read(in b, right);
        return left.SequenceEqual(right);
    }

    /// <summary>Tells in which field two states differ first, to the last bit.</summary>
    /// <param name="expected">One state.</param>
    /// <param name="actual">The other state.</param>
    /// <returns>The field and both values; null where the states are the same.</returns>
    public static StateDifference? Difference(in BallState expected, in BallState actual)
    {
        Span<ulong> left = stackalloc ulong[StateFields.Count];
        Span<ulong> right = stackalloc ulong[StateFields.Count];
        StateFields.Read(in expected, left);
        StateFields.Read(in actual, right);
        for (int i = 0; i < StateFields.Count; i++)
        {
            if (left[i] != right[i])
            {
                return new StateDifference(-1, 0, i, left[i], right[i]);
            }
        }

        return null;
    }

    /// <summary>Writes a state as bytes, little-endian on every machine.</summary>
    /// <param name="state">The state.</param>
    /// <param name="destination">Where to; at least <see cref="Size"/> bytes.</param>
    /// <exception cref="ArgumentException"><paramref name="destination"/> is too short.</exception>
    public static void Write(in BallState state, Span<byte> destination)
    {
        if (destination.Length < Size)
        {
            throw new ArgumentException($"destination has {destination.Length} bytes; allowed: {Size} or more.", nameof(destination));
        }

        Span<ulong> words = stackalloc ulong[StateFields.Count];
        StateFields.Read(in state, words);
        for (int i = 0; i < Fields; i++)
        {
            // Byte i is byte i mod 8 of word i/8, lowest first, whatever the machine.
            destination[i] = (byte)(words[i >> 3] >> ((i & 7) << 3));
        }

        // The last four bytes are the checksum of the fields.
        Crc32.Seal(destination.Slice(0, Size));
    }

    /// <summary>Reads what <see cref="Write"/> wrote.</summary>
    /// <param name="source">At least <see cref="Size"/> bytes; more are ignored.</param>
    /// <exception cref="ArgumentException"><paramref name="source"/> is too short.</exception>
    /// <exception cref="FormatException">
    /// The bytes are no state of a ball, and the message says why: the checksum does not hold, an enumeration has no such member, or a number is
    /// not finite or so large that no ball gets there: 1e45 m, 1e30 m/s, 1e35 rad/s, 1e15 s.
    /// </exception>
    public static BallState Read(ReadOnlySpan<byte> source)
    {
        if (source.Length < Size)
        {
            throw new ArgumentException($"source has {source.Length} bytes; allowed: {Size} or more.", nameof(source));
        }

        // A copy: whoever else may write there cannot change it after it was checked.
        Span<byte> bytes = stackalloc byte[Size];
        source.Slice(0, Size).CopyTo(bytes);
        if (!Crc32.Holds(bytes))
        {
            throw ByteReader.Damaged();
        }

        Span<ulong> words = stackalloc ulong[StateFields.Count];
        words.Clear();
        for (int i = 0; i < Fields; i++)
        {
            // Byte by byte: neither the order of bytes nor the alignment of a machine matters.
            words[i >> 3] |= (ulong)bytes[i] << ((i & 7) << 3);
        }

        BallState state = default;
        StateFields.Write(words, ref state);
        try
        {
            // A right checksum says only that the bytes are what was written: a sender may write NaN.
            StateCheck.Validate(in state);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }

        return state;
    }

    /// <summary>Mixes the fields into one number.</summary>
    private struct FieldHasher : IFieldVisitor
    {
        public const ulong Start = 0x9E3779B97F4A7C15UL;

        public ulong Hash;

        private ulong _place;

        public readonly ulong Result
        {
            get
            {
                // The finaliser of MurmurHash3: every bit of the input reaches every bit of the output.
                ulong h = Hash;
                h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCDUL;
                h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53UL;
                return h ^ (h >> 33);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Number(ref double value) => Mix((ulong)BitConverter.DoubleToInt64Bits(value));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Member(ref int value) => Mix((ulong)(uint)value);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Bits(ref ulong value)
        {
            // Without a set bit it is as if the field were not there: its place counts instead, with the bits.
            _place++;
            if (value != 0)
            {
                Mix(value ^ (_place * 0xD6E8FEB86659FD93UL));
            }
        }

        private void Mix(ulong word)
        {
            // Xor, multiply by an odd number, fold the high half down: each step is a bijection of the hash.
            ulong h = (Hash ^ word) * 0x9FB21C651E98DF25UL;
            Hash = h ^ (h >> 32);
        }
    }
}
