namespace FootballPhysics.Tests.Batch;

/// <summary>The functions of lanes: where their literals come from, and what they are worth.</summary>
public sealed class LaneMathTests
{
    /// <summary>log₂ m = 2/ln 2 · s (1 + s²/3 + s⁴/5 + …) with s = (m − 1)/(m + 1).</summary>
    [Fact]
    public void The_polynomial_of_the_logarithm_is_its_fit()
    {
        DoubleDouble greatest = DoubleDouble.Exp(0.5 * DoubleDouble.Ln2);
        greatest = (greatest - 1) / (greatest + 1);
        double[] fit = ChebyshevFit.Polynomial(
            square =>
            {
                DoubleDouble sum = 0;
                for (int n = 61; n >= 1; n -= 2)
                {
                    sum = (1 / (DoubleDouble)n) + (square * sum);
                }

                return 2 * sum / DoubleDouble.Ln2;
            },
            0,
            greatest * greatest,
            2);
        Assert.Equal([LaneMath<Lanes1>.L0, LaneMath<Lanes1>.L2, LaneMath<Lanes1>.L4], fit.Select(c => (float)c));
    }

    [Fact]
    public void The_polynomial_of_the_exponential_is_its_fit()
    {
        double[] fit = ChebyshevFit.Polynomial(x => DoubleDouble.Exp(DoubleDouble.Ln2 * x), -0.5, 0.5, 5);
        Assert.Equal(
            [
                LaneMath<Lanes1>.E0, LaneMath<Lanes1>.E1, LaneMath<Lanes1>.E2,
                LaneMath<Lanes1>.E3, LaneMath<Lanes1>.E4, LaneMath<Lanes1>.E5,
            ],
            fit.Select(c => (float)c));
    }

    [Fact]
    public void The_logarithm_holds_its_error()
    {
        for (double exponent = -120; exponent < 120; exponent += 0.0137)
        {
            float x = (float)Math.Pow(2, exponent);
            double expected = Math.Log2(x);
            double rounding = Math.Abs(expected) * 6e-8;
            Assert.Equal(expected, Value(LaneMath<Lanes1>.Log2(Lanes1.Of(x), 0)), 1.3e-7 + rounding);
        }
    }

    [Fact]
    public void The_exponential_holds_its_error()
    {
        for (double x = -126; x <= 127; x += 0.00973)
        {
            float at = (float)x;
            Assert.Equal(1, Value(LaneMath<Lanes1>.Exp2(Lanes1.Of(at))) / Math.Pow(2, at), 3e-7);
        }
    }

    /// <summary>Exponents and domains of the fitted laws: in float a power is good to 2e-7.</summary>
    [Theory]
    [InlineData(0.3056, -3.8, 2.9, 7)]
    [InlineData(-0.1528, -3.3, 5.5, 6)]
    [InlineData(-0.17, -13, 2.9, 8)]
    [InlineData(0.085, -9.5, 5.5, 6)]
    public void A_power_is_a_polynomial_in_the_logarithm(double exponent, double low, double high, int degree)
    {
        var polynomial = LanePolynomial.OfPower(0.7, exponent, low, high, degree);
        for (double z = low; z <= high; z += 0.01)
        {
            Lanes1 x = Lanes1.Of((float)z);
            Lanes1 power = degree switch
            {
                8 => LaneMath<Lanes1>.Degree8(in polynomial, x, x * x, x * x * (x * x)),
                7 => LaneMath<Lanes1>.Degree7(in polynomial, x, x * x, x * x * (x * x)),
                _ => LaneMath<Lanes1>.Degree6(in polynomial, x, x * x, x * x * (x * x)),
            };
            Assert.Equal(1, Value(power) / (0.7 * Math.Pow(2, exponent * z)), 6e-7);
        }
    }

    private static float Value(Lanes1 x)
    {
        var to = new float[1];
        Lanes1.Store(x, to, 0);
        return to[0];
    }
}
