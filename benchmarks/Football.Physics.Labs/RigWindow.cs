namespace FootballPhysics.Labs;

/// <summary>The requirements of a test of pitches for the results of the rigs.</summary>
/// <param name="Name">The test.</param>
/// <param name="Drop">The least and greatest bounce, m.</param>
/// <param name="Angle">The share of the speed along the ground that remains, %.</param>
/// <param name="Roll">The length of the roll, m.</param>
internal sealed record RigWindow(string Name, (double Least, double Most)? Drop, (double Least, double Most)? Angle, (double Least, double Most)? Roll)
{
    public static string? Text((double Least, double Most)? window) =>
        window is { } range ? FormattableString.Invariant($"{range.Least:0.##} … {range.Most:0.##}") : null;

    public static string? Verdict((double Least, double Most)? window, double value) => window is null ? null : Inside(window, value) ? "pass" : "FAIL";

    public bool Holds(double drop, double angle, double roll) => Inside(Drop, drop) && Inside(Angle, angle) && Inside(Roll, roll);

    private static bool Inside((double Least, double Most)? window, double value) =>
        window is not { } range || (value >= range.Least && value <= range.Most);
}
