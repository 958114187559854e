using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// The two plates of the spin decay beside one without spin, G(X) = ((1 + x)^p + (1 − x)^p)/2 with X = x² = (r|ω|/2|u|)² and p the
/// exponent of their speed: a polynomial, good to 4e-11 up to <see cref="LargestRatio"/>.
/// </summary>
internal static class PlateSeries
{
    /// <summary>The largest X.</summary>
    public const decimal LargestRatio = 0.28m;

    private static readonly double[] Coefficients = ChebyshevFit.Polynomial(Rise, 0, DoubleDouble.Of(LargestRatio), 5);
    private static readonly double C2 = Coefficients[0];
    private static readonly double C4 = Coefficients[1];
    private static readonly double C6 = Coefficients[2];
    private static readonly double C8 = Coefficients[3];
    private static readonly double C10 = Coefficients[4];
    private static readonly double C12 = Coefficients[5];

    /// <summary>Makes the coefficients, if they are not: methods compiled later know them as constants.</summary>
    public static void Make() => RuntimeHelpers.RunClassConstructor(typeof(PlateSeries).TypeHandle);

    /// <summary>(G − 1)/X.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double At(double x) => C2 + (x * (C4 + (x * (C6 + (x * (C8 + (x * (C10 + (x * C12)))))))));

    /// <summary>dG/dX, but for X⁴ and what comes after.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double SlopeAt(double x) => C2 + (x * ((2.0 * C4) + (x * ((3.0 * C6) + (x * (4.0 * C8))))));

    /// <summary>(G − 1)/X by the binomial series, p(p − 1)/2! + p(p − 1)(p − 2)(p − 3)/4! X + …</summary>
    private static DoubleDouble Rise(DoubleDouble x)
    {
        const int Terms = 64; // 0.28^64 is 4e-36
        DoubleDouble p = DoubleDouble.Of(EmpiricalSpinDecay.SpeedExponent);
        DoubleDouble term = 0.5 * p * (p - 1);
        DoubleDouble sum = 0;
        for (int k = 2; k < 2 * Terms; k += 2)
        {
            sum += term;
            term *= x * (p - k) * (p - (k + 1.0)) / ((k + 1.0) * (k + 2.0));
        }

        return sum;
    }
}
