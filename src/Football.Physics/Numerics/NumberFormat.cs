namespace FootballPhysics.Numerics;

/// <summary>The default number format of <c>ToString</c> methods.</summary>
internal static class NumberFormat
{
    /// <summary>Returns the given format, or one with at most three decimals.</summary>
    public static string OrShort(string? format) => string.IsNullOrEmpty(format) ? "0.###" : format!;
}
