using System.Globalization;

namespace FootballPhysics.Netcode;

/// <summary>Kicks by tick, past and to come: the schedule of a <see cref="FixedStepRunner"/> and the input log of a match.</summary>
/// <remarks>
/// Sorted by tick, then player, then ball, whatever the order of arrival. It allocates only when it outgrows its memory. As bytes a kick takes
/// about 28 where all its numbers are single-precision ones, about 52 otherwise, and less where some are 0; the whole ends with a checksum of 4.
/// </remarks>
public sealed class KickLog
{
    private readonly KickTree _kicks;
    private readonly int _balls = KickInput.MostBalls;

    /// <summary>Makes an empty log.</summary>
    /// <param name="capacity">Kicks to make room for, at least 1; default 64.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is below 1.</exception>
    public KickLog(int capacity = 64)
    {
        Check.AtLeast(nameof(capacity), capacity, 1);
        _kicks = new KickTree(capacity);
    }

    /// <summary>Makes an empty log of a runner, which has so many balls.</summary>
    internal KickLog(int capacity, int balls)
        : this(capacity) => _balls = balls;

    /// <summary>How many kicks there are.</summary>
    public int Count => _kicks.Count;

    /// <summary>One kick.</summary>
    /// <param name="index">From 0, below <see cref="Count"/>.</param>
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

    /// <summary>Puts a kick in its place; one of the same player at the same tick, of the same ball, is replaced.</summary>
    /// <param name="kick">The kick.</param>
    /// <exception cref="ArgumentOutOfRangeException">It is for a ball that the runner, whose log this is, does not have; nothing has changed.</exception>
    public void Add(in KickInput kick)
    {
        // A kick may come from outside: one for no ball is refused when it arrives, not in the middle of a step.
        Check.Index("kick.ball", kick.Ball, _balls);

        // Sorted as it is added: who arrives first makes no difference to the order in which kicks act.
        _kicks.Put(in kick);
    }

    /// <summary>Takes a kick out, for instance one that was only guessed.</summary>
    /// <param name="tick">Its tick.</param>
    /// <param name="player">Its player; default 0.</param>
    /// <param name="ball">Its ball; default 0.</param>
    /// <returns>True when there was such a kick.</returns>
    public bool Remove(long tick, int player = 0, int ball = 0) => _kicks.Remove(tick, player, ball);

    /// <summary>Forgets the kicks before a tick, for instance those that can no longer be rolled back.</summary>
    /// <param name="tick">The first tick that is kept.</param>
    public void RemoveBefore(long tick) => _kicks.RemoveFirst(FirstAt(tick));

    /// <summary>Forgets the kicks at a tick and later, for instance where the ball is put elsewhere.</summary>
    /// <param name="tick">The first tick that is forgotten.</param>
    public void RemoveFrom(long tick)
    {
        int kept = FirstAt(tick);
        while (Count > kept)
        {
            KickInput last = _kicks.At(Count - 1);
            _kicks.Remove(last.Tick, last.Player, last.Ball);
        }
    }

    /// <summary>The index of the first kick at a tick or later; <see cref="Count"/> when there is none.</summary>
    /// <param name="tick">The tick.</param>
    public int FirstAt(long tick) => _kicks.CountBefore(tick, 0, 0);

    /// <summary>Forgets all kicks; keeps the memory.</summary>
    public void Clear() => _kicks.Clear();

    /// <summary>The log as bytes, the same on every machine.</summary>
    public byte[] ToBytes()
    {
        var writer = new ByteWriter();
        Write(ref writer);
        return writer.ToArray();
    }

    /// <summary>Reads what <see cref="ToBytes"/> wrote.</summary>
    /// <param name="bytes">The bytes; all of them are used.</param>
    /// <exception cref="FormatException">The bytes are no log of kicks, or were changed on their way; the message says why.</exception>
    public static KickLog FromBytes(ReadOnlySpan<byte> bytes)
    {
        var reader = new ByteReader(bytes);
        KickLog log = Read(ref reader);
        reader.End();
        return log;
    }

    internal void Write(ref ByteWriter writer)
    {
        // Count, then of each the ticks since the one before, the player, and the kick itself.
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
            // A sum beyond 63 bits turns negative, which the kick refuses.
            tick += reader.Long();
            KickInput kick = KickBytes.Read(tick, reader.Int(), ref reader);
            if (i > 0 && log._kicks.At(i - 1).Order(kick.Tick, kick.Player, kick.Ball) >= 0)
            {
                // Each log has one form.
                throw ByteReader.Broken("two kicks are not in order, or of one player and one ball at one tick");
            }

            log._kicks.Put(in kick);
        }

        return log;
    }
}
