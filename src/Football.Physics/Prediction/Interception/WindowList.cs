namespace FootballPhysics.Prediction;

/// <summary>The windows found so far, in a reused buffer.</summary>
internal sealed class WindowList
{
    /// <summary>The windows.</summary>
    public InterceptWindow[] Items = new InterceptWindow[64];

    /// <summary>The number of windows.</summary>
    public int Count { get; set; }

    /// <summary>The number of intervals that the searches have halved or decided.</summary>
    public long Intervals { get; set; }

    /// <summary>True if a time directly follows the player's last window.</summary>
    public bool Continues(int runner, double time, double closeness) =>
        Count > 0 && Items[Count - 1].Player == runner && time - Items[Count - 1].To <= closeness;

    /// <summary>Begins a window.</summary>
    public void Begin(int runner, double from, in Vector3d position, in Vector3d velocity)
    {
        if (Count == Items.Length)
        {
            Array.Resize(ref Items, 2 * Count);
        }

        Items[Count++] = new InterceptWindow(runner, from, from, in position, in velocity);
    }

    /// <summary>Ends the last window, and removes it if it has no length.</summary>
    /// <param name="from">The time at which the ball entered, in s.</param>
    /// <param name="to">The time at which the ball left, in s.</param>
    public void End(double from, double to)
    {
        InterceptWindow last = Items[Count - 1];

        // Remove a window of zero length, unless it extends an earlier one.
        if (!(to > from) && last.From == from)
        {
            Count--;
            return;
        }

        Items[Count - 1] = new InterceptWindow(last.Player, last.From, to, last.Position, last.Velocity);
    }
}
