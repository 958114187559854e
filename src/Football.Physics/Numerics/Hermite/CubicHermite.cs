namespace FootballPhysics.Numerics;

/// <summary>The cubic Hermite interpolant c₀ + c₁ s + c₂ s² + c₃ s³ over 0 ≤ s ≤ 1, from values and slopes at both ends.</summary>
internal readonly struct CubicHermite
{
    public readonly double C0;
    public readonly double C1;
    public readonly double C2;
    public readonly double C3;

    /// <param name="start">The value at 0.</param>
    /// <param name="startSlope">The slope at 0, in units of s: the rate times the length of the interval.</param>
    /// <param name="end">The value at 1.</param>
    /// <param name="endSlope">The slope at 1.</param>
    public CubicHermite(double start, double startSlope, double end, double endSlope)
    {
        double rise = end - start;
        C0 = start;
        C1 = startSlope;
        C2 = (3.0 * rise) - (2.0 * startSlope) - endSlope;
        C3 = startSlope + endSlope - (2.0 * rise);
    }

    /// <summary>Returns the value.</summary>
    public double At(double s) => C0 + (s * (C1 + (s * (C2 + (s * C3)))));

    /// <summary>Returns the slope.</summary>
    public double SlopeAt(double s) => C1 + (s * ((2.0 * C2) + (3.0 * s * C3)));

    /// <summary>The position of the minimum in 0 … 1, if the cubic falls at 0 and rises at 1; 1 if there is no minimum.</summary>
    public double Lowest => LowestOf(C1, C2, C3);

    /// <summary>The position of the maximum in 0 … 1, if the cubic rises at 0 and falls at 1; 1 if there is no maximum.</summary>
    public double Highest => LowestOf(-C1, -C2, -C3);

    private static double LowestOf(double c1, double c2, double c3)
    {
        // c₁, c₂ and c₃ are the coefficients of the cubic, and s is the position in 0 … 1.
        // The root of c₁ + 2 c₂ s + 3 c₃ s² at which the slope changes from negative to positive.
        double discriminant = (c2 * c2) - (3.0 * c1 * c3);
        if (discriminant <= 0)
        {
            return 1.0;
        }

        // D = c₂² − 3 c₁ c₃ is the discriminant.
        // (−c₂ + √D)/(3 c₃), multiplied by c₂ + √D above and below to avoid cancellation.
        double s = -c1 / (c2 + Math.Sqrt(discriminant));
        return s > 0 && s < 1 ? s : 1.0;
    }
}
