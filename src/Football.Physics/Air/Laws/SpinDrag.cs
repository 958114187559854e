namespace FootballPhysics;

/// <summary>Drag coefficient that spin across the motion adds, C_D = … + D S/√(S² + S_D²) (1 − (1 − κ₀) q).</summary>
/// <remarks>It has a kink at S = 0, as |S| has: the force is continuous there, its slope is not.</remarks>
internal static class SpinDrag
{
    /// <summary>D, what the addition tends to. Measured: between Goff and Carré's and Kiratidis and Leinweber's up to S 0.3, Goff's plateau beyond.</summary>
    public const double Limit = 0.30;

    /// <summary>S_D, the spin parameter of 1/√2 of that (likewise).</summary>
    public const double Scale = 0.577;

    /// <summary>κ₀, what is left of it below the drag crisis. Guess, 0 … 1.</summary>
    public const double Subcritical = 0.5;

    /// <summary>D S/√(S² + S_D²).</summary>
    public static double OfSpin(double spinParameter) => Limit * spinParameter / Math.Sqrt((spinParameter * spinParameter) + (Scale * Scale));

    /// <summary>1 − (1 − κ₀) q.</summary>
    /// <param name="share">q, the share of the subcritical flow.</param>
    public static double OfShare(double share) => 1.0 - ((1.0 - Subcritical) * share);
}
