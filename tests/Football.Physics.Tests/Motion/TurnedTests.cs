namespace FootballPhysics.Tests.Motion;

/// <summary>The rotation of a step on the ground, by series, against sine and cosine.</summary>
public sealed class TurnedTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(1e-9)]
    [InlineData(0.3)]
    [InlineData(0.999)] // the short series ends at 1 rad
    [InlineData(1.001)]
    [InlineData(3.9)]
    [InlineData(3.999)] // the long one at 4
    [InlineData(4.001)]
    [InlineData(50)]
    public void A_rotation_vector_turns_by_its_length_about_its_direction(double angle)
    {
        Vector3d axis = new Vector3d(2, -3, 6) / 7;
        Quaterniond start = new Quaterniond(1, -2, 4, 2).Normalized();
        Quaterniond expected = Quaterniond.FromAxisAngle(in axis, angle) * start;
        Quaterniond actual = start.Turned(angle * axis);
        Assert.Equal(expected.X, actual.X, 4e-16 * (8 + angle));
        Assert.Equal(expected.Y, actual.Y, 4e-16 * (8 + angle));
        Assert.Equal(expected.Z, actual.Z, 4e-16 * (8 + angle));
        Assert.Equal(expected.W, actual.W, 4e-16 * (8 + angle));
        Assert.Equal(1, actual.LengthSquared, 4e-16);
    }

    [Fact]
    public void A_long_roll_leaves_a_unit_quaternion()
    {
        Quaterniond turned = Quaterniond.Identity;
        for (int i = 0; i < 100_000; i++)
        {
            turned = turned.Turned(new Vector3d(0.3, -0.1 * (i % 7), 0.2));
        }

        Assert.Equal(1, turned.LengthSquared, 1e-15);
    }
}
