namespace FootballPhysics.Prediction;

/// <summary>Windows as they are found, in memory that is used again.</summary>
internal sealed class WindowList
{
    /// <summary>The windows.</summary>
    public InterceptWindow[] Items = new InterceptWindow[64];

    /// <summary>How many there are.</summary>
    public int Count { get; set; }

    /// <summary>True when a time goes on with the runner's last window.</summary>
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

    /// <summary>Ends the last window; one without length was none.</summary>
    /// <param name="from">When the ball came, s.</param>
    /// <param name="to">When it went, s.</param>
    public void End(double from, double to)
    {
        InterceptWindow last = Items[Count - 1];

        // A touch without length leaves no window, but one that went on and ended there again stays.
        if (!(to > from) && last.From == from)
        {
            Count--;
            return;
        }

        Items[Count - 1] = new InterceptWindow(last.Player, last.From, to, last.Position, last.Velocity);
    }
}
