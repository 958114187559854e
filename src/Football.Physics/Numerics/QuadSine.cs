using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Sine and cosine of four angles at once, from + − × alone and without a branch: for sums of waves.</summary>
/// <remarks>Absolute error below 2e-15 for angles of less than a turn; beyond, what rounding of the angle itself adds.</remarks>
internal static class QuadSine
{
    /// <summary>Added to a number below 2⁵¹ it leaves the nearest whole number.</summary>
    private const double Rounder = 6755399441055744.0;

    private const double HalfPi = 1.57079632679489661923;

    /// <summary>Sines and cosines.</summary>
    /// <param name="turns">The angles over 2π; sizes below 1e15.</param>
    /// <param name="sin">Their sines.</param>
    /// <param name="cos">Their cosines.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void SinCos(Quad turns, out Quad sin, out Quad cos)
    {
        // A quarter of the angle, |r| ≤ π/4
        Quad whole = (turns + Quad.Of(Rounder)) - Quad.Of(Rounder);
        Quad r = (turns - whole) * Quad.Of(HalfPi);
        Quad z = r * r;

        // Taylor series, remainders below 1e-17, their terms in pairs: a step waits for nothing longer than for these.
        Quad zz = z * z;
        Quad zzzz = zz * zz;
        Quad s = Quartet(-1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362880.0, z, zz)
            + (zzzz * (Pair(-1.0 / 39916800.0, 1.0 / 6227020800.0, z) + (zz * Quad.Of(-1.0 / 1307674368000.0))));
        s = r + (r * z * s);
        Quad v = Quartet(1.0 / 24.0, -1.0 / 720.0, 1.0 / 40320.0, -1.0 / 3628800.0, z, zz)
            + (zzzz * (Pair(1.0 / 479001600.0, -1.0 / 87178291200.0, z) + (zz * Quad.Of(1.0 / 20922789888000.0))));
        v = (z * Quad.Of(0.5)) - (zz * v);

        // Twice the angle twice, with v = 1 − cos: sin 2a = 2 sin a cos a, 1 − cos 2a = 2 sin² a
        Quad one = Quad.Of(1.0);
        Quad two = Quad.Of(2.0);
        Quad half = two * (s * (one - v));
        Quad halfVersine = two * (s * s);
        sin = two * (half * (one - halfVersine));
        cos = one - (two * (half * half));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Quad Pair(double a, double b, Quad z) => Quad.Of(a) + (Quad.Of(b) * z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Quad Quartet(double a, double b, double c, double d, Quad z, Quad zz) => Pair(a, b, z) + (zz * Pair(c, d, z));
}
