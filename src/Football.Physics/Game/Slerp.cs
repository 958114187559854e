namespace FootballPhysics.Game;

/// <summary>Spherical interpolation at constant angular speed, from + − × ÷ √ only.</summary>
internal static class Slerp
{
    private const int Terms = 40;

    /// <summary>Returns the rotation at a fraction of the shorter arc between two unit quaternions.</summary>
    /// <param name="from">The rotation at fraction 0.</param>
    /// <param name="to">The rotation at fraction 1.</param>
    /// <param name="fraction">0 … 1.</param>
    public static Quaterniond Between(in Quaterniond from, in Quaterniond to, double fraction)
    {
        double cosine = (from.X * to.X) + (from.Y * to.Y) + (from.Z * to.Z) + (from.W * to.W);

        // q and −q represent the same rotation: use the sign with the shorter arc.
        double sign = cosine < 0 ? -1.0 : 1.0;
        double distance = (sign * cosine) - 1.0;
        double a = Weight(1.0 - fraction, distance);
        double b = sign * Weight(fraction, distance);
        return new Quaterniond(
            (a * from.X) + (b * to.X),
            (a * from.Y) + (b * to.Y),
            (a * from.Z) + (b * to.Z),
            (a * from.W) + (b * to.W)).Normalized();
    }

    /// <summary>Returns sin(t φ)/sin φ as a power series in cos φ − 1 (Eberly): t (1 + b₁ (1 + b₂ (…))), bᵢ = (t² − i²)/(i (2i + 1)) · (cos φ −
    /// 1).</summary>
    /// <remarks>For φ ≤ 90° each term is at most half the previous one, so 40 terms leave an error below 1e-12.</remarks>
    private static double Weight(double t, double distance)
    {
        double square = t * t;
        double sum = 1.0;

        // Horner's scheme, from the innermost bracket outwards.
        for (int i = Terms; i >= 1; i--)
        {
            sum = 1.0 + (((square - (i * i)) / (i * ((2 * i) + 1)) * distance) * sum);
        }

        return t * sum;
    }
}
