namespace FootballPhysics.Scenarios.Input;

/// <summary>A line of the input: its text, and whether the text was truncated because it is too long.</summary>
public readonly record struct InputLine(byte[] Text, bool IsCut)
{
    /// <summary>True if the line is empty. A truncated line does not count as empty.</summary>
    public bool IsBlank => !IsCut && Text.AsSpan().IndexOfAnyExcept(" \t\r"u8) < 0;
}
