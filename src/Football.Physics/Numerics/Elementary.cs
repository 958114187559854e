namespace FootballPhysics.Numerics;

/// <summary>Elementary functions from + − × ÷ and bit operations alone: bit-identical on every IEEE machine.</summary>
/// <remarks>The functions of the C runtime differ between operating systems. The tests measure the errors.</remarks>
internal static class Elementary
{
    /// <summary>log₂ e.</summary>
    public const double Log2E = 1.4426950408889634;

    /// <summary>√2.</summary>
    public const double Root2 = 1.4142135623730951;

    private const double Ln2High = 6.93147180369123816490e-01; // ln 2 with the low 32 bits cleared: k · Ln2High is exact
    private const double Ln2Low = 1.90821492927058770002e-10;
    private const double TwoOverPi = 0.63661977236758134308;
    private const double HalfPi1 = 1.57079632673412561417e+00; // π/2 in three parts of 33 bits
    private const double HalfPi2 = 6.07710050630396597660e-11;
    private const double HalfPi3 = 2.02226624879595063154e-21;
    private const double TwoPi = 6.28318530717958647693;

    /// <summary>Returns e^x with a relative error below 4e-16.</summary>
    /// <remarks>The argument is clamped to ±708, so that the result is finite and normal.</remarks>
    public static double Exp(double x)
    {
        x = x < -708.0 ? -708.0 : x > 708.0 ? 708.0 : x;

        // x = k ln 2 + r, with ln 2 in two parts, so that r keeps all its digits.
        double k = Math.Floor((x * Log2E) + 0.5);
        double r = (x - (k * Ln2High)) - (k * Ln2Low);

        // Taylor series for |r| ≤ ln2/2, remainder below 1e-17.
        double p = 1.0 / 6227020800.0;
        p = (p * r) + (1.0 / 479001600.0);
        p = (p * r) + (1.0 / 39916800.0);
        p = (p * r) + (1.0 / 3628800.0);
        p = (p * r) + (1.0 / 362880.0);
        p = (p * r) + (1.0 / 40320.0);
        p = (p * r) + (1.0 / 5040.0);
        p = (p * r) + (1.0 / 720.0);
        p = (p * r) + (1.0 / 120.0);
        p = (p * r) + (1.0 / 24.0);
        p = (p * r) + (1.0 / 6.0);
        p = (p * r) + 0.5;
        p = 1.0 + (r + (r * r * p));

        // Build 2^k from its exponent bits.
        return p * BitConverter.Int64BitsToDouble(((long)k + 1023L) << 52);
    }

    /// <summary>Returns the natural logarithm of a positive normal number.</summary>
    /// <remarks>The absolute error is below 1e-15 near 1, the relative error below 3e-16 elsewhere.</remarks>
    public static double Log(double x)
    {
        // x = 2^e m, with m from √½ to √2 so that no cancellation occurs near 1.
        long bits = BitConverter.DoubleToInt64Bits(x);
        double e = (bits >> 52) - 1023L;
        double m = BitConverter.Int64BitsToDouble((bits & 0x000FFFFFFFFFFFFFL) | 0x3FF0000000000000L);
        if (m > Root2)
        {
            m *= 0.5;
            e += 1.0;
        }

        // ln m = 2 (s + s³/3 + s⁵/5 + …), s = (m − 1)/(m + 1), |s| ≤ 0.1716
        double s = (m - 1.0) / (m + 1.0);
        double z = s * s;
        double p = 1.0 / 23.0;
        p = (p * z) + (1.0 / 21.0);
        p = (p * z) + (1.0 / 19.0);
        p = (p * z) + (1.0 / 17.0);
        p = (p * z) + (1.0 / 15.0);
        p = (p * z) + (1.0 / 13.0);
        p = (p * z) + (1.0 / 11.0);
        p = (p * z) + (1.0 / 9.0);
        p = (p * z) + (1.0 / 7.0);
        p = (p * z) + (1.0 / 5.0);
        p = (p * z) + (1.0 / 3.0);

        // Add the parts from the smallest to the largest.
        double tail = 2.0 * s * z * p;
        return (e * Ln2High) + ((2.0 * s) + (tail + (e * Ln2Low)));
    }

    /// <summary>Returns x^q for positive normal x, with a relative error below (1 + |q ln x|) · 4e-16.</summary>
    public static double Pow(double x, double q) => Exp(q * Log(x));

    /// <summary>Returns the logistic function 1/(1 + e^−x), with a relative error below 1e-15.</summary>
    public static double Logistic(double x) => 1.0 / (1.0 + Exp(-x));

    /// <summary>Computes sine and cosine, with an absolute error below 2e-16 for |x| ≤ 1e5; finite for every finite x.</summary>
    public static void SinCos(double x, out double sin, out double cos)
    {
        // For larger arguments, k times a part of π/2 would be inexact: remove full turns first.
        if (!(x < 1e5 && x > -1e5))
        {
            x %= TwoPi;
        }

        // x = k π/2 + r.
        double k = Math.Floor((x * TwoOverPi) + 0.5);
        double r = ((x - (k * HalfPi1)) - (k * HalfPi2)) - (k * HalfPi3);
        double z = r * r;

        // Taylor series for |r| ≤ π/4, with remainders below 1e-17.
        double s = -1.0 / 1307674368000.0;
        s = (s * z) + (1.0 / 6227020800.0);
        s = (s * z) - (1.0 / 39916800.0);
        s = (s * z) + (1.0 / 362880.0);
        s = (s * z) - (1.0 / 5040.0);
        s = (s * z) + (1.0 / 120.0);
        s = (s * z) - (1.0 / 6.0);
        s = r + (r * z * s);

        double c = 1.0 / 20922789888000.0;
        c = (c * z) - (1.0 / 87178291200.0);
        c = (c * z) + (1.0 / 479001600.0);
        c = (c * z) - (1.0 / 3628800.0);
        c = (c * z) + (1.0 / 40320.0);
        c = (c * z) - (1.0 / 720.0);
        c = (c * z) + (1.0 / 24.0);
        c = 1.0 - ((0.5 * z) - (z * z * c));

        // Each quarter turn swaps sine and cosine, and changes one sign.
        switch ((long)k & 3L)
        {
            case 0:
                sin = s;
                cos = c;
                break;
            case 1:
                sin = c;
                cos = -s;
                break;
            case 2:
                sin = -s;
                cos = -c;
                break;
            default:
                sin = -c;
                cos = s;
                break;
        }
    }

    /// <summary>Returns the angle of the point (x, y), −π … π; 0 for the origin. The absolute error is below 1e-15.</summary>
    public static double Atan2(double y, double x)
    {
        const double Pi = 3.14159265358979323846;
        double ax = Math.Abs(x);
        double ay = Math.Abs(y);
        if (!(ax > 0 || ay > 0))
        {
            return 0;
        }

        // Reduce the argument to 0 … 1 with atan q = π/2 − atan 1/q.
        double angle = ay <= ax ? AtanUnit(ay / ax) : (0.5 * Pi) - AtanUnit(ax / ay);
        angle = x < 0 ? Pi - angle : angle;
        return y < 0 ? -angle : angle;
    }

    /// <summary>Returns atan x for 0 ≤ x ≤ 1.</summary>
    private static double AtanUnit(double x)
    {
        // atan x = atan c + atan((x − c)/(1 + x c)) with c = 0, tan π/8 or 1, so that |z| ≤ tan π/16 = 0.199.
        const double TanEighth = 0.41421356237309504880;
        const double PiEighth = 0.39269908169872415481;

        // The interval borders are tan π/16 and tan 3π/16.
        double c = x < 0.19891236737965800691 ? 0 : x < 0.66817863791929891999 ? TanEighth : 1;
        double offset = c == 0 ? 0 : c == 1 ? 2 * PiEighth : PiEighth;
        double z = (x - c) / (1.0 + (x * c));
        double zz = z * z;
        double p = 1.0 / 23.0;
        for (int n = 21; n >= 3; n -= 2)
        {
            p = (1.0 / n) - (zz * p);
        }

        return offset + (z - (z * zz * p));
    }
}
