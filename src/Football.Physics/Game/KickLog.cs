using System.Globalization;
using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics.Netcode;

/// <summary>Kicks sorted by tick: the schedule of a <see cref="FixedStepRunner"/> and the input log of a match.</summary>
/// <remarks>
/// The kicks are sorted by tick, then player, then ball, regardless of the order in which they arrive. The log allocates only when it grows. A serialised kick
/// takes about 28 bytes if its numbers are single-precision values, and about 52 otherwise. Numbers that are 0 take no bytes. A 4-byte checksum follows
/// all kicks.
/// </remarks>
public sealed class KickLog
{
    private readonly KickTree _kicks;
    private readonly int _balls = KickInput.MostBalls;

    /// <summary>Creates an empty log.</summary>
    /// <param name="capacity">The initial capacity, at least 1; default 64.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is below 1.</exception>
    public KickLog(int capacity = 64)
    {
        Check.AtLeast(nameof(capacity), capacity, 1);
        _kicks = new KickTree(capacity);
    }

    /// <summary>Creates an empty log for a runner with the given number of balls.</summary>
    internal KickLog(int capacity, int balls)
        : this(capacity) => _balls = balls;

    /// <summary>The number of kicks.</summary>
    public int Count => _kicks.Count;

    /// <summary>Gets a kick by its index.</summary>
    /// <param name="index">The index, from 0 and below <see cref="Count"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such kick.</exception>
    public ref readonly KickInput this[int index]
    {
        get
        {
            if ((uint)index >= (uint)Count)
            {
                throw Check.Refusal(nameof(index), index.ToString(CultureInfo.InvariantCulture), $"0 … {Count - 1}");
            }

            return ref _kicks.At(index);
        }
    }

    /// <summary>Adds a kick in order, or replaces one with the same tick, player and ball.</summary>
    /// <param name="kick">The kick.</param>
    /// <exception cref="ArgumentOutOfRangeException">The runner that owns this log does not have this ball; nothing has changed.</exception>
    public void Add(in KickInput kick)
    {
        // A kick may come from the network: reject an unknown ball at once, not in the middle of a step.
        Check.Index("kick.ball", kick.Ball, _balls);

        // Sort when inserting, so that kicks are applied in the same order whatever their order of arrival.
        _kicks.Put(in kick);
    }

    /// <summary>Removes a kick, for instance one that was only predicted.</summary>
    /// <param name="tick">The tick.</param>
    /// <param name="player">The player; default 0.</param>
    /// <param name="ball">The ball; default 0.</param>
    /// <returns>True if there was such a kick.</returns>
    public bool Remove(long tick, int player = 0, int ball = 0) => _kicks.Remove(tick, player, ball);

    /// <summary>Removes the kicks before a tick, for instance those too old for a rollback.</summary>
    /// <param name="tick">The first tick to keep.</param>
    internal void RemoveBefore(long tick) => _kicks.RemoveFirst(FirstAt(tick));

    /// <summary>Removes the kicks at or after a tick, for instance when the ball is moved.</summary>
    /// <param name="tick">The first tick to remove.</param>
    public void RemoveFrom(long tick)
    {
        int kept = FirstAt(tick);
        while (Count > kept)
        {
            KickInput last = _kicks.At(Count - 1);
            _kicks.Remove(last.Tick, last.Player, last.Ball);
        }
    }

    /// <summary>Removes the kicks of one ball at or after a tick.</summary>
    internal void RemoveFrom(long tick, int ball)
    {
        for (int i = FirstAt(tick); i < Count;)
        {
            KickInput kick = _kicks.At(i);
            i += kick.Ball == ball && Remove(kick.Tick, kick.Player, ball) ? 0 : 1;
        }
    }

    /// <summary>Returns the index of the first kick at or after a tick; <see cref="Count"/> if there is none.</summary>
    /// <param name="tick">The tick.</param>
    public int FirstAt(long tick) => _kicks.CountBefore(tick, 0, 0);

    /// <summary>Removes all kicks, but keeps the capacity.</summary>
    public void Clear() => _kicks.Clear();

    /// <summary>Serialises the log; the bytes are the same on every machine.</summary>
    public byte[] ToBytes()
    {
        var writer = new ByteWriter();
        Write(ref writer);
        return writer.ToArray();
    }

    /// <summary>Reads a log written by <see cref="ToBytes"/>.</summary>
    /// <param name="bytes">The bytes; all of them are used.</param>
    /// <exception cref="FormatException">The bytes are not a kick log, or are corrupt; the message states the reason.</exception>
    public static KickLog FromBytes(ReadOnlySpan<byte> bytes)
    {
        var reader = new ByteReader(bytes);
        KickLog log = Read(ref reader);
        reader.End();
        return log;
    }

    internal void Write(ref ByteWriter writer)
    {
        // The number of kicks, then for each kick: ticks since the last kick, player, ball, velocity and spin.
        writer.Integer((ulong)Count);
        long last = 0;
        for (int i = 0; i < Count; i++)
        {
            ref readonly KickInput kick = ref _kicks.At(i);
            writer.Integer((ulong)(kick.Tick - last));
            writer.Integer((ulong)kick.Player);
            KickBytes.Write(in kick, ref writer);
            last = kick.Tick;
        }
    }

    internal static KickLog Read(ref ByteReader reader)
    {
        int count = reader.Count(KickBytes.Smallest);
        var log = new KickLog(Math.Max(count, 1));
        long tick = 0;
        for (int i = 0; i < count; i++)
        {
            // A sum that exceeds 63 bits becomes negative, and KickInput rejects it.
            tick += reader.Long();
            KickInput kick = KickBytes.Read(tick, reader.Int(), ref reader);
            if (i > 0 && log._kicks.At(i - 1).Order(kick.Tick, kick.Player, kick.Ball) >= 0)
            {
                // Require sorted kicks without duplicates, so that every log has exactly one encoding.
                throw ByteReader.Broken("two kicks are not in order, or of one player and one ball at one tick");
            }

            log._kicks.Put(in kick);
        }

        return log;
    }
}
