using System.Globalization;
using System.Runtime.CompilerServices;
using FootballPhysics.Game;
using FootballPhysics.Numerics;

namespace FootballPhysics.Netcode;

/// <summary>Kicks and restarts sorted by tick: the schedule of a <see cref="FixedStepRunner"/> and the input log of a match.</summary>
/// <remarks>
/// The inputs are sorted by tick, then player, then ball, regardless of the order in which they arrive. The log allocates only when it grows. A serialised kick
/// takes about 28 bytes if its numbers are single-precision values, and about 52 otherwise. A restart from rest takes about 22 or 34. Numbers that are 0 take
/// no bytes. A 4-byte checksum follows all inputs.
/// </remarks>
public sealed class KickLog
{
    private readonly InputList<KickInput> _kicks;
    private readonly InputList<PlaceInput> _places = new(4);
    private readonly int _balls = KickInput.MostBalls;

    /// <summary>Creates an empty log.</summary>
    /// <param name="capacity">The initial capacity, at least 1; default 64.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is below 1.</exception>
    public KickLog(int capacity = 64)
    {
        Check.AtLeast(nameof(capacity), capacity, 1);
        _kicks = new InputList<KickInput>(capacity);
    }

    /// <summary>Creates an empty log for a runner with the given number of balls.</summary>
    internal KickLog(int capacity, int balls)
        : this(capacity) => _balls = balls;

    /// <summary>The number of kicks.</summary>
    public int Count => _kicks.Count;

    /// <summary>The number of restarts.</summary>
    public int PlaceCount => _places.Count;

    /// <summary>The first tick that the runner has not simulated yet.</summary>
    internal long Played { get; set; }

    /// <summary>The earliest tick whose inputs changed after the runner had simulated it; the maximum if there is none.</summary>
    internal long ChangedAt { get; set; } = long.MaxValue;

    /// <summary>The tick of the first input; the maximum if there are none.</summary>
    internal long FirstTick => Math.Min(Count > 0 ? _kicks.At(0).Tick : long.MaxValue, PlaceCount > 0 ? _places.At(0).Tick : long.MaxValue);

    /// <summary>Gets a kick by its index.</summary>
    /// <param name="index">The index, from 0 and below <see cref="Count"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such kick.</exception>
    public ref readonly KickInput this[int index]
    {
        get
        {
            RefuseIndex(index, Count);
            return ref _kicks.At(index);
        }
    }

    /// <summary>Returns a restart by its index.</summary>
    /// <param name="index">The index, from 0 and below <see cref="PlaceCount"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such restart.</exception>
    public ref readonly PlaceInput PlaceAt(int index)
    {
        RefuseIndex(index, PlaceCount);
        return ref _places.At(index);
    }

    /// <summary>Adds a kick in order, or replaces one with the same tick, player and ball.</summary>
    /// <param name="kick">The kick.</param>
    /// <exception cref="ArgumentOutOfRangeException">The runner that owns this log does not have this ball; nothing has changed.</exception>
    [OverloadResolutionPriority(1)]
    public void Add(in KickInput kick)
    {
        // A kick may come from the network: reject an unknown ball at once, not in the middle of a step.
        Check.Index("kick.ball", kick.Ball, _balls);

        // Sort when inserting, so that kicks are applied in the same order whatever their order of arrival.
        if (!Has(in kick))
        {
            _kicks.Put(in kick);
            Changes(kick.Tick);
        }
    }

    /// <summary>Adds a restart in order, or replaces one with the same tick, player and ball. Removes no kick.</summary>
    /// <param name="place">The restart.</param>
    /// <exception cref="ArgumentOutOfRangeException">The runner that owns this log does not have this ball; nothing has changed.</exception>
    public void Add(in PlaceInput place)
    {
        Check.Index("place.ball", place.Ball, _balls);
        if (!Has(in place))
        {
            _places.Put(in place);
            Changes(place.Tick);
        }
    }

    /// <summary>Removes a kick, for instance one that was only predicted.</summary>
    /// <param name="tick">The tick.</param>
    /// <param name="player">The player; default 0.</param>
    /// <param name="ball">The ball; default 0.</param>
    /// <returns>True if there was such a kick.</returns>
    public bool Remove(long tick, int player = 0, int ball = 0) => _kicks.Remove(tick, player, ball) && Changes(tick);

    /// <summary>Removes a restart, for instance one that was only predicted.</summary>
    /// <param name="tick">The tick.</param>
    /// <param name="player">The player; default 0.</param>
    /// <param name="ball">The ball; default 0.</param>
    /// <returns>True if there was such a restart.</returns>
    public bool RemovePlace(long tick, int player = 0, int ball = 0) => _places.Remove(tick, player, ball) && Changes(tick);

    /// <summary>Removes the inputs before a tick, for instance those too old for a rollback.</summary>
    /// <param name="tick">The first tick to keep.</param>
    internal void RemoveBefore(long tick)
    {
        _kicks.RemoveBefore(tick);
        _places.RemoveBefore(tick);
    }

    /// <summary>Removes the kicks and restarts at or after a tick, for instance when the ball is moved.</summary>
    /// <param name="tick">The first tick to remove.</param>
    public void RemoveFrom(long tick) => RemoveFrom(tick, -1);

    /// <summary>Removes the inputs of one ball at or after a tick; those of all balls if the ball is negative.</summary>
    internal void RemoveFrom(long tick, int ball) => Changes(Math.Min(_kicks.RemoveFrom(tick, ball), _places.RemoveFrom(tick, ball)));

    /// <summary>Returns the index of the first kick at or after a tick; <see cref="Count"/> if there is none.</summary>
    /// <param name="tick">The tick.</param>
    public int FirstAt(long tick) => _kicks.CountBefore(tick, 0, 0);

    /// <summary>Returns the index of the first restart at or after a tick; <see cref="PlaceCount"/> if there is none.</summary>
    /// <param name="tick">The tick.</param>
    public int FirstPlaceAt(long tick) => _places.CountBefore(tick, 0, 0);

    /// <summary>Removes all kicks and restarts, but keeps the capacity.</summary>
    public void Clear()
    {
        Changes(FirstTick);
        _kicks.Clear();
        _places.Clear();
    }

    /// <summary>Serialises the log; the bytes are the same on every machine.</summary>
    public byte[] ToBytes()
    {
        var writer = new ByteWriter();
        Write(ref writer);

        // A log without restarts has the bytes of the format before there were any.
        if (PlaceCount > 0)
        {
            WritePlaces(ref writer);
        }

        return writer.ToArray();
    }

    /// <summary>Reads a log written by <see cref="ToBytes"/>.</summary>
    /// <param name="bytes">The bytes; all of them are used.</param>
    /// <exception cref="FormatException">The bytes are not a kick log, or are corrupt; the message states the reason.</exception>
    public static KickLog FromBytes(ReadOnlySpan<byte> bytes)
    {
        var reader = new ByteReader(bytes);
        KickLog log = Read(ref reader);
        if (!reader.IsAtEnd)
        {
            log.ReadPlaces(ref reader);
            if (log.PlaceCount == 0)
            {
                throw ByteReader.Broken("something follows their end");
            }
        }

        reader.End();
        return log;
    }

    /// <summary>True if the log has a kick with the same bits.</summary>
    internal bool Has(in KickInput kick) => _kicks.Has(in kick);

    /// <summary>True if the log has a restart with the same bits.</summary>
    internal bool Has(in PlaceInput place) => _places.Has(in place);

    /// <summary>Adds the inputs of another log from one tick up to, but excluding, another.</summary>
    internal void Add(KickLog other, long from, long to)
    {
        for (int i = other.FirstAt(from); i < other.Count && other[i].Tick < to; i++)
        {
            Add(in other[i]);
        }

        for (int i = other.FirstPlaceAt(from); i < other.PlaceCount && other.PlaceAt(i).Tick < to; i++)
        {
            Add(in other.PlaceAt(i));
        }
    }

    /// <summary>Writes the kicks.</summary>
    internal void Write(ref ByteWriter writer) => _kicks.Write(ref writer);

    /// <summary>Writes the restarts, in the same form.</summary>
    internal void WritePlaces(ref ByteWriter writer) => _places.Write(ref writer);

    /// <summary>Reads kicks.</summary>
    internal static KickLog Read(ref ByteReader reader)
    {
        var log = new KickLog();
        log._kicks.Read(ref reader);
        return log;
    }

    /// <summary>Reads restarts.</summary>
    internal void ReadPlaces(ref ByteReader reader) => _places.Read(ref reader);

    private static void RefuseIndex(int index, int count)
    {
        if ((uint)index >= (uint)count)
        {
            throw Check.Refusal(nameof(index), index.ToString(CultureInfo.InvariantCulture), $"0 … {count - 1}");
        }
    }

    /// <summary>Notes that the inputs of a tick changed; returns true.</summary>
    private bool Changes(long tick)
    {
        ChangedAt = tick < Played ? Math.Min(ChangedAt, tick) : ChangedAt;
        return true;
    }
}
