namespace Football.Physics;

/// <summary>
/// Numbers that count as zero. What decays for long would go on as a denormal number, with which, and with whose squares, arithmetic takes ten times as long.
/// </summary>
internal static class Vanishing
{
    /// <summary>Less than this is nothing; its square is no denormal number yet.</summary>
    public const double Least = 1e-150;

    /// <summary>A number, or 0.</summary>
    public static double OrZero(double x) => Math.Abs(x) < Least ? 0 : x;

    /// <summary>A vector without the components that are nothing.</summary>
    public static Vector3d OrZero(in Vector3d v) => new(OrZero(v.X), OrZero(v.Y), OrZero(v.Z));
}
