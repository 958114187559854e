using System.Globalization;

namespace FootballPhysics;

/// <summary>Events in the order in which they happened. Written by a step, read after it.</summary>
/// <remarks>
/// It grows up to <see cref="MaximumCount"/> events, 80 kB by default, and the memory stays: also where a game forgets to clear it. Where there are more, the first and the last are kept, in order, and
/// those between are counted in <see cref="Dropped"/>: no scene can make it larger.
/// </remarks>
public sealed class EventBuffer
{
    /// <summary>How many events it keeps unless told otherwise.</summary>
    public const int DefaultMost = 1_024;

    /// <summary>How many of the kept events are the last ones, where some are missed.</summary>
    public const int TailCount = 16;

    private BallEvent[] _events;

    /// <summary>Makes an empty buffer.</summary>
    /// <param name="capacity">Events to make room for, at least 1 and at most <paramref name="most"/>; default 32.</param>
    /// <param name="most">How many events it keeps, at least 32; default <see cref="DefaultMost"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public EventBuffer(int capacity = 32, int most = DefaultMost)
    {
        Check.AtLeast(nameof(most), most, 2 * TailCount);
        Check.Within(nameof(capacity), capacity, 1, most);
        MaximumCount = most;
        _events = new BallEvent[capacity];
    }

    /// <summary>How many events it keeps at most.</summary>
    public int MaximumCount { get; }

    /// <summary>How many events there are.</summary>
    public int Count { get; private set; }

    /// <summary>How many more happened than are kept: between the first ones and the <see cref="TailCount"/> ones.</summary>
    public long Dropped { get; private set; }

    /// <summary>The events, first to last; valid until the next step or <see cref="Clear"/>.</summary>
    public ReadOnlySpan<BallEvent> Span => _events.AsSpan(0, Count);

    /// <summary>One event.</summary>
    /// <param name="index">From 0, below <see cref="Count"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">There is no such event.</exception>
    public ref readonly BallEvent this[int index]
    {
        get
        {
            if ((uint)index >= (uint)Count)
            {
                throw Check.Refusal(nameof(index), index.ToString(CultureInfo.InvariantCulture), $"0 … {Count - 1}");
            }

            return ref _events[index];
        }
    }

    /// <summary>Number of impacts since the last <see cref="Clear"/>, those counted in <see cref="Dropped"/> included.</summary>
    public long Impacts { get; private set; }

    /// <summary>Forgets all events; keeps the memory.</summary>
    public void Clear()
    {
        Count = 0;
        Dropped = 0;
        Impacts = 0;
    }

    /// <summary>Enumerates the events without allocating.</summary>
    public ReadOnlySpan<BallEvent>.Enumerator GetEnumerator() => Span.GetEnumerator();

    /// <summary>Drops the events before a time.</summary>
    internal void Forget(double before)
    {
        // In order of time those before it are the first ones.
        int gone = 0;
        while (gone < Count && _events[gone].Time < before)
        {
            gone++;
        }

        Array.Copy(_events, gone, _events, 0, Count - gone);
        Count -= gone;
    }

    /// <summary>Whose events are added, where there are several balls.</summary>
    internal int Ball { get; set; }

    internal void Add(in BallEvent item)
    {
        Impacts += item.Kind == BallEventKind.Impact ? 1 : 0;

        // Full: it grows, or the first of the last ones is missed.
        if (Count == _events.Length)
        {
            MakeRoom();
        }

        _events[Count++] = Ball == 0 ? item : new BallEvent(in item, Ball);
    }

    /// <summary>Names the thing of an event anew.</summary>
    internal void Call(int index, int thing) => _events[index] = _events[index] with { ColliderIndex = thing };

    /// <summary>Adds all of another buffer's.</summary>
    internal void Add(EventBuffer other)
    {
        for (int i = 0; i < other.Count; i++)
        {
            Add(in other._events[i]);
        }

        // What the other one has missed is missed here too.
        Dropped += other.Dropped;
    }

    /// <summary>Takes back what was added since there were so many; of those that were missed meanwhile the last ones cannot come back.</summary>
    internal void TakeBack(int count, long missed, long impacts)
    {
        // Where some were missed meanwhile the last ones have moved up, and only the first ones are still what they were.
        Count = Dropped == missed ? count : Math.Min(count, MaximumCount - TailCount);
        Dropped = missed + (count - Count);
        Impacts = impacts;
    }

    /// <summary>Grows, or misses the first of the last ones.</summary>
    private void MakeRoom()
    {
        // Twice as many, up to the bound.
        if (Count < MaximumCount)
        {
            Array.Resize(ref _events, (int)Math.Min(2L * Count, MaximumCount));
            return;
        }

        // The first ones stay, the last ones move up by one place.
        Array.Copy(_events, Count - TailCount + 1, _events, Count - TailCount, TailCount - 1);
        Count--;
        Dropped++;
    }
}
