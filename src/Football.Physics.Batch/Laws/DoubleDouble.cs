using System.Runtime.CompilerServices;

namespace FootballPhysics.Batch;

/// <summary>A number as the sum of two doubles, with 31 digits (Dekker).</summary>
/// <remarks>Constants computed with it are the exact values rounded to double, whatever the order of computation.</remarks>
internal readonly struct DoubleDouble
{
    /// <summary>π.</summary>
    public static readonly DoubleDouble Pi = new(3.141592653589793116, 1.224646799147353207e-16);

    /// <summary>ln 2.</summary>
    public static readonly DoubleDouble Ln2 = new(0.6931471805599452862, 2.319046813846299558e-17);

    /// <summary>The number, rounded to double.</summary>
    public readonly double High;

    /// <summary>The rounding error of <see cref="High"/>.</summary>
    public readonly double Low;

    private DoubleDouble(double high, double low)
    {
        High = high;
        Low = low;
    }

    public static implicit operator DoubleDouble(double value) => new(value, 0);

    public static DoubleDouble operator -(in DoubleDouble a) => new(-a.High, -a.Low);

    public static DoubleDouble operator +(in DoubleDouble a, in DoubleDouble b)
    {
        // The rounding error of a sum is itself a double (Knuth).
        double high = a.High + b.High;
        double part = high - a.High;
        double low = (a.High - (high - part)) + (b.High - part);
        return Joined(high, low + (a.Low + b.Low));
    }

    public static DoubleDouble operator -(in DoubleDouble a, in DoubleDouble b) => a + (-b);

    public static DoubleDouble operator *(in DoubleDouble a, in DoubleDouble b)
    {
        // Compute the rounding error of a product from 26-bit halves, whose products are exact (Dekker).
        Halves(a.High, out double a1, out double a2);
        Halves(b.High, out double b1, out double b2);
        double high = a.High * b.High;
        double low = (((a1 * b1) - high) + (a1 * b2) + (a2 * b1)) + (a2 * b2);
        return Joined(high, low + ((a.High * b.Low) + (a.Low * b.High)));
    }

    public static DoubleDouble operator /(in DoubleDouble a, in DoubleDouble b)
    {
        // Long division: three quotients, each of the remainder before it.
        double first = a.High / b.High;
        DoubleDouble rest = a - (b * first);
        double second = rest.High / b.High;
        rest -= b * second;
        return Joined(first, second) + (rest.High / b.High);
    }

    /// <summary>Returns e^x for |x| ≤ 700.</summary>
    public static DoubleDouble Exp(in DoubleDouble x)
    {
        // e^x = 2^k e^r with |r| ≤ ln 2/2; 28 terms of the series give 31 digits.
        double k = Math.Floor((x.High / Ln2.High) + 0.5);
        DoubleDouble r = x - (Ln2 * k);
        DoubleDouble sum = 1;
        for (int n = 28; n >= 1; n--)
        {
            sum = 1 + (sum * r / n);
        }

        double scale = BitConverter.Int64BitsToDouble(((long)k + 1023L) << 52);
        return new DoubleDouble(sum.High * scale, sum.Low * scale);
    }

    /// <summary>Returns the cosine for |x| ≤ π.</summary>
    public static DoubleDouble Cos(in DoubleDouble x)
    {
        // Sum the series up to x⁴⁸/48!; for |x| ≤ π, the remainder is below 1e-39.
        DoubleDouble square = x * x;
        DoubleDouble sum = 1;
        for (int n = 48; n >= 2; n -= 2)
        {
            sum = 1 - (sum * square / (n * (n - 1.0)));
        }

        return sum;
    }

    /// <summary>Adds two numbers, the second much smaller, and splits the sum into its rounded value and the error.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static DoubleDouble Joined(double high, double low)
    {
        double sum = high + low;
        return new DoubleDouble(sum, low - (sum - high));
    }

    /// <summary>Splits a double into two halves with half the digits each.</summary>
    private static void Halves(double value, out double high, out double low)
    {
        // Veltkamp's split: the rounded upper 26 bits, and the remainder.
        double shifted = 134217729.0 * value; // 2^27 + 1
        high = shifted - (shifted - value);
        low = value - high;
    }
}
