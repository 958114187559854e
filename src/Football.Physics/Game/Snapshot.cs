using System.Runtime.CompilerServices;
using FootballPhysics.Game;
using FootballPhysics.Numerics;
using FootballPhysics.State;

namespace FootballPhysics.Netcode;

/// <summary>Operations on a <see cref="BallState"/> for rollback and lockstep: bitwise equality, hash and serialisation.</summary>
/// <remarks>Copy the struct to take a snapshot. The hash, the bytes and the byte order are the same on every runtime.</remarks>
public static class Snapshot
{
    /// <summary>The number of bytes that <see cref="Write"/> writes: the fields and a 4-byte checksum.</summary>
    public const int Size = Fields + Crc32.Size;

    /// <summary>The number of bytes that <see cref="TryWriteQuantized"/> writes.</summary>
    public const int QuantizedSize = WireForm.Size;

    private const int Fields = StateFields.Count * sizeof(ulong);

    /// <summary>Returns a 64-bit hash over the bits of every field.</summary>
    /// <remarks>Equal states have equal hashes, and a single flipped bit changes the hash.</remarks>
    /// <param name="state">The state.</param>
    public static ulong Hash(in BallState state)
    {
        BallState copy = state;
        var hasher = new FieldHasher { Hash = FieldHasher.Start };
        StateFields.Visit(ref copy, ref hasher);
        return hasher.Result;
    }

    /// <summary>Returns the hash of several states; for one state, it equals that state's hash.</summary>
    /// <param name="states">The states.</param>
    /// <exception cref="ArgumentNullException"><paramref name="states"/> is null.</exception>
    public static ulong Hash(BallState[] states)
    {
        Check.Given(nameof(states), states);
        ulong hash = 0;
        for (int i = 0; i < states.Length; i++)
        {
            hash = Hash(i, hash, Hash(in states[i]));
        }

        return hash;
    }

    /// <summary>Adds the hash of a ball to the hash of the balls before it. For the first ball, the result is the ball's own hash.</summary>
    internal static ulong Hash(int ball, ulong before, ulong own) =>
        ball == 0 ? own : ((before ^ own) * 0x9FB21C651E98DF25UL) ^ (before >> 32); // Multiply between the hashes, so that the order of the balls matters.

    /// <summary>True if two states are bit-identical.</summary>
    /// <remarks>Unlike ==, 0 and −0 differ, and NaN equals itself.</remarks>
    /// <param name="a">The first state.</param>
    /// <param name="b">The second state.</param>
    public static bool Same(in BallState a, in BallState b)
    {
        // Compare words, not numbers, so that every bit of every field counts.
        Span<ulong> left = stackalloc ulong[StateFields.Count];
        Span<ulong> right = stackalloc ulong[StateFields.Count];
        StateFields.Read(in a, left);
        StateFields.Read(in b, right);
        return left.SequenceEqual(right);
    }

    /// <summary>Returns the first field in which two states differ bitwise.</summary>
    /// <param name="expected">The first state.</param>
    /// <param name="actual">The second state.</param>
    /// <returns>The field and both values; null if the states are bit-identical.</returns>
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
    /// <param name="destination">The destination; at least <see cref="Size"/> bytes.</param>
    /// <exception cref="ArgumentException"><paramref name="destination"/> is too short, or <paramref name="state"/> was never launched.</exception>
    public static void Write(in BallState state, Span<byte> destination)
    {
        BallState.Launched(in state);
        Check.Bytes(nameof(destination), destination.Length, Size);
        Span<ulong> words = stackalloc ulong[StateFields.Count];
        StateFields.Read(in state, words);
        for (int i = 0; i < Fields; i++)
        {
            // Byte i is byte i mod 8 of word i/8, lowest byte first, regardless of the machine's byte order.
            destination[i] = (byte)(words[i >> 3] >> ((i & 7) << 3));
        }

        // The last four bytes are the checksum of the fields.
        Crc32.Seal(destination.Slice(0, Size));
    }

    /// <summary>Reads a state written by <see cref="Write"/>.</summary>
    /// <param name="source">At least <see cref="Size"/> bytes; more are ignored.</param>
    /// <exception cref="ArgumentException"><paramref name="source"/> is too short.</exception>
    /// <exception cref="FormatException">The bytes are not a valid state; the message states the reason. The checksum is wrong, an enum value is
    /// unknown, or a number is not finite or exceeds 1e45 m, 1e30 m/s, 1e35 rad/s or 1e15 s.</exception>
    public static BallState Read(ReadOnlySpan<byte> source)
    {
        Check.Bytes(nameof(source), source.Length, Size);
        // Copy the bytes, so that no other thread can change them after the check.
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
            // Read byte by byte, regardless of the machine's byte order and alignment.
            words[i >> 3] |= (ulong)bytes[i] << ((i & 7) << 3);
        }

        // Earlier versions stored limits of the next contact here.
        words.Slice(StateFields.Used).Clear();
        BallState state = default;
        StateFields.Write(words, ref state);
        try
        {
            // A valid checksum does not imply a valid state: a sender may write NaN.
            StateCheck.Validate(in state);
        }
        catch (ArgumentOutOfRangeException refusal)
        {
            throw ByteReader.Broken(refusal);
        }

        return state;
    }

    /// <summary>Writes a state in <see cref="QuantizedSize"/> bytes, if these bytes can represent the state exactly.</summary>
    /// <remarks>The method succeeds at the ticks at which <see cref="FixedStepRunner.QuantizationInterval"/> rounds the state.</remarks>
    /// <param name="runner">The match to which the state belongs.</param>
    /// <param name="state">The state: <see cref="FixedStepRunner.State"/>, or one stored by a <see cref="Rollback"/>.</param>
    /// <param name="destination">The destination; at least <see cref="QuantizedSize"/> bytes.</param>
    /// <param name="ball">The index of the ball; default 0.</param>
    /// <returns>False if the state needs the full size of <see cref="Write"/>; the destination is then unspecified.</returns>
    /// <exception cref="ArgumentNullException"><paramref name="runner"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    /// <exception cref="ArgumentException"><paramref name="destination"/> is too short, or <paramref name="state"/> was never launched.</exception>
    public static bool TryWriteQuantized(this FixedStepRunner runner, in BallState state, Span<byte> destination, int ball = 0)
    {
        Check.Given(nameof(runner), runner);
        Check.Index(nameof(ball), ball, runner.Balls);
        BallState.Launched(in state);
        return WireForm.TryWrite(runner.SimulatorOf(ball), runner.TimeStep, in state, destination);
    }

    /// <summary>Reads a state written by <see cref="TryWriteQuantized"/>; the result is bit-identical.</summary>
    /// <param name="runner">The match to which the state belongs.</param>
    /// <param name="source">At least <see cref="QuantizedSize"/> bytes; more are ignored.</param>
    /// <param name="ball">The index of the ball; default 0.</param>
    /// <exception cref="ArgumentNullException"><paramref name="runner"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">There is no such ball.</exception>
    /// <exception cref="ArgumentException"><paramref name="source"/> is too short.</exception>
    /// <exception cref="FormatException">The bytes are not a valid state.</exception>
    public static BallState ReadQuantized(this FixedStepRunner runner, ReadOnlySpan<byte> source, int ball = 0)
    {
        Check.Given(nameof(runner), runner);
        Check.Index(nameof(ball), ball, runner.Balls);
        return WireForm.Read(runner.SimulatorOf(ball), runner.TimeStep, source);
    }

    /// <summary>Combines the fields into one hash.</summary>
    private struct FieldHasher : IFieldVisitor
    {
        public const ulong Start = 0x9E3779B97F4A7C15UL;

        public ulong Hash;

        private ulong _place;

        public readonly ulong Result
        {
            get
            {
                // Use MurmurHash3's finaliser: every input bit affects every output bit.
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
            // Skip fields that are zero, so that fields which a plain ball does not use leave its hash unchanged. Mix every other field with its index.
            _place++;
            if (value != 0)
            {
                Mix(value ^ (_place * 0xD6E8FEB86659FD93UL));
            }
        }

        private void Mix(ulong word)
        {
            // Each step is a bijection of the hash: xor, multiply by an odd number, and fold the high half into the low half.
            ulong h = (Hash ^ word) * 0x9FB21C651E98DF25UL;
            Hash = h ^ (h >> 32);
        }
    }
}
