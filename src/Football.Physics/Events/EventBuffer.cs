using System.Globalization;
using FootballPhysics.Numerics;

namespace FootballPhysics;

/// <summary>A buffer of events in order of time. A step fills the buffer; read it after the step.</summary>
/// <remarks>
/// The buffer never grows beyond <see cref="MaximumCount"/> events (80 kB by default), even if you never clear it. It does not release memory. If more
/// events occur, it keeps the first and the most recent ones; <see cref="Dropped"/> is the number of the others.
/// </remarks>
public sealed class EventBuffer
{
    /// <summary>The default of <see cref="MaximumCount"/>.</summary>
    internal const int DefaultMost = 1_024;

    /// <summary>The number of most recent events that a full buffer keeps.</summary>
    public const int TailCount = 16;

    private BallEvent[] _events;

    /// <summary>Creates an empty buffer.</summary>
    /// <param name="capacity">The initial capacity, from 1 to <paramref name="most"/>; default 32.</param>
    /// <param name="most">The maximum number of events, at least 32; default <see cref="DefaultMost"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public EventBuffer(int capacity = 32, int most = DefaultMost)
    {
        Check.AtLeast(nameof(most), most, 2 * TailCount);
        Check.Within(nameof(capacity), capacity, 1, most);
        MaximumCount = most;
        _events = new BallEvent[capacity];
    }

    /// <summary>The maximum number of events in the buffer.</summary>
    public int MaximumCount { get; }

    /// <summary>The number of events in the buffer.</summary>
    public int Count { get; private set; }

    /// <summary>The number of events dropped between the first events and the last <see cref="TailCount"/> events.</summary>
    public long Dropped { get; private set; }

    /// <summary>The events, first to last; valid until the next step or <see cref="Clear"/>.</summary>
    public ReadOnlySpan<BallEvent> Span => _events.AsSpan(0, Count);

    /// <summary>Gets the event at an index.</summary>
    /// <param name="index">The index, from 0 to <see cref="Count"/> − 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">The index is out of range.</exception>
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

    /// <summary>The number of impacts since the last <see cref="Clear"/>, including dropped ones.</summary>
    public long Impacts { get; private set; }

    /// <summary>Removes all events, but keeps the memory.</summary>
    public void Clear()
    {
        Count = 0;
        Dropped = 0;
        Impacts = 0;
    }

    /// <summary>Returns an enumerator of the events that does not allocate.</summary>
    public ReadOnlySpan<BallEvent>.Enumerator GetEnumerator() => Span.GetEnumerator();

    /// <summary>Removes the events before a time.</summary>
    internal void Forget(double before)
    {
        // Events are sorted by time, so the earlier ones come first.
        int gone = 0;
        while (gone < Count && _events[gone].Time < before)
        {
            gone++;
        }

        Array.Copy(_events, gone, _events, 0, Count - gone);
        Count -= gone;
    }

    /// <summary>The index of the ball whose events are added, if there are several balls.</summary>
    internal int Ball { get; set; }

    internal void Add(in BallEvent item)
    {
        Impacts += item.Kind == BallEventKind.Impact ? 1 : 0;

        // If the buffer is full, it either grows or drops the oldest event of the tail.
        if (Count == _events.Length)
        {
            MakeRoom();
        }

        _events[Count++] = Ball == 0 ? item : new BallEvent(in item, Ball);
    }

    /// <summary>Changes the object of an event.</summary>
    internal void Call(int index, int thing) => _events[index] = _events[index] with { ColliderIndex = thing };

    /// <summary>Adds all events of another buffer.</summary>
    internal void Add(EventBuffer other)
    {
        for (int i = 0; i < other.Count; i++)
        {
            Add(in other._events[i]);
        }

        // Include the events that the other buffer has dropped.
        Dropped += other.Dropped;
    }

    /// <summary>Undoes additions, back to an earlier count. Tail events dropped since then are lost.</summary>
    internal void TakeBack(int count, long missed, long impacts)
    {
        // If events have been dropped since then, the tail has moved, and only the events before it are unchanged.
        Count = Dropped == missed ? count : Math.Min(count, MaximumCount - TailCount);
        Dropped = missed + (count - Count);
        Impacts = impacts;
    }

    /// <summary>Grows the buffer, or drops the oldest event of the tail.</summary>
    private void MakeRoom()
    {
        // Double the capacity, up to the maximum.
        if (Count < MaximumCount)
        {
            Array.Resize(ref _events, (int)Math.Min(2L * Count, MaximumCount));
            return;
        }

        // Keep the head, drop the oldest event of the tail, and shift the rest of the tail one position forward.
        Array.Copy(_events, Count - TailCount + 1, _events, Count - TailCount, TailCount - 1);
        Count--;
        Dropped++;
    }
}
