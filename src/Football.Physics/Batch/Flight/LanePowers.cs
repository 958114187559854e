namespace Football.Physics;

/// <summary>Where the polynomials of the powers are centred, and the constants that this takes out of them.</summary>
/// <remarks>
/// A power x^q with a small exponent is one polynomial in log₂ x over the whole domain, without tables: |u|² from ½ to 2^14 (0.7 to 128 m/s),
/// r|ω| from 2^−12 to 2^10 m/s. Below those the powers keep their last value, which what they are multiplied by makes harmless.
/// </remarks>
internal static class LanePowers
{
    /// <summary>|u|² at the middle of its domain is two to this.</summary>
    public const float SpeedCentre = 6.5f;

    /// <summary>log₂ r|ω| at the middle of the domain of (r|ω|)^β.</summary>
    public const float SpinCentre = -1f;

    /// <summary>log₂ r|ω| at the middle of the domain of (r|ω|)^d.</summary>
    public const float SpinDragCentre = 4.5f;

    public const float LeastSpeedSquared = 0.5f;
    public const float LeastSurfaceSpeed = 1f / 4096f;

    /// <summary>Greatest speed, m/s, and surface speed r|ω|, m/s, that a ball may reach: beyond, the decay by two plates is not a parabola in the spin any more.</summary>
    public const double GreatestSpeed = 128;
    public const double GreatestSurfaceSpeed = 14;

    /// <summary>What is taken out of (r|ω|)^(β−1) |u|^(1−β).</summary>
    public static readonly double LiftConstant =
        Two(((EmpiricalMagnus.Beta - 1) * SpinCentre) + (0.5 * (1 - EmpiricalMagnus.Beta) * SpeedCentre));

    /// <summary>What is taken out of c (r|ω|/|u|)^d, with c.</summary>
    public static readonly float DragConstant =
        (float)(FittedDrag.C * Two((FittedDrag.D * SpinDragCentre) - (0.5 * FittedDrag.D * SpeedCentre)));

    /// <summary>What is taken out of |u|^(−0.2).</summary>
    public static readonly double DecayConstant = Two(-0.1 * SpeedCentre);

    private static double Two(double x) => Elementary.Exp(x * 0.69314718055994530942);
}
