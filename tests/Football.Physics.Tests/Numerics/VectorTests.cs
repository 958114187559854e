using System.Numerics;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Numerics;

public sealed class VectorTests
{
    private static readonly Vector3d s_a = new(1, -2, 3);
    private static readonly Vector3d s_b = new(-4, 5, 0.5);

    [Fact]
    public void The_vector_product_is_right_handed()
    {
        Assert.Equal(new Vector3d(0, 0, 1), Vector3d.Cross(new Vector3d(1, 0, 0), Vector3d.Up));
        Assert.Equal(0, Vector3d.Dot(Vector3d.Cross(s_a, s_b), s_a));
        Assert.Equal(0, Vector3d.Dot(Vector3d.Cross(s_a, s_b), s_b));
    }

    [Fact]
    public void Arithmetic_is_by_component()
    {
        Assert.Equal(new Vector3d(-3, 3, 3.5), s_a + s_b);
        Assert.Equal(new Vector3d(5, -7, 2.5), s_a - s_b);
        Assert.Equal(new Vector3d(-1, 2, -3), -s_a);
        Assert.Equal(new Vector3d(2, -4, 6), 2 * s_a);
        Assert.Equal(2 * s_a, s_a * 2);
        Assert.Equal(new Vector3d(0.5, -1, 1.5), s_a / 2);
        Assert.Equal(-12.5, Vector3d.Dot(s_a, s_b));
        Assert.Equal(14, s_a.LengthSquared);
        Assert.Equal(Math.Sqrt(14), s_a.Length);
        Assert.Equal(new Vector3d(1, 0, 3), s_a.Horizontal);
        Assert.Equal((s_a - s_b).Length, Vector3d.Distance(s_a, s_b));
    }

    [Fact]
    public void Single_precision_goes_in_exactly_and_comes_out_rounded()
    {
        Vector3d wide = new Vector3(0.1f, 2, -3);
        Assert.Equal(new Vector3d(0.1f, 2, -3), wide);
        Assert.Equal(new Vector3(0.1f, 2, -3), new Vector3d(0.1, 2, -3).ToVector3());
        Quaterniond q = new Quaternion(0.1f, 0.2f, 0.3f, 0.9f);
        Assert.Equal(new Quaternion(0.1f, 0.2f, 0.3f, 0.9f), q.ToQuaternion());
    }

    [Theory]
    [InlineData(double.NaN, 0, 0)]
    [InlineData(0, double.PositiveInfinity, 0)]
    [InlineData(0, 0, double.NegativeInfinity)]
    public void A_vector_with_one_bad_component_is_not_finite(double x, double y, double z) => Assert.False(new Vector3d(x, y, z).IsFinite);

    [Fact]
    public void A_rotation_turns_vectors_counter_clockwise_about_its_axis()
    {
        Quaterniond quarter = Quaterniond.FromAxisAngle(Vector3d.Up, Math.PI / 2);
        Assert.Equal(0, Vector3d.Distance(quarter.Rotate(new Vector3d(0, 0, 1)), new Vector3d(1, 0, 0)), 1e-15);
        Assert.Equal(0, Differences.Rotation(quarter, Quaterniond.FromRotationVector(new Vector3d(0, Math.PI / 2, 0))), 1e-15);
        Assert.Equal(Quaterniond.Identity, Quaterniond.FromRotationVector(Vector3d.Zero));
    }

    [Fact]
    public void A_product_of_rotations_turns_by_the_right_factor_first()
    {
        Quaterniond a = Quaterniond.FromRotationVector(new Vector3d(0.3, -0.8, 0.1));
        Quaterniond b = Quaterniond.FromRotationVector(new Vector3d(-1.1, 0.2, 0.7));
        Assert.Equal(0, Vector3d.Distance((a * b).Rotate(s_a), a.Rotate(b.Rotate(s_a))), 1e-14);
        Assert.Equal(1, new Quaterniond(1, 2, 3, 4).Normalized().LengthSquared, 1e-15);
    }

    /// <summary>The spin between two orientations turns the first into the second, whatever the signs and the lengths of the quaternions.</summary>
    [Theory]
    [InlineData(0.3, -0.8, 0.1)]
    [InlineData(2.9, 0.4, -1.0)]
    [InlineData(1e-9, 0, 2e-9)]
    [InlineData(0, 0, 0)]
    public void The_spin_between_two_orientations_turns_the_first_into_the_second(double x, double y, double z)
    {
        var turn = new Vector3d(x, y, z);
        Quaterniond from = Quaterniond.FromRotationVector(new Vector3d(-1.1, 0.2, 0.7));
        Quaterniond to = Quaterniond.FromRotationVector(turn) * from;
        foreach (double scale in new[] { 1.0, -1.0, 3.0 })
        {
            Vector3d spin = from.SpinTo(new Quaterniond(scale * to.X, scale * to.Y, scale * to.Z, scale * to.W), duration: 0.02);
            double off = Vector3d.Distance(0.02 * spin, turn);
            Assert.True(off <= 1e-15 + (4e-15 * turn.Length), $"{off:e2}");
        }
    }

    [Fact]
    public void The_spin_between_two_orientations_takes_the_shorter_turn()
    {
        Quaterniond far = Quaterniond.FromAxisAngle(Vector3d.Up, 1.9 * Math.PI);
        Assert.Equal(0, Vector3d.Distance(Quaterniond.Identity.SpinTo(far, 1), -0.1 * Math.PI * Vector3d.Up), 1e-14);
        Assert.Throws<ArgumentOutOfRangeException>(() => Quaterniond.Identity.SpinTo(far, 0));
    }

    /// <summary>A spin that turns about a turning axis, against many small rotations.</summary>
    [Fact]
    public void The_rotation_of_a_turning_spin_is_of_fourth_order_at_least()
    {
        static Vector3d Spin(double t) => new(20 * Math.Cos(9 * t), 7 + (30 * t * t), 20 * Math.Sin(9 * t));
        double Error(int steps)
        {
            Quaterniond q = Quaterniond.Identity;
            double h = 0.2 / steps;
            for (int i = 0; i < steps; i++)
            {
                q = Quaterniond.FromRotationVector(RotationVector.Of(Spin(i * h), Spin((i + 0.5) * h), Spin((i + 1) * h), h)) * q;
            }

            return Differences.Rotation(q, s_turned.Value);
        }

        double coarse = Error(8);
        double fine = Error(16);
        Assert.True(Math.Log2(coarse / fine) > 3.8, $"{coarse:e2} {fine:e2}");
        Assert.True(fine < 1e-5, $"{fine:e2}");
    }

    private static readonly Lazy<Quaterniond> s_turned = new(() =>
    {
        const int Steps = 200_000;
        Quaterniond q = Quaterniond.Identity;
        for (int i = 0; i < Steps; i++)
        {
            double t = 0.2 * (i + 0.5) / Steps;
            q = Quaterniond.FromRotationVector(0.2 / Steps * new Vector3d(20 * Math.Cos(9 * t), 7 + (30 * t * t), 20 * Math.Sin(9 * t))) * q;
        }

        return q;
    });

    [Fact]
    public void Equal_values_have_equal_hash_codes_and_others_differ()
    {
        Assert.Equal(new Vector3d(1, -2, 3).GetHashCode(), s_a.GetHashCode());
        Assert.NotEqual(s_a.GetHashCode(), s_b.GetHashCode());
        var turn = new Quaterniond(0.1, 0.2, 0.3, 0.4);
        Assert.Equal(new Quaterniond(0.1, 0.2, 0.3, 0.4).GetHashCode(), turn.GetHashCode());
        Assert.NotEqual(Quaterniond.Identity.GetHashCode(), turn.GetHashCode());
    }

    [Fact]
    public void Outer_products_are_scaled_subtracted_and_multiplied()
    {
        SymmetricMatrix3d ofA = SymmetricMatrix3d.OuterProduct(in s_a);
        SymmetricMatrix3d ofB = SymmetricMatrix3d.OuterProduct(in s_b);
        Assert.Equal(Vector3d.Dot(s_a, s_b) * s_a, ofA * s_b);
        Assert.Equal((3 * Vector3d.Dot(s_a, s_b) * s_a) - (s_b.LengthSquared * s_b), ((3 * ofA) - ofB) * s_b);
    }
}
