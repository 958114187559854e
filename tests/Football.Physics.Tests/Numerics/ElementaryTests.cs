using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Numerics;

/// <summary>The library's own elementary functions against the runtime's, with the errors that they state.</summary>
public sealed class ElementaryTests
{
    private const int Samples = 40_000;

    [Fact]
    public void Exp_holds_its_error_from_end_to_end()
    {
        for (int i = 0; i <= Samples; i++)
        {
            double x = -708 + (1416.0 * i / Samples);
            Near(Math.Exp(x), Elementary.Exp(x), 4.5e-16, x);
        }

        foreach (double x in Small())
        {
            Near(Math.Exp(x), Elementary.Exp(x), 4.5e-16, x);
            Near(Math.Exp(-x), Elementary.Exp(-x), 4.5e-16, -x);
        }
    }

    [Fact]
    public void Exp_beyond_its_domain_is_limited()
    {
        Assert.Equal(Elementary.Exp(708), Elementary.Exp(1e300));
        Assert.Equal(Elementary.Exp(-708), Elementary.Exp(double.NegativeInfinity));
        Assert.True(double.IsNormal(Elementary.Exp(-709)));
    }

    [Fact]
    public void Log_holds_its_error_over_all_normal_numbers()
    {
        for (int i = 0; i <= Samples; i++)
        {
            double x = Math.Pow(10, -307 + (614.0 * i / Samples));
            Near(Math.Log(x), Elementary.Log(x), 4.5e-16, x);
            double near = 0.5 + (1.5 * i / Samples);
            Assert.InRange(Elementary.Log(near) - Math.Log(near), -1e-15, 1e-15);
        }
    }

    [Fact]
    public void Pow_holds_its_error()
    {
        foreach (double q in new[] { -0.2, 0.3056, 0.83, 1.8, 7.0 })
        {
            for (int i = 0; i <= Samples / 10; i++)
            {
                double x = Math.Pow(10, -30 + (60.0 * i / (Samples / 10)));
                Near(Math.Pow(x, q), Elementary.Pow(x, q), (1 + Math.Abs(q * Math.Log(x))) * 4.5e-16, x);
            }
        }
    }

    [Fact]
    public void SinCos_holds_its_error_to_a_hundred_thousand_radians()
    {
        for (int i = -Samples; i <= Samples; i++)
        {
            // Dense near zero, then to the end of the domain.
            double x = Math.Sign(i) * 1e5 * Math.Pow(Math.Abs((double)i) / Samples, 4) * (1 - 1e-12);
            Elementary.SinCos(x, out double sin, out double cos);
            Assert.InRange(sin - Math.Sin(x), -2.3e-16, 2.3e-16);
            Assert.InRange(cos - Math.Cos(x), -2.3e-16, 2.3e-16);
        }
    }

    [Fact]
    public void Atan2_holds_its_error_all_around()
    {
        for (int i = -Samples; i <= Samples; i++)
        {
            double angle = Math.PI * i / Samples;
            foreach (double size in new[] { 1e-200, 1e-3, 1, 1e9 })
            {
                double x = size * Math.Cos(angle);
                double y = size * Math.Sin(angle);
                Assert.InRange(Elementary.Atan2(y, x) - Math.Atan2(y, x), -1e-15, 1e-15);
            }
        }

        Assert.Equal(0, Elementary.Atan2(0, 0));
        Assert.Equal(Math.PI, Elementary.Atan2(0, -1));
        Assert.Equal(-Math.PI / 2, Elementary.Atan2(-1, 0));
    }

    [Theory]
    [InlineData(1e6)]
    [InlineData(-1e9)]
    [InlineData(1e300)]
    public void SinCos_of_any_finite_number_lies_on_the_unit_circle(double x)
    {
        Elementary.SinCos(x, out double sin, out double cos);
        Assert.Equal(1, (sin * sin) + (cos * cos), 1e-15);
    }

    [Theory]
    [InlineData(0.3056)]
    [InlineData(0.83)]
    [InlineData(1.8)]
    [InlineData(0.0)]
    [InlineData(2.0)]
    public void A_power_table_holds_its_error_over_all_normal_numbers(double q)
    {
        var table = new PowerTable(q);
        double low = q > 1 ? -150 : -300; // where the power itself is a normal number
        for (int i = 0; i <= Samples; i++)
        {
            double x = Math.Pow(10, low + (-2 * low * i / Samples));
            Near(Math.Pow(x, q), table.Of(x), 3e-12, x);
        }

        Assert.Equal(q == 0 ? 1 : 0, table.Of(0));
        Assert.Equal(q == 0 ? 1 : 0, table.Of(double.Epsilon)); // The power of anything that small is taken as zero.
    }

    private static IEnumerable<double> Small() => Enumerable.Range(0, 400).Select(i => Math.Pow(10, -i / 20.0));

    private static void Near(double expected, double actual, double relative, double at) =>
        Assert.True(Math.Abs(actual - expected) <= relative * Math.Abs(expected), $"at {at:R}: {actual:R}, expected {expected:R}");
}
