namespace FootballPhysics.Tests.Numerics;

/// <summary>Polynomials through a function's values at the Chebyshev points.</summary>
public sealed class ChebyshevFitTests
{
    [Fact]
    public void A_polynomial_is_its_own_fit()
    {
        double[] fit = ChebyshevFit.Polynomial(x => 3 - (x * (2 - (x * x * 0.5))), -1, 4, 3);
        Assert.Equal([3, -2, 0, 0.5], fit.Select(c => Math.Round(c, 15)));
    }

    /// <summary>The error of the best polynomial of degree 5 for 2^x, as (ln 2 / 2)^6 / (6! 2^5) of it; at most a little more is allowed.</summary>
    [Fact]
    public void The_error_is_nearly_the_least_there_is()
    {
        double[] fit = ChebyshevFit.Polynomial(x => DoubleDouble.Exp(DoubleDouble.Ln2 * x), -0.5, 0.5, 5);
        double worst = Enumerable.Range(0, 1001).Select(i => -0.5 + (i / 1000.0)).Max(x => Math.Abs(Value(fit, x) - Math.Pow(2, x)));
        double least = Math.Pow(0.5 * Math.Log(2), 6) / (720 * 32);
        Assert.InRange(worst, least, 1.2 * least);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(5)]
    [InlineData(9)]
    public void It_goes_through_the_function_at_the_Chebyshev_points(int degree)
    {
        const double Low = -0.3;
        const double High = 1.1;
        double[] fit = ChebyshevFit.Polynomial(x => DoubleDouble.Exp(x), Low, High, degree);
        Assert.Equal(degree + 1, fit.Length);
        for (int i = 0; i <= degree; i++)
        {
            double at = (0.5 * (Low + High)) - (0.5 * (High - Low) * Math.Cos(Math.PI * ((2 * i) + 1) / (2 * (degree + 1))));
            Assert.Equal(Math.Exp(at), Value(fit, at), 1e-14);
        }
    }

    private static double Value(double[] coefficients, double x) => coefficients.Reverse().Aggregate(0.0, (sum, c) => (sum * x) + c);
}
