namespace FootballPhysics;

/// <summary>The format that values have where none is asked for.</summary>
internal static class NumberFormat
{
    /// <summary>The format that was asked for, or three decimals at most.</summary>
    public static string OrShort(string? format) => string.IsNullOrEmpty(format) ? "0.###" : format!;
}
