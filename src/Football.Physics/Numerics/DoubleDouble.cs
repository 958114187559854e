using System.Runtime.CompilerServices;

namespace FootballPhysics;

/// <summary>
/// A number as the sum of two doubles, to 31 digits (Dekker): for constants that are computed once, so that each is its exact value
/// rounded to double, whatever the order in which it was computed.
/// </summary>
internal readonly struct DoubleDouble
{
    /// <summary>π.</summary>
    public static readonly DoubleDouble Pi = new(3.141592653589793116, 1.224646799147353207e-16);

    /// <summary>ln 2.</summary>
    public static readonly DoubleDouble Ln2 = new(0.6931471805599452862, 2.319046813846299558e-17);

    /// <summary>The number rounded to double.</summary>
    public readonly double High;

    /// <summary>Rounding error of that.</summary>
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
        // The error of a sum is a double too (Knuth).
        double high = a.High + b.High;
        double part = high - a.High;
        double low = (a.High - (high - part)) + (b.High - part);
        return Joined(high, low + (a.Low + b.Low));
    }

    public static DoubleDouble operator -(in DoubleDouble a, in DoubleDouble b) => a + (-b);

    public static DoubleDouble operator *(in DoubleDouble a, in DoubleDouble b)
    {
        // The error of a product, from halves of 26 bits whose products are exact (Dekker).
        Halves(a.High, out double a1, out double a2);
        Halves(b.High, out double b1, out double b2);
        double high = a.High * b.High;
        double low = (((a1 * b1) - high) + (a1 * b2) + (a2 * b1)) + (a2 * b2);
        return Joined(high, low + ((a.High * b.Low) + (a.Low * b.High)));
    }

    public static DoubleDouble operator /(in DoubleDouble a, in DoubleDouble b)
    {
        // Long division: three quotients, each of what the last left over.
        double first = a.High / b.High;
        DoubleDouble rest = a - (b * first);
        double second = rest.High / b.High;
        rest -= b * second;
        return Joined(first, second) + (rest.High / b.High);
    }

    /// <summary>A decimal fraction, such as a constant as it is printed.</summary>
    /// <param name="value">The fraction; at most 15 digits.</param>
    public static DoubleDouble Of(decimal value)
    {
        // A whole number and a power of ten, both exact as long as they have fewer than 16 digits.
        double scale = 1;
        while (value != decimal.Truncate(value))
        {
            value *= 10;
            scale *= 10;
        }

        return (DoubleDouble)(double)value / scale;
    }

    /// <summary>e^x for |x| ≤ 700.</summary>
    public static DoubleDouble Exp(in DoubleDouble x)
    {
        // e^x = 2^k e^r with |r| ≤ ln 2/2; 28 terms of the series are enough for 31 digits.
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

    /// <summary>The cosine for |x| ≤ π.</summary>
    public static DoubleDouble Cos(in DoubleDouble x)
    {
        // The series to x⁴⁸/48!: for |x| ≤ π what follows is below 1e-39.
        DoubleDouble square = x * x;
        DoubleDouble sum = 1;
        for (int n = 48; n >= 2; n -= 2)
        {
            sum = 1 - (sum * square / (n * (n - 1.0)));
        }

        return sum;
    }

    /// <summary>Two numbers, the second much the smaller, as a sum whose first part is rounded.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static DoubleDouble Joined(double high, double low)
    {
        double sum = high + low;
        return new DoubleDouble(sum, low - (sum - high));
    }

    /// <summary>A double as the sum of two of half the digits.</summary>
    private static void Halves(double value, out double high, out double low)
    {
        // Veltkamp's split: the upper 26 bits, rounded, and what is left.
        double shifted = 134217729.0 * value; // 2^27 + 1
        high = shifted - (shifted - value);
        low = value - high;
    }
}
