namespace FootballPhysics.Tests.Things;

/// <summary>Uneven ground through given heights: the nodes, the border, and how far it leaves the heights between them.</summary>
public sealed class HeightFieldTests
{
    [Theory]
    [InlineData(1, 1)]
    [InlineData(1, 2)]
    [InlineData(2, 1)]
    [InlineData(2, 2)]
    [InlineData(3, 7)]
    [InlineData(41, 41)]
    [InlineData(120, 5)]
    public void The_ground_passes_through_every_height(int rows, int columns)
    {
        var random = new Random((100 * rows) + columns);
        foreach ((double x, double z, double spacing, double height) in new[] { (0.0, 0.0, 1.0, 1.0), (-20.3, 7.1, 0.37, 0.2), (1e5, -1e5, 250, 1e5) })
        {
            var heights = new double[rows, columns];
            for (int i = 0; i < heights.Length; i++)
            {
                heights[i / columns, i % columns] = height * ((2 * random.NextDouble()) - 1);
            }

            var ground = new HeightField(x, z, spacing, heights);
            for (int i = 0; i < heights.Length; i++)
            {
                (int row, int column) = (i / columns, i % columns);
                double at = ground.HeightAt(x + (row * spacing), z + (column * spacing));
                Assert.True(Math.Abs(at - heights[row, column]) <= 1e-9 * height, $"{row}, {column}: {at} for {heights[row, column]}");
            }
        }
    }

    /// <summary>The case of the report: one node of 41 × 41 is 1 m high. Control values give 4/9 m there.</summary>
    [Fact]
    public void One_raised_node_is_as_high_as_it_is_given_and_a_control_value_gives_four_ninths()
    {
        double[,] heights = new double[41, 41];
        heights[20, 20] = 1;
        Assert.Equal(1, new HeightField(-20, -20, 1, heights).HeightAt(0, 0), 1e-12);
        Assert.Equal(0, new HeightField(-20, -20, 1, heights).HeightAt(1, 0), 1e-12);
        Assert.Equal(4.0 / 9.0, HeightField.FromControlValues(-20, -20, 1, heights).HeightAt(0, 0), 1e-12);
    }

    [Fact]
    public void A_plane_stays_a_plane_up_to_the_border_and_becomes_level_two_spacings_beyond_it()
    {
        const double Spacing = 2;
        var heights = new double[9, 6];
        for (int i = 0; i < heights.Length; i++)
        {
            heights[i / 6, i % 6] = 1 + (0.1 * Spacing * (i / 6)) - (0.2 * Spacing * (i % 6));
        }

        var ground = new HeightField(-3, 4, Spacing, heights);
        var random = new Random(3);
        for (int i = 0; i < 500; i++)
        {
            double x = 8 * Spacing * random.NextDouble();
            double z = 5 * Spacing * random.NextDouble();
            Assert.Equal(1 + (0.1 * x) - (0.2 * z), ground.HeightAt(x - 3, z + 4), 1e-13);

            // The nearest point of the surface lies a little beside the ball, so keep away from the border.
            if (x > 0.1 && x < 15.9 && z > 0.1 && z < 9.9)
            {
                ShapePoint at = ground.At(new Vector3d(x - 3, ground.HeightAt(x - 3, z + 4) + 0.11, z + 4));
                Assert.True(Vector3d.Distance(at.Normal, new Vector3d(-0.1, 1, 0.2) / Math.Sqrt(1.05)) < 1e-12);
            }
        }

        double beyond = -3 - (2 * Spacing);
        Assert.Equal(ground.HeightAt(beyond, 8), ground.HeightAt(beyond - 100, 8), 1e-13);
        Assert.Equal(Math.Sqrt(0.05), ground.Steepest.Value, 1e-9);
    }

    /// <summary>The natural spline through a parabola's nodes: away from the border it is the parabola, at the border its second derivative is zero.</summary>
    [Fact]
    public void The_second_derivative_is_zero_at_the_border()
    {
        var heights = new double[41, 1];
        for (int i = 0; i < 41; i++)
        {
            heights[i, 0] = 0.01 * i * i;
        }

        var ground = new HeightField(0, 0, 1, heights);
        double Bend(double x)
        {
            const double H = 1e-3;
            return (ground.HeightAt(x - H, 0) - (2 * ground.HeightAt(x, 0)) + ground.HeightAt(x + H, 0)) / (H * H);
        }

        Assert.Equal(0.02, Bend(20), 1e-8);
        Assert.InRange(Math.Abs(Bend(0)), 0, 1e-3);
        Assert.InRange(Math.Abs(Bend(40)), 0, 1e-3);
    }

    /// <summary>The numbers that the documentation states. The bound for any heights is that of cubic spline interpolation, (1 + 3√3)/4 in each direction.</summary>
    [Fact]
    public void The_ground_leaves_the_range_of_the_heights_by_as_much_as_the_documentation_states()
    {
        (double low, double high) = Extremes(Line(i => i == 20 ? 1 : 0));
        Assert.Equal(0.137, -low, 5e-4);
        Assert.Equal(1, high, 1e-12);
        (low, high) = Extremes(Line(i => i >= 20 ? 1 : 0));
        Assert.Equal(0.108, -low, 5e-4);
        Assert.Equal(1.108, high, 5e-4);
        for (int shift = 0; shift < 10; shift++)
        {
            double top = 20 + (0.1 * shift);
            (low, high) = Extremes(Line(i => Math.Abs(i - top) < 4 ? 0.5 * (1 + Math.Cos(Math.PI * (i - top) / 4)) : 0));
            Assert.InRange(Math.Max(-low, high - 1), 0, 0.01);
        }

        // The worst heights alternate, with the same sign at both sides of one cell: in it the spline reaches the bound.
        double bound = (1 + (3 * Math.Sqrt(3))) / 4;
        var worst = new double[40, 40];
        for (int i = 0; i < worst.Length; i++)
        {
            worst[i / 40, i % 40] = Sign(i / 40) * Sign(i % 40);
        }

        Assert.Equal(bound * bound, new HeightField(0, 0, 1, worst).HeightAt(19.5, 19.5), 1e-9);
        var random = new Random(11);
        for (int k = 0; k < 20; k++)
        {
            (low, high) = Extremes(Line(_ => random.Next(2)));
            Assert.InRange(Math.Max(-low, high - 1), 0, (bound - 1) / 2);
        }
    }

    [Fact]
    public void A_slope_that_is_too_steep_between_nodes_is_refused_with_its_position()
    {
        double[,] step = Line(i => i >= 20 ? 0.9 : 0);
        string message = Refused(new HeightField(0, -5, 1, step));
        Assert.Matches(@"^ground\.heights \(its steepest slope, between nodes, at x 19\.5, z [-0-9.]+\) is 1\.06\d+; allowed: 0 … 1\.", message);

        // The slope of a plane is that at its nodes, and a control value has no node.
        Assert.Matches(@"^ground\.heights \(its steepest slope, at x [-0-9.]+, z [-0-9.]+\) is ", Refused(HeightField.FromControlValues(0, -5, 1, Line(i => 1.1 * i))));
        double[,] narrow = Line(i => i == 20 ? 0.1 : 0);
        Assert.Matches(@"^ground\.heights \(its strongest curvature, 1/m, at x 5, z [-0-9.]+\) is ", Refused(new HeightField(0, -5, 0.25, narrow)));
    }

    [Fact]
    public void Wrong_numbers_are_refused_by_name()
    {
        Assert.Equal("heights", Assert.Throws<ArgumentNullException>(() => new HeightField(0, 0, 1, null!)).ParamName);
        Assert.Equal("values", Assert.Throws<ArgumentNullException>(() => HeightField.FromControlValues(0, 0, 1, null!)).ParamName);
        Assert.StartsWith("heights[0][1] is NaN; allowed: ", Assert.Throws<ArgumentOutOfRangeException>(() => new HeightField(0, 0, 1, new[,] { { 0, double.NaN } })).Message, StringComparison.Ordinal);
        Assert.StartsWith("values[1][0] is 2000000; allowed: ", Assert.Throws<ArgumentOutOfRangeException>(() => HeightField.FromControlValues(0, 0, 1, new[,] { { 0.0 }, { 2e6 } })).Message, StringComparison.Ordinal);
        Assert.StartsWith("heights is 0 × 3; allowed: ", Assert.Throws<ArgumentOutOfRangeException>(() => new HeightField(0, 0, 1, new double[0, 3])).Message, StringComparison.Ordinal);
        Assert.StartsWith("spacing is 0; allowed: ", Assert.Throws<ArgumentOutOfRangeException>(() => new HeightField(0, 0, 0, new double[1, 1])).Message, StringComparison.Ordinal);
    }

    /// <summary>A ball on ground through heights rests on it, and the ground moves with <see cref="Ground.Height"/>.</summary>
    [Fact]
    public void A_ball_lies_on_the_heights()
    {
        var heights = new double[3, 3];
        heights[1, 1] = -0.1;
        var ball = new Ball(new Scene { Ground = new Ground { Heights = new HeightField(-5, -5, 5, heights), Height = 7 } });
        ball.Place(new Vector3d(0, 0, 0));
        Assert.Equal(6.9 + ball.Simulator.Scene.Ball.Radius, ball.Position.Y, 1e-12);
        Assert.Equal(MotionState.Rest, ball.Motion);
    }

    private static string Refused(HeightField heights) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(new Scene { Ground = new Ground { Heights = heights } })).Message;

    /// <summary>Heights along x that do not depend on z.</summary>
    private static double[,] Line(Func<int, double> height)
    {
        var heights = new double[41, 1];
        for (int i = 0; i < 41; i++)
        {
            heights[i, 0] = height(i);
        }

        return heights;
    }

    private static (double Low, double High) Extremes(double[,] heights)
    {
        var ground = new HeightField(0, 0, 1, heights);
        double[] all = [.. Enumerable.Range(0, 4001).Select(k => ground.HeightAt(0.01 * k, 0))];
        return (all.Min(), all.Max());
    }

    private static int Sign(int i) => (i <= 19 ? 19 - i : i - 20) % 2 == 0 ? 1 : -1;
}
