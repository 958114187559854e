namespace FootballPhysics.Laws;

/// <summary>The part of the drag coefficient due to spin across the motion, D S/√(S² + S_D²) (1 − (1 − κ₀) q).</summary>
/// <remarks>Like |S|, it has a kink at S = 0: the force is continuous there, but its slope is not.</remarks>
internal static class SpinDrag
{
    /// <summary>D, the limit of this part.</summary>
    /// <remarks>Measured: up to S = 0.3, between the values of Goff and Carré and of Kiratidis and Leinweber; beyond that, Goff's plateau.</remarks>
    public const double Limit = 0.30;

    /// <summary>S_D, the spin parameter at which this part is D/√2 (same sources).</summary>
    public const double Scale = 0.577;

    /// <summary>κ₀, the share of this part below the drag crisis. Guess, 0 … 1.</summary>
    public const double Subcritical = 0.5;

    /// <summary>Returns D S/√(S² + S_D²).</summary>
    public static double OfSpin(double spinParameter) => Limit * spinParameter / Math.Sqrt((spinParameter * spinParameter) + (Scale * Scale));

    /// <summary>Returns 1 − (1 − κ₀) q.</summary>
    /// <param name="share">q, the share of subcritical flow.</param>
    public static double OfShare(double share) => 1.0 - ((1.0 - Subcritical) * share);
}
