namespace Football.Physics.Tests.Numerics;

public sealed class SineTableTests
{
    [Fact]
    public void Sine_and_cosine_hold_their_error_over_a_turn()
    {
        for (int i = -100_000; i <= 100_000; i++)
        {
            double turns = i / 100_000.0;
            SineTable.SinCos(turns, out double sin, out double cos);
            Elementary.SinCos(2 * Math.PI * turns, out double expectedSin, out double expectedCos);
            Assert.InRange(sin - expectedSin, -1e-15, 1e-15);
            Assert.InRange(cos - expectedCos, -1e-15, 1e-15);
        }
    }

    [Theory]
    [InlineData(1e6 + 0.125, 0.70710678118654752)]
    [InlineData(-4e9 - 0.25, -1)]
    [InlineData(1e12 + 0.5, 0)]
    public void Whole_turns_do_not_count(double turns, double expected)
    {
        SineTable.SinCos(turns, out double sin, out double cos);
        Assert.Equal(expected, sin, 1e-15);
        Assert.Equal(1, (sin * sin) + (cos * cos), 1e-14);
    }
}
