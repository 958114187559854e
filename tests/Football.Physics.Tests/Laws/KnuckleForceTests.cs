using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Laws;

/// <summary>The knuckle force against values worked out with another calculator.</summary>
public sealed class KnuckleForceTests
{
    [Fact]
    public void The_counter_generator_gives_its_numbers()
    {
        Assert.Equal(0.5665615751722809, SplitMix64.At(1, 0));
        Assert.Equal(0.7457817572627011, SplitMix64.At(1, 1));
        Assert.Equal(0.9710027535867962, SplitMix64.At(1, 2));
    }

    [Theory]
    [InlineData(0, 2.218624, -0.679331)]
    [InlineData(5, -2.117317, -0.381405)]
    [InlineData(10, 0.621017, 0.518118)]
    public void It_is_a_function_of_seed_and_distance(double distance, double up, double side)
    {
        Vector3d force = Force(BallProperties.Tunnel, 1, new Vector3d(30, 0, 0), Vector3d.Zero, distance);
        Assert.Equal(0, force.X, 1e-15);
        Assert.Equal(up, force.Y, 6e-7);
        Assert.Equal(side, force.Z, 6e-7);
    }

    [Fact]
    public void Its_size_over_a_long_way_is_that_of_the_ball()
    {
        double squares = 0;
        for (int i = 0; i < 20_000; i++)
        {
            squares += Force(BallProperties.Jabulani, 99, new Vector3d(0, 0, -30), Vector3d.Zero, 0.7 * i).X is var x ? x * x : 0;
        }

        Assert.Equal(2.1, Math.Sqrt(squares / 20_000), 0.05);
    }

    [Fact]
    public void It_grows_by_speed_and_fades_by_spin_across_the_motion()
    {
        double At(double speed, double spin) => Force(BallProperties.Tunnel, 1, new Vector3d(speed, 0, 0), new Vector3d(300, spin, 0), 2).Length;
        double full = At(30, 0);
        Assert.Equal(Math.Pow(2.0 / 3, 2.9), At(20, 0) / full, 1e-9);
        Assert.Equal(At(40, 0), At(60, 0), 1e-9);
        Assert.Equal(0, At(2.9, 0));
        Assert.Equal(full, At(30, 0.02 * 30 / 0.11 * 0.999));
        Assert.Equal(0.5, At(30, 0.04 * 30 / 0.11) / full, 1e-9);
        Assert.Equal(0, At(30, 0.06 * 30 / 0.11 * 1.001));
    }

    [Theory]
    [InlineData(1e13)]
    [InlineData(1e16)]
    [InlineData(7e18)]
    [InlineData(1e45)]
    public void It_stays_bounded_beyond_distances_that_have_digits(double distance)
    {
        var force = KnuckleForce.Of(Scene.Measured with { Ball = BallProperties.Tunnel, Forces = ForceSet.Measured with { KnuckleSeed = 5 } })!;
        Assert.InRange(force.Acceleration(new Vector3d(30, 0, 0), Vector3d.Zero, distance).Length, 0, 30 * 30 * force.Bound.At(1, 0));
    }

    [Fact]
    public void Straight_up_it_is_finite_and_across()
    {
        Vector3d force = Force(BallProperties.Tunnel, 3, new Vector3d(0, 25, 0), Vector3d.Zero, 4);
        Assert.True(force.Length > 0.01);
        Assert.Equal(0, force.Y, 1e-15);
    }

    /// <summary>The bound on |F|/(m |u|²) holds at every distance, and the four waves come near it.</summary>
    [Fact]
    public void No_force_exceeds_its_bound_and_some_come_near_it()
    {
        var force = KnuckleForce.Of(Scene.Measured with { Ball = BallProperties.Tunnel, Forces = ForceSet.Measured with { KnuckleSeed = 5 } })!;
        double greatest = 0;
        for (int i = 0; i < 100_000; i++)
        {
            double speed = 10 + (i % 50);
            greatest = Math.Max(greatest, force.Acceleration(new Vector3d(speed, 0, 0), Vector3d.Zero, 1.7 * i).Length / (speed * speed));
        }

        Assert.InRange(greatest / force.Bound.At(1, 0), 0.6, 1);
    }

    private static Vector3d Force(BallProperties ball, long seed, Vector3d u, Vector3d spin, double distance)
    {
        Scene scene = Scene.Measured with { Ball = ball, Forces = ForceSet.Measured with { KnuckleSeed = seed } };
        return ball.Mass * KnuckleForce.Of(scene)!.Acceleration(in u, in spin, distance);
    }
}
