namespace Football.Physics;

/// <summary>Events in the order in which they happened. Written by a step, read after it; nothing is ever dropped.</summary>
/// <remarks>It allocates only when one step has more events than any before it; the capacity stays.</remarks>
public sealed class EventBuffer
{
    private BallEvent[] _events;

    /// <summary>Makes an empty buffer.</summary>
    /// <param name="capacity">Events to make room for, at least 1; default 32.</param>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="capacity"/> is below 1.</exception>
    public EventBuffer(int capacity = 32)
    {
        if (capacity < 1)
        {
            throw Check.Refusal(nameof(capacity), capacity.ToString(System.Globalization.CultureInfo.InvariantCulture), "1 or more");
        }

        _events = new BallEvent[capacity];
    }

    /// <summary>How many events there are.</summary>
    public int Count { get; private set; }

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
                throw Check.Refusal(nameof(index), index.ToString(System.Globalization.CultureInfo.InvariantCulture), $"0 … {Count - 1}");
            }

            return ref _events[index];
        }
    }

    /// <summary>Forgets all events; keeps the memory.</summary>
    public void Clear() => Count = 0;

    /// <summary>Enumerates the events without allocating.</summary>
    public ReadOnlySpan<BallEvent>.Enumerator GetEnumerator() => Span.GetEnumerator();

    /// <summary>Drops the events before a time.</summary>
    internal void Forget(double before)
    {
        int gone = 0;
        while (gone < Count && _events[gone].Time < before)
        {
            gone++;
        }

        Array.Copy(_events, gone, _events, 0, Count - gone);
        Count -= gone;
    }

    internal void Add(in BallEvent item)
    {
        if (Count == _events.Length)
        {
            Array.Resize(ref _events, Count * 2);
        }

        _events[Count++] = item;
    }
}
