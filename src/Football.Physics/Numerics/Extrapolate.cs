namespace FootballPhysics.Numerics;

/// <summary>Estimates the rate at the end of a step from the rate at its start and the mean rate.</summary>
internal static class Extrapolate
{
    /// <summary>The length, in s, below which the difference of the ends is mostly rounding.</summary>
    private const double Shortest = 1e-6;

    /// <summary>Returns 2 (f₁ − f₀)/h − f₀'.</summary>
    public static double Rate(double from, double to, double startRate, double h) =>
        h > Shortest ? ((2.0 * (to - from)) / h) - startRate : startRate;

    /// <inheritdoc cref="Rate(double, double, double, double)"/>
    public static Vector3d Rate(in Vector3d from, in Vector3d to, in Vector3d startRate, double h) =>
        h > Shortest ? ((2.0 / h) * (to - from)) - startRate : startRate;
}
