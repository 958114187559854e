namespace FootballPhysics.Tests.Predictors;

/// <summary>The path of one segment, whose motion is a polynomial: positions, extremes, crossings and distances in closed form.</summary>
public sealed class PathSegmentTests
{
    private const double Start = 2;
    private const double Length = 0.8;

    [Theory]
    [InlineData(2, 2)]
    [InlineData(3, 3)]
    [InlineData(2, 5)]
    [InlineData(5, 5)]
    public void A_polynomial_of_its_degree_is_its_path(int polynomial, int degree)
    {
        Vector3d[] of = Drawn(new Random(polynomial + degree), polynomial);
        PathSegment segment = Of(of, degree);
        foreach (double t in (double[])[-0.1, 0, 0.1, 0.37, 0.8, 0.9])
        {
            Near(At(of, t, 0), segment.PositionAt(Start + t));
            Near(At(of, t, 1), segment.VelocityAt(Start + t));
        }

        PathSegment seen = segment.SeenFrom(new Vector3d(3, -1, 2));
        Near(At(of, 0.3, 0) - (2.3 * new Vector3d(3, -1, 2)), seen.PositionAt(Start + 0.3));
        Near(At(of, 0.3, 1) - new Vector3d(3, -1, 2), seen.VelocityAt(Start + 0.3));
        Assert.Equal(segment.EndTime, seen.EndTime);
    }

    [Theory]
    [InlineData(4.0, 0.4)]
    [InlineData(-1.0, 0)]
    [InlineData(0.0, 0)]
    [InlineData(8.0, 0.8)]
    [InlineData(20.0, 0.8)]
    public void The_highest_point_is_where_the_climb_ends(double climb, double highest)
    {
        foreach (int degree in (int[])[2, 3, 5])
        {
            PathSegment segment = Of([new(1, 2, 3), new(5, climb, 0), new(0, -5, 0)], degree);
            Assert.Equal(Start + highest, segment.ApexTime, 1e-9);
            Assert.Equal(2 + (climb * highest) - (5 * highest * highest), segment.Apex, 1e-12);
        }
    }

    /// <summary>y = 2 + 4 t − 5 t²: planes below, at and above its ends and its apex, with both directions of the normal.</summary>
    [Theory]
    [InlineData(1.0, 0, false)]
    [InlineData(2.5, 0.1551, true)]
    [InlineData(2.9, 0, false)]
    public void A_plane_is_crossed_at_the_roots(double height, double first, bool returns)
    {
        double root = Math.Sqrt(Math.Max(0, 16 + (20 * (2 - height)))) / 10;
        foreach (int degree in (int[])[2, 3, 5])
        {
            foreach (double side in (double[])[1, -2])
            {
                PathSegment segment = Of([new(0, 2, 0), new(5, 4, 1), new(0, -5, 0)], degree);
                Vector3d point = new(7, height, -3);
                Vector3d normal = new(0, side, 0);
                bool crosses = segment.Crosses(in point, in normal, out double time);
                Assert.Equal(returns, crosses);
                if (crosses)
                {
                    Assert.Equal(first, 0.4 - root, 1e-4);
                    Assert.Equal(Start + 0.4 - root, time, 1e-12);
                }
            }
        }
    }

    /// <summary>The end of a longer segment lies beyond the plane: one crossing. A start on the plane is not a crossing; an end on it is.</summary>
    [Fact]
    public void A_plane_between_the_ends_is_crossed_once()
    {
        foreach (double side in (double[])[1, -1])
        {
            Vector3d normal = new(0, side, 0);
            PathSegment fall = Of([new(0, 2, 0), new(5, 0, 0), new(0, -2, 0)], 5);
            Assert.True(fall.Crosses(new Vector3d(0, 1.5, 0), in normal, out double time));
            Assert.Equal(Start + 0.5, time, 1e-12);
            Assert.False(fall.Crosses(new Vector3d(0, 2, 0), in normal, out _));
            Assert.False(fall.Crosses(new Vector3d(0, 2.1, 0), in normal, out _));
            Assert.True(fall.Crosses(fall.EndPosition, in normal, out time));
            Assert.Equal(fall.EndTime, time, 1e-12);
        }
    }

    [Fact]
    public void The_closest_approach_is_the_least_distance_of_many_points()
    {
        var random = new Random(3);
        int inside = 0;
        for (int i = 0; i < 300; i++)
        {
            PathSegment segment = Of(Drawn(random, 2), i % 2 == 0 ? 2 : 5);
            Vector3d point = Vector(random, 4);
            double squared = segment.ClosestApproach(in point, out double time);
            Assert.Equal((segment.PositionAt(time) - point).LengthSquared, squared, 1e-12);
            Assert.InRange(time, Start, segment.EndTime);
            inside += time > Start && time < segment.EndTime ? 1 : 0;

            // The search finds one minimum only, so the path turns little.
            double least = Enumerable.Range(0, 2001).Min(at => (segment.PositionAt(Start + (at * Length / 2000)) - point).LengthSquared);
            Assert.InRange(squared, 0, least + 1e-9);
        }

        Assert.InRange(inside, 50, 250);
    }

    /// <summary>The path of a step of Euler's method is straight, and its velocity at the end is another one: distances and heights are those of the path.</summary>
    [Fact]
    public void Extremes_are_those_of_the_path_and_not_of_the_velocities_of_the_method()
    {
        var step = new PathSegment(0, 1, Vector3d.Zero, new(1, 0, 0), default, new(1, 0, 0), new(1, 5, 0), default, MotionState.Airborne, 2);
        Assert.Equal(1, step.ClosestApproach(new Vector3d(0.25, 1, 0), out double time), 1e-12);
        Assert.Equal(0.25, time, 1e-12);

        var climb = new PathSegment(3, 1, Vector3d.Zero, new(0, 1, 0), default, new(0, 1, 0), new(0, -1, 0), default, MotionState.Airborne, 2);
        Assert.Equal((1, 4), (climb.Apex, climb.ApexTime));
    }

    /// <summary>A fall without air overwrites all of a segment that was used before.</summary>
    [Fact]
    public void A_fall_is_a_parabola_in_a_used_buffer()
    {
        var simulator = new Simulator(Scene.Vacuum);
        BallState from = simulator.Launch(new Vector3d(1, 2, 3), new Vector3d(4, 5, -6), Vector3d.Zero);
        PathSegment used = Of([new(9, 9, 9), new(8, 8, 8), new(7, 7, 7)], 5);
        PathSegment.WriteFall(ref used, in from, 0.3, 0.3, 5 - (9.81 * 0.3), 2 + (5 * 0.3) - (4.905 * 0.09), -9.81, 5);
        foreach (double t in (double[])[0, 0.1, 0.3])
        {
            Near(new Vector3d(1 + (4 * t), 2 + (5 * t) - (4.905 * t * t), 3 - (6 * t)), used.PositionAt(t));
            Near(new Vector3d(4, 5 - (9.81 * t), -6), used.VelocityAt(t));
        }

        Assert.Equal((MotionState.Airborne, 0, 0.3, 5), (used.Motion, used.Time, used.EndTime, used.Degree));
    }

    /// <summary>An arch above a point: both ends are nearest, and the earlier one is the answer.</summary>
    [Fact]
    public void Of_two_nearest_points_the_earlier_one_is_reported()
    {
        Vector3d fall = new(0, -8, 0);
        var arch = new PathSegment(3, 1, new(-1, 0, 0), new(2, 4, 0), in fall, new(1, 0, 0), new(2, -4, 0), in fall, MotionState.Airborne, 5);
        Assert.Equal(101, arch.ClosestApproach(new Vector3d(0, -10, 0), out double time));
        Assert.Equal(3, time);
    }

    /// <summary>The velocity of a quadratic is linear in time, so at the middle of a segment it is the mean of both ends. That of a quintic is not.</summary>
    [Theory]
    [InlineData(Integrator.Euler, true)]
    [InlineData(Integrator.SemiImplicitEuler, true)]
    [InlineData(Integrator.Rk2, true)]
    [InlineData(Integrator.Rk4, false)]
    public void A_flight_is_a_quadratic_with_methods_of_low_order_and_a_quintic_with_others(Integrator integrator, bool isQuadratic)
    {
        var simulator = new Simulator(Scene.Published, new SolverSettings { Integrator = integrator });
        BallState from = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(30, 5, 0), new Vector3d(0, 0, 20));
        var path = new Trajectory();
        simulator.LookAhead(in from, new LookAheadRequest { StopAt = StopAt.Impact, TimeStep = 0.02 }, path);
        Assert.InRange(path.Pieces.Length, 10, 500);
        foreach (PathSegment piece in path.Pieces[..10])
        {
            Vector3d mean = 0.5 * (piece.VelocityAt(piece.Time) + piece.VelocityAt(piece.EndTime));
            Assert.Equal(isQuadratic, (piece.VelocityAt(piece.Time + (0.5 * piece.Length)) - mean).Length < 1e-12);
        }
    }

    [Fact]
    public void A_segment_without_length_stays_at_its_start()
    {
        var segment = new PathSegment(1, 0, new(1, 2, 3), new(4, 5, 6), default, new(1, 2, 3), new(4, 5, 6), default, MotionState.Airborne, 2);
        Assert.Equal(new Vector3d(1, 2, 3), segment.PositionAt(1.5));
        Assert.Equal(new Vector3d(4, 5, 6), segment.VelocityAt(1.5));
        Assert.Equal(9, segment.ClosestApproach(new Vector3d(1, 2, 0), out double time));
        Assert.Equal(1, time);
        Assert.Equal(2, segment.Apex);
    }

    /// <summary>Coefficients of a path that turns little within the segment.</summary>
    private static Vector3d[] Drawn(Random random, int degree) =>
        [Vector(random, 1), (degree == 2 ? 10 : 3) * Vector(random, 1).Normalized(), .. Enumerable.Range(2, degree - 1).Select(_ => Vector(random, 1))];

    private static Vector3d Vector(Random random, double size) =>
        new(size * ((2 * random.NextDouble()) - 1), size * ((2 * random.NextDouble()) - 1), size * ((2 * random.NextDouble()) - 1));

    private static PathSegment Of(Vector3d[] of, int degree) =>
        new(Start, Length, At(of, 0, 0), At(of, 0, 1), At(of, 0, 2), At(of, Length, 0), At(of, Length, 1), At(of, Length, 2), MotionState.Airborne, degree);

    /// <summary>A derivative of Σ cₙ tⁿ.</summary>
    private static Vector3d At(Vector3d[] of, double t, int derivative)
    {
        Vector3d sum = Vector3d.Zero;
        for (int n = derivative; n < of.Length; n++)
        {
            sum += Enumerable.Range(n - derivative + 1, derivative).Aggregate(1.0, (product, factor) => product * factor) * Math.Pow(t, n - derivative) * of[n];
        }

        return sum;
    }

    private static void Near(Vector3d expected, Vector3d actual) => Assert.InRange((expected - actual).Length, 0, 1e-11);
}
