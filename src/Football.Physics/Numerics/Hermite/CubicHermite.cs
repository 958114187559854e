namespace FootballPhysics;

/// <summary>The cubic Hermite interpolant of a number over 0 ≤ s ≤ 1, c₀ + c₁ s + c₂ s² + c₃ s³: values and slopes at both ends.</summary>
internal readonly struct CubicHermite
{
    public readonly double C0;
    public readonly double C1;
    public readonly double C2;
    public readonly double C3;

    /// <param name="start">Value at 0.</param>
    /// <param name="startSlope">Slope at 0: a rate times the length of what s is a fraction of.</param>
    /// <param name="end">Value at 1.</param>
    /// <param name="endSlope">Slope at 1.</param>
    public CubicHermite(double start, double startSlope, double end, double endSlope)
    {
        double rise = end - start;
        C0 = start;
        C1 = startSlope;
        C2 = (3.0 * rise) - (2.0 * startSlope) - endSlope;
        C3 = startSlope + endSlope - (2.0 * rise);
    }

    /// <summary>Its value.</summary>
    public double At(double s) => C0 + (s * (C1 + (s * (C2 + (s * C3)))));

    /// <summary>Its slope.</summary>
    public double SlopeAt(double s) => C1 + (s * ((2.0 * C2) + (3.0 * s * C3)));

    /// <summary>Where in 0 … 1 it is lowest, if it falls at 0 and rises at 1; 1 where it has no such place.</summary>
    public double Lowest => LowestOf(C1, C2, C3);

    /// <summary>Where in 0 … 1 it is highest, if it rises at 0 and falls at 1; 1 where it has no such place.</summary>
    public double Highest => LowestOf(-C1, -C2, -C3);

    private static double LowestOf(double c1, double c2, double c3)
    {
        // The root of c₁ + 2 c₂ s + 3 c₃ s² with the change from falling to rising
        double discriminant = (c2 * c2) - (3.0 * c1 * c3);
        if (discriminant <= 0)
        {
            return 1.0;
        }

        // The form without cancellation: (−c₂ + √D)/(3 c₃) with both multiplied by c₂ + √D.
        double s = -c1 / (c2 + Math.Sqrt(discriminant));
        return s > 0 && s < 1 ? s : 1.0;
    }
}
