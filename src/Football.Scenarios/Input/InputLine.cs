namespace FootballPhysics.Scenarios.Input;

/// <summary>A line of the input: its text, and whether that was cut because it got too long.</summary>
public readonly record struct InputLine(byte[] Text, bool IsCut)
{
    /// <summary>Whether there is nothing in it; of a line that was cut nobody knows what came later.</summary>
    public bool IsBlank => !IsCut && Text.AsSpan().IndexOfAnyExcept(" \t\r"u8) < 0;
}
