using System.Numerics;

namespace FootballPhysics.Tests.Numerics;

/// <summary>Sums of two doubles against whole numbers of any length, in units of 2^−200.</summary>
public sealed class DoubleDoubleTests
{
    private const int Unit = 200;

    /// <summary>Relative error, 2^−100: 30 digits.</summary>
    private static readonly BigInteger s_digits = BigInteger.One << 100;

    [Fact]
    public void The_four_operations_keep_thirty_digits()
    {
        var random = new Random(3);
        for (int i = 0; i < 2000; i++)
        {
            DoubleDouble a = Draw(random);
            DoubleDouble b = Draw(random);
            BigInteger x = Exact(a);
            BigInteger y = Exact(b);
            Near(x + y, a + b, BigInteger.Abs(x) + BigInteger.Abs(y));
            Near(x - y, a - b, BigInteger.Abs(x) + BigInteger.Abs(y));
            Near((x * y) >> Unit, a * b, BigInteger.Abs(x * y) >> Unit);
            Near((x << Unit) / y, a / b, BigInteger.Abs((x << Unit) / y));
        }
    }

    [Fact]
    public void The_first_part_is_the_number_rounded()
    {
        var random = new Random(4);
        for (int i = 0; i < 2000; i++)
        {
            DoubleDouble a = Draw(random) * Draw(random);
            Assert.Equal(a.High, a.High + a.Low);
        }
    }

    /// <summary>Thirty digits from a table.</summary>
    [Fact]
    public void Exponential_and_cosine_have_thirty_digits()
    {
        Near("2.718281828459045235360287471352662497757", DoubleDouble.Exp(1));
        Near("0.000045399929762484851535591515560550610", DoubleDouble.Exp(-10));
        Near("1.414213562373095048801688724209698078570", DoubleDouble.Exp(0.5 * DoubleDouble.Ln2));
        Near("0.540302305868139717400936607442976603733", DoubleDouble.Cos(1));
        Near("-0.989992496600445457271572794731261302", DoubleDouble.Cos(3));
        Near("0.707106781186547524400844362104849039285", DoubleDouble.Cos(DoubleDouble.Pi * 0.25));
    }

    private static DoubleDouble Draw(Random random) =>
        (DoubleDouble)Math.ScaleB(random.NextDouble() - 0.5, random.Next(-10, 10)) + (1e-17 * random.NextDouble());

    private static void Near(string digits, DoubleDouble actual)
    {
        int places = digits.Length - digits.IndexOf('.', StringComparison.Ordinal) - 1;
        BigInteger expected = (BigInteger.Parse(digits.Replace(".", "", StringComparison.Ordinal), System.Globalization.CultureInfo.InvariantCulture) << Unit)
            / BigInteger.Pow(10, places);
        Near(expected, actual, BigInteger.Abs(expected));
    }

    private static void Near(BigInteger expected, DoubleDouble actual, BigInteger size) =>
        Assert.True(BigInteger.Abs(Exact(actual) - expected) * s_digits <= size + s_digits, $"{actual.High:R} + {actual.Low:R}");

    private static BigInteger Exact(DoubleDouble value) => Exact(value.High) + Exact(value.Low);

    private static BigInteger Exact(double value)
    {
        long bits = BitConverter.DoubleToInt64Bits(value);
        int exponent = (int)((bits >> 52) & 2047);
        if (exponent == 0)
        {
            return 0;
        }

        BigInteger mantissa = (bits & 0xFFFFFFFFFFFFFL) | 0x10000000000000L;
        int shift = exponent - 1075 + Unit;
        mantissa = shift >= 0 ? mantissa << shift : mantissa >> -shift;
        return bits < 0 ? -mantissa : mantissa;
    }
}
