using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Predictors;

/// <summary>The polynomials of a path, their bounds, and the list of them up to a time.</summary>
public sealed class PathSpanTests
{
    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(5)]
    public void A_span_is_the_curve_of_its_segment(int degree)
    {
        var random = new Shots(71);
        for (int i = 0; i < 50; i++)
        {
            PathSegment piece = Random(random, degree);
            var span = PathSpan.Of(in piece, piece.EndTime);
            Assert.Equal((piece.Time, piece.EndTime), (span.Start, span.End));
            for (int k = 0; k <= 8; k++)
            {
                double time = piece.Time + (k * piece.Length / 8);
                Vector3d place = piece.PositionAt(time);
                Assert.InRange(Vector3d.Distance(place, span.PositionAt(time)), 0, 1e-12);

                // The velocity is the derivative of the position: a central difference.
                const double Step = 1e-5;
                Vector3d rate = (piece.PositionAt(time + Step) - piece.PositionAt(time - Step)) / (2 * Step);
                Assert.InRange(Vector3d.Distance(rate, span.VelocityAt(time)), 0, 1e-3);
            }
        }
    }

    /// <summary>Between and after the segments of a path, the ball moves straight, or rests.</summary>
    [Fact]
    public void A_straight_span_goes_from_one_point_to_the_other_at_a_constant_speed()
    {
        var span = PathSpan.Straight(2, 4, new Vector3d(1, 3, -2), new Vector3d(7, 1, 6));
        Assert.Equal((2, 4), (span.Start, span.End));
        Assert.Equal(new Vector3d(2.5, 2.5, 0), span.PositionAt(2.5));
        Assert.Equal(new Vector3d(3, -1, 4), span.VelocityAt(3));
        Assert.Equal(5, span.Speed, 1e-12);
        Assert.Equal((1, 3), (span.Lowest, span.Highest));
        Assert.Equal(0, span.Acceleration);
    }

    /// <summary>The curve stays within the control points of its Bézier form, which follow from the values at both ends.</summary>
    [Theory]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(5)]
    public void The_bounds_are_those_of_the_control_points(int degree)
    {
        var random = new Shots(72);
        for (int i = 0; i < 200; i++)
        {
            PathSegment piece = Random(random, degree);
            var span = PathSpan.Of(in piece, piece.EndTime);
            double h = piece.Length;
            Ends(in piece, out Vector3d v0, out Vector3d a0, out Vector3d v1, out Vector3d a1);
            Vector3d p0 = piece.StartPosition;
            Vector3d p1 = piece.EndPosition;
            Vector3d[] places =
            [
                p0, p0 + (h / 5 * v0), p0 + (2 * h / 5 * v0) + (h * h / 20 * a0),
                p1 - (2 * h / 5 * v1) + (h * h / 20 * a1), p1 - (h / 5 * v1), p1,
            ];
            Vector3d[] velocities = Differences(places, h);
            Vector3d[] accelerations = Differences(velocities, h);
            Assert.Equal(places.Min(p => p.Y), span.Lowest, 1e-9);
            Assert.Equal(places.Max(p => p.Y), span.Highest, 1e-9);
            Assert.Equal(velocities.Max(v => v.Horizontal.Length), span.Speed, 1e-9 * (1 + span.Speed));
            Assert.Equal(accelerations.Max(a => a.Horizontal.Length), span.Acceleration, 1e-8 * (1 + span.Acceleration));
            Assert.Equal(accelerations.Max(a => Math.Abs(a.Y)), span.VerticalAcceleration, 1e-8 * (1 + span.VerticalAcceleration));
        }
    }

    [Fact]
    public void The_bounds_hold_along_the_curve()
    {
        var random = new Shots(73);
        for (int i = 0; i < 200; i++)
        {
            PathSegment piece = Random(random, (i % 3) switch { 0 => 2, 1 => 3, _ => 5 });
            var span = PathSpan.Of(in piece, piece.EndTime);
            for (int k = 0; k <= 50; k++)
            {
                double time = piece.Time + (k * piece.Length / 50);
                Assert.InRange(span.PositionAt(time).Y, span.Lowest - 1e-12, span.Highest + 1e-12);
                Assert.InRange(span.VelocityAt(time).Horizontal.Length, 0, span.Speed + 1e-9);
            }
        }
    }

    /// <summary>A path with bounces, up to any time: no gap, nothing beyond the time, and the largest speed that is still to come.</summary>
    [Fact]
    public void The_spans_cover_a_path_up_to_a_time_and_no_more()
    {
        var simulator = new Simulator(Scene.Measured);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), new Vector3d(2, 5, -9), new Vector3d(0, 20, 0));
        var path = new Trajectory(2048);
        simulator.LookAhead(in ball, new LookAheadRequest { Duration = 3, StopAt = StopAt.Time }, path);
        var spans = new PathSpans();
        double[] times = [0.5 * path.Piece(0).EndTime, 0.77, path.Piece(7).Time, path.Piece(20).Time, path.EndTime, 99];
        foreach (double until in times)
        {
            spans.Take(path, until);
            double end = Math.Min(until, path.EndTime);
            Assert.Equal((0.0, end), (spans.Start, spans.End));
            Assert.Equal(0, spans.Items[0].Start);
            Assert.True(spans.Items[spans.Count - 1].End >= end);
            double speed = 0;
            for (int i = spans.Count - 1; i >= 0; i--)
            {
                PathSpan span = spans.Items[i];
                Assert.True(span.Start < span.End && span.Start < end, $"{span.Start} … {span.End} of {until}");
                Assert.True(i == 0 || spans.Items[i - 1].End == span.Start);
                double middle = 0.5 * (span.Start + span.End);
                Assert.InRange(Vector3d.Distance(path.PositionAt(middle), span.PositionAt(middle)), 0, 1e-9);
                speed = Math.Max(speed, span.Speed);
                Assert.Equal(speed, span.SpeedFromHere);
                Assert.Equal(i, spans.Find(middle));
                Assert.Equal(i, spans.Find(span.Start));
            }
        }
    }

    /// <summary>Velocities and accelerations of the curve at its ends: those of the segment, or those of its polynomial of lower degree.</summary>
    private static void Ends(in PathSegment piece, out Vector3d v0, out Vector3d a0, out Vector3d v1, out Vector3d a1)
    {
        double h = piece.Length;
        Vector3d mean = (piece.EndPosition - piece.StartPosition) / h;
        v0 = piece.StartVelocity;
        v1 = piece.EndVelocity;
        if (piece.Degree == 2)
        {
            a0 = a1 = 2 / h * (mean - v0);
            v1 = v0 + (h * a0);
        }
        else if (piece.Degree == 3)
        {
            a0 = ((6 * mean) - (4 * v0) - (2 * v1)) / h;
            a1 = ((2 * v0) + (4 * v1) - (6 * mean)) / h;
        }
        else
        {
            (a0, a1) = (piece.StartAcceleration, piece.EndAcceleration);
        }
    }

    /// <summary>The control points of the derivative: degree times the differences, per duration.</summary>
    private static Vector3d[] Differences(Vector3d[] points, double h) =>
        [.. Enumerable.Range(0, points.Length - 1).Select(i => (points.Length - 1) / h * (points[i + 1] - points[i]))];

    private static PathSegment Random(Shots random, int degree)
    {
        Vector3d Any(double size) => random.Uniform(0, size) * random.Direction();
        return new PathSegment(
            random.Uniform(0, 3), random.Uniform(0.02, 0.4), Any(3), Any(20), Any(30), Any(3), Any(20), Any(30), MotionState.Airborne, degree);
    }
}
