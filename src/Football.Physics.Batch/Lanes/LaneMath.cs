using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>Logarithm, exponential and polynomials in lanes, with errors of a few units in the last place of a float.</summary>
#if NET8_0_OR_GREATER
internal static class LaneMath<F>
    where F : struct, ILane<F>
#else
internal static class LaneMath<TLane>
#endif
{
    // log₂ m / s as a polynomial in s², s = (m − 1)/(m + 1), through the Chebyshev points of √½ ≤ m ≤ √2. The coefficients are purely
    // mathematical; the tests derive them again.
    public const float L0 = 2.88539052f;
    public const float L2 = 0.961588919f;
    public const float L4 = 0.59575963f;

    // 2^x through the Chebyshev points of −½ … ½.
    public const float E0 = 1.00000012f;
    public const float E1 = 0.693147182f;
    public const float E2 = 0.240221068f;
    public const float E3 = 0.0555035695f;
    public const float E4 = 0.00967603177f;
    public const float E5 = 0.00133908633f;

    /// <summary>1.5 · 2^23: adding it rounds to an integer.</summary>
    private const float Rounder = 12582912f;

    /// <summary>Returns log₂ x minus a constant, for positive normal x. The absolute error is 1e-7 plus the rounding of the result.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Log2(F x, float less)
    {
        // log₂ m = s (L0 + L2 s² + L4 s⁴), s = (m − 1)/(m + 1)
        F one = F.Of(1f);
        F.Split(x, out F m, out F e);
        F s = (m - one) / (m + one);
        F ss = s * s;
        return F.Plus(e - F.Of(less), s, F.Parabola(ss, ss * ss, L0, L2, L4));
    }

    /// <summary>Returns 2^x for −126 ≤ x ≤ 127, with a relative error of 2e-7.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Exp2(F x)
    {
        F shift = F.Of(Rounder);
        F k = (x + shift) - shift;
        F r = x - k;
        F rr = r * r;
        F p = F.Plus(
            F.Cubic(r, rr, E0, E1, E2, E3),
            rr * rr,
            F.Parabola(r, rr, E4, E5, 0f));
        return p * F.Power2(k);
    }

    /// <summary>Evaluates a polynomial of degree 8.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Degree8(in LanePolynomial c, F z, F zz, F zzzz) => F.Plus(
        F.Cubic(z, zz, c.C0, c.C1, c.C2, c.C3),
        zzzz,
        F.Plus(F.Cubic(z, zz, c.C4, c.C5, c.C6, c.C7), zzzz, F.Of(c.C8)));

    /// <summary>Evaluates a polynomial of degree 7.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Degree7(in LanePolynomial c, F z, F zz, F zzzz) =>
        F.Plus(F.Cubic(z, zz, c.C0, c.C1, c.C2, c.C3), zzzz, F.Cubic(z, zz, c.C4, c.C5, c.C6, c.C7));

    /// <summary>Evaluates a polynomial of degree 6.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Degree6(in LanePolynomial c, F z, F zz, F zzzz) =>
        F.Plus(F.Cubic(z, zz, c.C0, c.C1, c.C2, c.C3), zzzz, F.Parabola(z, zz, c.C4, c.C5, c.C6));

    /// <summary>Evaluates a polynomial of degree 5.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static F Degree5(in LanePolynomial c, F z, F zz, F zzzz) =>
        F.Plus(F.Cubic(z, zz, c.C0, c.C1, c.C2, c.C3), zzzz, F.Plus(F.Of(c.C4), z, F.Of(c.C5)));
}
