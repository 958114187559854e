using System.Runtime.CompilerServices;

namespace FootballPhysics.Numerics;

/// <summary>Sine and cosine of four angles at once, with + − × and no branch: for sums of waves.</summary>
/// <remarks>The absolute error is below 1e-13 for angles below one turn; larger angles add their own rounding error.</remarks>
internal static class QuadSine
{
    /// <summary>Adding and subtracting this constant rounds a number below 2⁵¹ to the nearest integer.</summary>
    private const double Rounder = 6755399441055744.0;

    private const double HalfPi = 1.57079632679489661923;

    /// <summary>The distance from which a wave no longer changes, in m: a double then resolves only a tenth of a millimetre.</summary>
    private const double Farthest = 1e12;

    /// <summary>Limits a distance to the range in which waves have sines.</summary>
    /// <remarks>The polynomials of an angle beyond 2⁵¹ turns would grow without bounds.</remarks>
    /// <param name="distance">The distance, in m, along waves of 1 mm or more.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Limited(double distance) => Math.Min(Math.Max(distance, -Farthest), Farthest);

    /// <summary>Computes sines and cosines.</summary>
    /// <param name="turns">The angles divided by 2π; below 1e15 in magnitude.</param>
    /// <param name="sin">The sines.</param>
    /// <param name="cos">The cosines.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void SinCos(Quad turns, out Quad sin, out Quad cos)
    {
        // Evaluate at a quarter of the angle, with |r| ≤ π/4.
        Quad whole = (turns + Quad.Of(Rounder)) - Quad.Of(Rounder);
        Quad r = (turns - whole) * Quad.Of(HalfPi);
        Quad z = r * r;

        // Polynomials through Chebyshev points, with remainders below 2e-14. Pairing the terms shortens the dependency chain.
        Quad zz = z * z;
        Quad zzzz = zz * zz;
        Quad s = Quartet(-0.16666666666663885933, 0.0083333333310792230779, -0.00019841266916985965554, 2.7555990929565318647e-6, z, zz)
            + (zzzz * Quad.Of(-2.4805636241834762561e-8));
        s = r + (r * z * s);
        Quad v = Quartet(0.041666666666664678604, -0.0013888888887277342899, 0.000024801585210990515948, -2.7556369695573006221e-7, z, zz)
            + (zzzz * Quad.Of(2.0700600483433117729e-9));
        v = (z * Quad.Of(0.5)) - (zz * v);

        // Double the angle twice, with v = 1 − cos: sin 2a = 2 sin a cos a, 1 − cos 2a = 2 sin² a.
        Quad one = Quad.Of(1.0);
        Quad two = Quad.Of(2.0);
        Quad half = two * (s * (one - v));
        Quad halfVersine = two * (s * s);
        sin = two * (half * (one - halfVersine));
        cos = one - (two * (half * half));
    }

    /// <summary>Computes sines alone, in half the operations.</summary>
    /// <remarks>The absolute error is below 4e-16 for angles below one turn; larger angles add their own rounding error.</remarks>
    /// <param name="turns">The angles divided by 2π; below 1e15 in magnitude.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quad Sin(Quad turns)
    {
        // sin 2πx = cos 2π(x − ¼) = sin 2πw with w = ¼ − |x − ¼ − n|, n the nearest integer: |w| ≤ ¼.
        Quad shifted = turns - Quad.Of(0.25);
        Quad whole = (shifted + Quad.Of(Rounder)) - Quad.Of(Rounder);
        Quad w = Quad.Of(0.25) - (shifted - whole).Abs;

        // A polynomial through Chebyshev points of w², with a remainder below 2e-16.
        Quad z = w * w;
        Quad zz = z * z;
        return w * (Quartet(6.283185307179585, -41.341702240398284, 81.60524927557977, -76.70585968962867, z, zz)
            + (zz * zz * Quartet(42.05868995395094, -15.09450614073429, 3.817365633469135, -0.6925067010720717, z, zz)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Quad Pair(double a, double b, Quad z) => Quad.Of(a) + (Quad.Of(b) * z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Quad Quartet(double a, double b, double c, double d, Quad z, Quad zz) => Pair(a, b, z) + (zz * Pair(c, d, z));
}
