using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Numerics;

/// <summary>Four sines at once, and logarithms by table.</summary>
public sealed class QuadTests
{
    [Fact]
    public void Sine_and_cosine_hold_their_error_over_a_turn()
    {
        for (int i = -100_000; i <= 100_000; i++)
        {
            double turns = i / 100_000.0;
            QuadSine.SinCos(new Quad(turns, 0, 0, 0), out Quad sin, out _);
            QuadSine.SinCos(new Quad(turns, 0.25, 0.25, 0.25), out _, out Quad cos);
            (double expectedSin, double expectedCos) = SinCosOfTurn(i);
            Assert.InRange(sin.Sum - expectedSin, -1e-13, 1e-13);
            Assert.InRange(cos.Sum - expectedCos, -1e-13, 1e-13);
        }
    }

    /// <summary>Of 2π i/100 000: the nearest quarter of a turn is taken off in whole numbers, so that the angle carries no rounding of 2π.</summary>
    private static (double Sin, double Cos) SinCosOfTurn(int i)
    {
        int quarters = (int)Math.Round(i / 25_000.0);
        Elementary.SinCos(2 * Math.PI * (i - (25_000 * quarters)) / 100_000.0, out double sin, out double cos);
        return (quarters & 3) switch
        {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        };
    }

    [Fact]
    public void Each_of_four_angles_has_its_own()
    {
        QuadSine.SinCos(new Quad(0.25, 1 / 12.0, 0, 0.75), out Quad sin, out Quad cos);
        Assert.Equal(1 + 0.5 + 0 - 1, sin.Sum, 1e-13);
        Assert.Equal(0 + Math.Sqrt(0.75) + 1 + 0, cos.Sum, 1e-13);
    }

    [Theory]
    [InlineData(1e6 + 0.125, 0.70710678118654752)]
    [InlineData(-4e9 - 0.25, -1)]
    [InlineData(1e12 + 0.5, 0)]
    public void Whole_turns_do_not_count(double turns, double expected)
    {
        QuadSine.SinCos(new Quad(turns, 0, 0, 0), out Quad sin, out _);
        Assert.Equal(expected, sin.Sum, 1e-13);
    }

    [Fact]
    public void The_logarithm_by_table_holds_its_error()
    {
        for (int i = 0; i <= 40_000; i++)
        {
            double x = Math.Pow(10, -300 + (600.0 * i / 40_000));
            double near = 0.5 + (i / 10_000.0);
            Assert.InRange(LogarithmTable.Of(x) - Math.Log(x), -1e-11, 1e-11);
            Assert.InRange(LogarithmTable.Of(near) - Math.Log(near), -1e-11, 1e-11);
        }
    }
}
