namespace FootballPhysics.Game;

/// <summary>Inputs sorted by tick, player and ball; a search takes logarithmic time.</summary>
/// <remarks>
/// The free part of the array is a gap where the last input was added or removed. Inputs that arrive in rising or in falling order are therefore added in
/// constant time; any other input moves those between it and the gap. The list allocates only to grow.
/// </remarks>
/// <typeparam name="T">The type of the inputs.</typeparam>
internal sealed class InputList<T>(int capacity)
    where T : struct, IMatchInput<T>
{
    private T[] _inputs = new T[capacity];
    private int _before;

    /// <summary>The number of inputs.</summary>
    public int Count { get; private set; }

    private int Gap => _inputs.Length - Count;

    /// <summary>Returns the input at an index in sorted order.</summary>
    public ref readonly T At(int index) => ref _inputs[index < _before ? index : index + Gap];

    /// <summary>Returns the number of inputs before (tick, player, ball).</summary>
    public int CountBefore(long tick, int player, int ball)
    {
        int low = 0;
        int high = Count;
        while (low < high)
        {
            int middle = (low + high) / 2;
            bool isBefore = Order(in At(middle), tick, player, ball) < 0;
            low = isBefore ? middle + 1 : low;
            high = isBefore ? high : middle;
        }

        return low;
    }

    /// <summary>Compares an input with a key by tick, then player, then ball.</summary>
    public static int Order(in T input, long tick, int player, int ball)
    {
        int byTick = input.Tick.CompareTo(tick);
        int byPlayer = input.Player.CompareTo(player);
        return byTick != 0 ? byTick : byPlayer != 0 ? byPlayer : input.Ball.CompareTo(ball);
    }

    /// <summary>True if the list has this input, with the same bits.</summary>
    public bool Has(in T input) => Find(input.Tick, input.Player, input.Ball, out int index) && input.IsSame(in At(index));

    /// <summary>Adds an input, or replaces the one with the same tick, player and ball.</summary>
    public void Put(in T input)
    {
        if (Find(input.Tick, input.Player, input.Ball, out int index))
        {
            MoveGap(index);
            _inputs[index + Gap] = input;
            return;
        }

        if (Gap == 0)
        {
            MoveGap(Count);
            Array.Resize(ref _inputs, 2 * Count);
        }

        MoveGap(index);
        _inputs[_before++] = input;
        Count++;
    }

    /// <summary>Removes an input.</summary>
    /// <returns>True if there was such an input.</returns>
    public bool Remove(long tick, int player, int ball)
    {
        bool has = Find(tick, player, ball, out int index);
        if (has)
        {
            // The input after the gap becomes a part of the gap.
            MoveGap(index);
            Count--;
        }

        return has;
    }

    /// <summary>Removes the inputs before a tick.</summary>
    public void RemoveBefore(long tick)
    {
        int count = CountBefore(tick, 0, 0);
        if (count > 0)
        {
            MoveGap(count);
            Count -= count;
            _before = 0;
        }
    }

    /// <summary>Removes the inputs at or after a tick.</summary>
    /// <param name="tick">The first tick to remove.</param>
    /// <param name="ball">The ball whose inputs are removed; negative for all balls.</param>
    /// <returns>The first tick of a removed input; the maximum if there is none.</returns>
    public long RemoveFrom(long tick, int ball)
    {
        long first = long.MaxValue;
        for (int i = CountBefore(tick, 0, 0); i < Count;)
        {
            T input = At(i);
            if (ball < 0 || input.Ball == ball)
            {
                first = Math.Min(first, input.Tick);
                Remove(input.Tick, input.Player, input.Ball);
            }
            else
            {
                i++;
            }
        }

        return first;
    }

    /// <summary>Writes all inputs.</summary>
    public void Write(ref ByteWriter writer)
    {
        // The number of inputs, then for each one: ticks since the last one, player, and its own numbers.
        writer.Integer((ulong)Count);
        long last = 0;
        for (int i = 0; i < Count; i++)
        {
            ref readonly T input = ref At(i);
            writer.Integer((ulong)(input.Tick - last));
            writer.Integer((ulong)input.Player);
            input.Write(ref writer);
            last = input.Tick;
        }
    }

    /// <summary>Reads inputs that <see cref="Write"/> wrote, into an empty list.</summary>
    public void Read(ref ByteReader reader)
    {
        int count = reader.Count(default(T).Smallest);
        long tick = 0;
        for (int i = 0; i < count; i++)
        {
            // A sum that exceeds 63 bits becomes negative, and the input rejects it.
            tick += reader.Long();
            T input = default(T).Read(tick, reader.Int(), ref reader);
            if (i > 0 && Order(in At(i - 1), input.Tick, input.Player, input.Ball) >= 0)
            {
                // Require sorted inputs without duplicates, so that every list has exactly one encoding.
                throw ByteReader.Broken($"two {input.Noun} are not in order, or of one player and one ball at one tick");
            }

            Put(in input);
        }
    }

    /// <summary>Removes all inputs, but keeps the capacity.</summary>
    public void Clear()
    {
        _before = 0;
        Count = 0;
    }

    /// <summary>Finds an input, or the index at which it would be added.</summary>
    private bool Find(long tick, int player, int ball, out int index)
    {
        index = CountBefore(tick, player, ball);
        return index < Count && Order(in At(index), tick, player, ball) == 0;
    }

    /// <summary>Moves the gap to an index, so that as many inputs are before it.</summary>
    private void MoveGap(int index)
    {
        if (index < _before)
        {
            Array.Copy(_inputs, index, _inputs, index + Gap, _before - index);
        }
        else
        {
            Array.Copy(_inputs, _before + Gap, _inputs, _before, index - _before);
        }

        _before = index;
    }
}
