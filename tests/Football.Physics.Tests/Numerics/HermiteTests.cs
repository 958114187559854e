using FootballPhysics.Numerics;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Numerics;

/// <summary>The Hermite interpolants: what they were made of comes back, and polynomials of their degree are exact.</summary>
public sealed class HermiteTests
{
    [Fact]
    public void A_cubic_is_its_own_interpolant()
    {
        var random = new Shots(31);
        for (int i = 0; i < 200; i++)
        {
            double[] c = [random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1)];
            double Value(double s) => c[0] + (s * (c[1] + (s * (c[2] + (s * c[3])))));
            double Slope(double s) => c[1] + (s * ((2 * c[2]) + (s * 3 * c[3])));
            var curve = new CubicHermite(Value(0), Slope(0), Value(1), Slope(1));
            double at = random.Uniform(-0.5, 1.5);
            Assert.Equal(Value(at), curve.At(at), 1e-13);
            Assert.Equal(Slope(at), curve.SlopeAt(at), 1e-13);
        }
    }

    [Fact]
    public void The_extremes_of_a_cubic_are_where_its_slope_is_zero()
    {
        var random = new Shots(32);
        for (int i = 0; i < 200; i++)
        {
            var dip = new CubicHermite(random.Uniform(-1, 1), random.Uniform(-3, -0.1), random.Uniform(-1, 1), random.Uniform(0.1, 3));
            Assert.Equal(0, dip.SlopeAt(dip.Lowest), 1e-12);
            Assert.InRange(dip.Lowest, 0, 1);
            var top = new CubicHermite(-dip.C0, -dip.C1, -dip.At(1), -dip.SlopeAt(1));
            Assert.Equal(dip.Lowest, top.Highest, 1e-12);
            for (double s = 0; s <= 1; s += 0.01)
            {
                Assert.True(dip.At(dip.Lowest) <= dip.At(s) + 1e-12);
                Assert.True(top.At(top.Highest) >= top.At(s) - 1e-12);
            }
        }
    }

    [Fact]
    public void A_curve_without_an_extreme_has_its_end_for_one() => Assert.Equal(1, new CubicHermite(0, 1, 1, 1).Lowest);

    [Fact]
    public void A_motion_of_third_order_is_its_own_cubic_interpolant()
    {
        var random = new Shots(33);
        for (int i = 0; i < 200; i++)
        {
            double h = random.Uniform(0.01, 2);
            Vector3d[] c = [.. Enumerable.Range(0, 4).Select(_ => random.Direction())];
            var curve = PathSegment.Cubic(Position(c, 0), Velocity(c, 0), Position(c, h), Velocity(c, h), h);
            double t = random.Uniform(0, h);
            Assert.True(Vector3d.Distance(Position(c, t), curve.PositionAt(t)) < 1e-13);
            Assert.True(Vector3d.Distance(Velocity(c, t), curve.VelocityAt(t)) < 1e-12);
        }
    }

    [Fact]
    public void A_motion_of_fifth_order_is_its_own_quintic_interpolant()
    {
        var random = new Shots(34);
        for (int i = 0; i < 200; i++)
        {
            double h = random.Uniform(0.01, 2);
            Vector3d[] c = [.. Enumerable.Range(0, 6).Select(_ => random.Direction())];
            var curve = new PathSegment(
                0, h, Position(c, 0), Velocity(c, 0), Acceleration(c, 0), Position(c, h), Velocity(c, h), Acceleration(c, h), MotionState.Airborne, 5);
            double t = random.Uniform(0, h);
            Assert.True(Vector3d.Distance(Position(c, t), curve.PositionAt(t)) < 1e-12);
            Assert.True(Vector3d.Distance(Velocity(c, t), curve.VelocityAt(t)) < 1e-10);
        }
    }

    private static Vector3d Position(Vector3d[] c, double t) => Sum(c, n => Math.Pow(t, n));

    private static Vector3d Velocity(Vector3d[] c, double t) => Sum(c, n => n == 0 ? 0 : n * Math.Pow(t, n - 1));

    private static Vector3d Acceleration(Vector3d[] c, double t) => Sum(c, n => n < 2 ? 0 : n * (n - 1) * Math.Pow(t, n - 2));

    private static Vector3d Sum(Vector3d[] c, Func<int, double> factor)
    {
        Vector3d sum = Vector3d.Zero;
        for (int n = 0; n < c.Length; n++)
        {
            sum += factor(n) * c[n];
        }

        return sum;
    }
}
