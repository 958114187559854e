namespace FootballPhysics.Laws;

/// <summary>The lift by spin across the motion, which saturates: C_L = L S/√(S² + S₀²) (1 − (1 − η₀) q).</summary>
/// <remarks>
/// F_L = ½ ρ A C_L |u|² (ω⊥/|ω⊥|) × û = ½ ρ A (C_L/S) r |u| (ω × û). It is smooth through ω = 0, where C_L/S is L/S₀ (1 − (1 − η₀) q).
/// </remarks>
internal static class SaturatingLift
{
    /// <summary>L, the limit of C_L. Measured: fit to 13 published points (Asai 2007, Goff and Carré 2009, Kiratidis and Leinweber), rms 0.029.</summary>
    public const double Limit = 0.32;

    /// <summary>S₀, the spin parameter at which C_L is L/√2 (same fit).</summary>
    public const double Scale = 0.14;

    /// <summary>η₀, the share of the lift below the drag crisis. Guess, 0 … 1.</summary>
    public const double Subcritical = 0.4;

    /// <summary>Returns C_L/S above the crisis, L/√(S² + S₀²).</summary>
    public static double PerSpin(double spinParameter) => Limit / Math.Sqrt((spinParameter * spinParameter) + (Scale * Scale));

    /// <summary>Returns 1 − (1 − η₀) q.</summary>
    /// <param name="share">q, the share of subcritical flow.</param>
    public static double OfShare(double share) => 1.0 - ((1.0 - Subcritical) * share);
}
