using FootballPhysics.Numerics;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Laws;

/// <summary>The knuckle force against values worked out with another calculator, and its properties.</summary>
public sealed class KnuckleForceTests
{
    private static readonly Quaterniond s_turned = new Quaterniond(0.5, -0.4, 0.3, 0.7).Normalized();

    [Fact]
    public void The_counter_generator_gives_its_numbers()
    {
        Assert.Equal(0.5665615751722809, SplitMix64.At(1, 0));
        Assert.Equal(0.7457817572627011, SplitMix64.At(1, 1));
        Assert.Equal(0.9710027535867962, SplitMix64.At(1, 2));
    }

    [Theory]
    [InlineData(1, 0, 0, 0, 1.462051, -0.690292)]
    [InlineData(0, 1, 0, 0.201327, 0, -0.034162)]
    [InlineData(0, 0, 1, -1.018528, 0.370807, 0)]
    [InlineData(0.6, 0.8, 0, 0.434775, -0.326081, -1.157896)]
    public void The_field_of_a_seed_is_known(double x, double y, double z, double gx, double gy, double gz)
    {
        Vector3d g = Field(new SeamField(1), new Vector3d(x, y, z));
        Assert.Equal(gx, g.X, 6e-7);
        Assert.Equal(gy, g.Y, 6e-7);
        Assert.Equal(gz, g.Z, 6e-7);
    }

    [Theory]
    [InlineData(0, 0, 0, 1, 0, 0, 2.347910, -1.007775)]
    [InlineData(0.6, 0, 0, 0.8, 0, 5, 0.696862, 1.336550)]
    [InlineData(0.5, -0.5, 0.5, 0.5, 0.05, 10, 0.103437, -0.078311)]
    public void The_force_of_both_seeds_is_known(double x, double y, double z, double w, double spinParameter, double distance, double up, double side)
    {
        // The check values have q = 0, C_K = 0.058 and C_K c_W = 0.02 exactly.
        BallProperties ball = BallProperties.Modern with { KnuckleForce = 0.058 * KnuckleForce.ReferenceForce };
        var orientation = new Quaterniond(x, y, z, w);
        Vector3d spin = new(0, spinParameter * 30 / ball.Radius, 0);
        Vector3d force = Force(ball, 1, new Vector3d(30, 0, 0), in spin, distance, in orientation);
        double scale = 0.058 * 0.5 * 1.2 * Math.PI * 0.11 * 0.11 * 900 / (1 + (spinParameter * spinParameter / 0.01));
        Vector3d seams = scale * orientation.Rotate(Field(new SeamField(1), new Quaterniond(-x, -y, -z, w).Rotate(new Vector3d(1, 0, 0))));
        Vector3d expected = seams + (0.02 / (0.058 * KnuckleForce.Wake) * (force - seams));
        Assert.Equal(0, expected.X, 1e-14);
        Assert.Equal(up, expected.Y, 6e-7);
        Assert.Equal(side, expected.Z, 6e-7);
    }

    [Fact]
    public void A_launch_without_an_orientation_has_a_random_one_of_the_seed()
    {
        Quaterniond random = new Simulator(Seeded(1)).Launch(new Vector3d(0, 1, 0), new Vector3d(20, 0, 0), Vector3d.Zero).Orientation;
        Assert.Equal(0.825399, random.W, 6e-7);
        Assert.Equal(0.519440, random.X, 6e-7);
        Assert.Equal(-0.098871, random.Y, 6e-7);
        Assert.Equal(0.197799, random.Z, 6e-7);
        Assert.Equal(Quaterniond.Identity, new Simulator().Launch(new Vector3d(0, 1, 0), new Vector3d(20, 0, 0), Vector3d.Zero).Orientation);
        Assert.Equal(random, new Ball(new Simulator(Seeded(1))).Orientation);
    }

    [Fact]
    public void A_kick_keeps_the_orientation_that_the_ball_has()
    {
        var ball = new Ball(new Simulator(Seeded(1)));
        ball.Place(new Vector3d(0, 0, 0), s_turned);
        ball.Kick(new Vector3d(25, 5, 0), Vector3d.Zero);
        Assert.True(Differences.Rotation(s_turned, ball.Orientation) < 1e-15);
        ball.Step(0.5);
        Assert.True(Differences.Rotation(s_turned, ball.Orientation) < 1e-15);
    }

    [Fact]
    public void It_is_perpendicular_to_the_motion_and_turns_with_ball_and_motion()
    {
        var random = new Shots(5);
        for (int i = 0; i < 200; i++)
        {
            Vector3d u = random.Uniform(1, 40) * random.Direction();
            Vector3d spin = random.Uniform(0, 20) * random.Direction();
            var orientation = Quaterniond.FromAxisAngle(random.Direction(), random.Uniform(0, 6));
            Vector3d force = Force(BallProperties.Jabulani, 4, in u, in spin, 3, in orientation);
            Assert.InRange(Math.Abs(Vector3d.Dot(in force, in u)), 0, 1e-14 * u.Length * Math.Max(1, force.Length));

            // The axes of the wake turn with the motion only about the vertical.
            var turn = Quaterniond.FromAxisAngle(Vector3d.Up, random.Uniform(0, 6));
            Vector3d turned = Force(BallProperties.Jabulani, 4, turn.Rotate(in u), turn.Rotate(in spin), 3, turn * orientation);
            Assert.InRange(Vector3d.Distance(turn.Rotate(in force), turned), 0, 1e-13 * Math.Max(1, force.Length));
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(-77)]
    [InlineData(long.MaxValue)]
    public void The_field_is_odd_its_mean_square_is_one_and_over_a_turn_it_vanishes(long seed)
    {
        var field = new SeamField(seed);
        double squares = 0;
        const int Rings = 16;
        const int Points = 32;
        for (int i = 0; i < Rings; i++)
        {
            // Fejér's rule over the height: exact for |G|², which is of degree 8.
            double angle = (i + 0.5) * Math.PI / Rings;
            double weight = 1.0 / Rings * (1 - (2 * Enumerable.Range(1, Rings / 2).Sum(k => Math.Cos(2 * k * angle) / ((4.0 * k * k) - 1))));
            for (int j = 0; j < Points; j++)
            {
                var b = new Vector3d(Math.Sin(angle) * Math.Cos(2 * Math.PI * j / Points), Math.Sin(angle) * Math.Sin(2 * Math.PI * j / Points), Math.Cos(angle));
                squares += weight * Field(field, in b).LengthSquared / Points;
                Assert.InRange((Field(field, in b) + Field(field, -b)).Length, 0, 1e-14);
            }
        }

        // Two components across b: their mean squares add up to 2.
        Assert.Equal(2, squares, 1e-12);

        Vector3d mean = Vector3d.Zero;
        Vector3d u = new Vector3d(1, 2, -0.5) / new Vector3d(1, 2, -0.5).Length;
        Vector3d axis = Vector3d.Cross(in u, Vector3d.Up);
        axis /= axis.Length;
        for (int i = 0; i < Points; i++)
        {
            var orientation = Quaterniond.FromAxisAngle(in axis, 2 * Math.PI * i / Points) * s_turned;
            var back = new Quaterniond(-orientation.X, -orientation.Y, -orientation.Z, orientation.W);
            mean += orientation.Rotate(Field(field, back.Rotate(in u))) / Points;
        }

        Assert.InRange(mean.Length, 0, 1e-14);
    }

    [Fact]
    public void It_fades_below_the_crisis_and_with_spin_across_the_motion()
    {
        var u = new Vector3d(30, 0, 0);
        Vector3d At(Vector3d spin, double viscosity) => Force(BallProperties.Tunnel, 1, in u, in spin, 2, in s_turned, viscosity);
        Vector3d full = At(Vector3d.Zero, 1.5e-6);
        Assert.Equal(KnuckleForce.Subcritical, At(Vector3d.Zero, 1).Length / full.Length, 4e-5);
        Assert.Equal(1.0 - (0.5 * (1.0 - KnuckleForce.Subcritical)), At(Vector3d.Zero, 30 * 0.22 / 186_000).Length / full.Length, 1e-9);
        Assert.Equal(0.5, At(new Vector3d(300, 0, KnuckleForce.SpinScale * 30 / 0.11), 1.5e-6).Length / full.Length, 1e-12);
        Assert.Equal(full, At(new Vector3d(300, 0, 0), 1.5e-6));
        Assert.Equal(0, Force(BallProperties.Tunnel, 1, new Vector3d(0.9e-9, 0, 0), Vector3d.Zero, 2, in s_turned).Length);
    }

    [Fact]
    public void The_seams_act_with_the_square_of_the_speed_and_the_wake_grows_faster_up_to_40_metres_per_second()
    {
        Vector3d At(double speed) => Force(BallProperties.Tunnel, 1, new Vector3d(speed, 0, 0), Vector3d.Zero, 2, in s_turned, 1e-7) / (speed * speed);
        double grown = (Math.Pow(4.0 / 3, 0.9) - Math.Pow(2.0 / 3, 0.9)) / (1 - Math.Pow(2.0 / 3, 0.9));
        Vector3d first = At(30) - At(20);
        Assert.True(first.Length > 1e-4);
        Assert.InRange(Vector3d.Distance(At(40) - At(20), grown * first), 0, 1e-9 * first.Length);
        Assert.InRange(Vector3d.Distance(At(40), At(60)), 0, 1e-15);
    }

    [Theory]
    [InlineData(1e13)]
    [InlineData(1e16)]
    [InlineData(7e18)]
    [InlineData(1e45)]
    public void It_stays_bounded_beyond_distances_that_have_digits(double distance)
    {
        var force = KnuckleForce.Of(Seeded(5))!;
        Assert.InRange(force.Acceleration(new Vector3d(30, 0, 0), Vector3d.Zero, distance, in s_turned).Length, 0, 30 * 30 * force.Bound.At(1, 0));
    }

    [Fact]
    public void Straight_up_it_is_finite_and_across()
    {
        Vector3d force = Force(BallProperties.Tunnel, 3, new Vector3d(0, 25, 0), Vector3d.Zero, 4, in s_turned);
        Assert.True(force.Length > 0.01);
        Assert.Equal(0, force.Y, 1e-15);
    }

    /// <summary>The bound on |F|/(m |u|²) holds in every orientation and at every distance; the axes of a seed never all push at once.</summary>
    [Fact]
    public void No_force_exceeds_its_bound()
    {
        var random = new Shots(6);
        var force = KnuckleForce.Of(Seeded(5))!;
        double greatest = 0;
        for (int i = 0; i < 100_000; i++)
        {
            double speed = 10 + (i % 50);
            var orientation = Quaterniond.FromAxisAngle(random.Direction(), random.Uniform(0, 6));
            greatest = Math.Max(greatest, force.Acceleration(new Vector3d(speed, 0, 0), Vector3d.Zero, 1.7 * i, in orientation).Length / (speed * speed));
        }

        Assert.InRange(greatest / force.Bound.At(1, 0), 0.4, 1);
    }

    /// <summary>RK4 keeps its order, because the orientation is known within a step.</summary>
    [Theory]
    [InlineData(0, 1e-7)]
    [InlineData(60, 1e-4)]
    public void Half_the_step_does_not_move_the_end_of_a_flight(double spin, double most)
    {
        var random = new Shots(7);
        for (int i = 0; i < 20; i++)
        {
            Vector3d axis = random.Direction();
            Vector3d velocity = random.Velocity(22, 32, 8, 25);
            Vector3d At(double step) =>
                Flight.Play(Seeded(i), Flight.With(Integrator.Rk4), step, 0.8, StopAt.Time, new Vector3d(0, 30, 0), velocity, spin * axis, out _).Position;
            Assert.InRange(Vector3d.Distance(At(0.01), At(0.005)), 0, most);
        }
    }

    /// <summary>A custom force makes the general step, which integrates the full spin: it is the same flight.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(7)]
    public void The_general_step_turns_the_field_as_the_step_of_a_constant_axis_does(double spin)
    {
        var random = new Shots(8);
        for (int i = 0; i < 10; i++)
        {
            Scene scene = Seeded(i);
            Scene general = scene with { Forces = scene.Forces with { CustomForces = [IForce.From(_ => Vector3d.Zero)] } };
            Vector3d turning = spin * random.Direction();
            Vector3d velocity = random.Velocity(22, 32, 8, 25);
            Vector3d At(Scene of) => Flight.Play(of, Flight.With(Integrator.Rk4), 0.0025, 0.8, StopAt.Time, new Vector3d(0, 30, 0), velocity, turning, out _).Position;
            Assert.InRange(Vector3d.Distance(At(scene), At(general)), 0, 2e-9);
        }
    }

    /// <summary>The turn within a step, by series and by sine, is that of a new orientation.</summary>
    [Theory]
    [InlineData(0.02)]
    [InlineData(-0.3)]
    [InlineData(0.31)]
    [InlineData(0.32)]
    [InlineData(0.63)]
    [InlineData(0.64)]
    [InlineData(5)]
    public void A_turn_within_a_step_is_that_of_the_orientation(double angle)
    {
        Vector3d axis = new Vector3d(1, -2, 3) / Math.Sqrt(14);
        var u = new Vector3d(21, 3, -8);
        var force = KnuckleForce.Of(Seeded(3))!;
        BallState start = new Simulator(Seeded(3)).Launch(new Vector3d(0, 1, 0), u, axis, s_turned);
        force.Begin(in start, out SeamAxes seams);
        KnuckleForce.Turn(in seams, in axis, angle, out SeamAxes turned);
        double squared = u.LengthSquared;
        Vector3d within = force.Acceleration(in turned, u.X, u.Y, u.Z, 1 / squared, u.Length, force.ShareAt(squared), 0, 4);
        Vector3d after = force.Acceleration(in u, Vector3d.Zero, 4, (Quaterniond.FromAxisAngle(in axis, angle) * s_turned).Normalized());
        Assert.InRange(Vector3d.Distance(within, after), 0, 3e-14 * after.Length);

        // With the orientation at the end of twice the angle, by the same sine.
        KnuckleForce.Turn(in seams, in start, angle, out SeamAxes middle, out Quaterniond end);
        Assert.Equal(within, force.Acceleration(in middle, u.X, u.Y, u.Z, 1 / squared, u.Length, force.ShareAt(squared), 0, 4));
        Quaterniond expected = (Quaterniond.FromAxisAngle(start.SpinAxis, 2 * angle) * start.Orientation).Normalized();
        Assert.InRange(Math.Abs(end.X - expected.X) + Math.Abs(end.Y - expected.Y) + Math.Abs(end.Z - expected.Z) + Math.Abs(end.W - expected.W), 0, 1e-14);
    }

    private static Scene Seeded(long seed) => Scene.Measured with { Forces = ForceSet.Measured with { KnuckleSeed = seed } };

    /// <summary>The part of the field across b.</summary>
    private static Vector3d Field(SeamField field, in Vector3d b)
    {
        // For a speed of 2, the sum is twice as large.
        field.Turn(Quaterniond.Identity, out SeamAxes axes);
        Vector3d sum = 0.5 * field.At(in axes, 2 * b.X, 2 * b.Y, 2 * b.Z, 0.25, out double along);
        return sum - (0.25 * along * b);
    }

    private static Vector3d Force(
        BallProperties ball, long seed, in Vector3d u, in Vector3d spin, double distance, in Quaterniond orientation, double viscosity = 1.5e-5)
    {
        Scene scene = Scene.Measured with { Ball = ball, Forces = ForceSet.Measured with { KnuckleSeed = seed }, Air = new Air { Density = 1.2, KinematicViscosity = viscosity } };
        return ball.Mass * KnuckleForce.Of(scene)!.Acceleration(in u, in spin, distance, in orientation);
    }
}
