using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Predictors;

/// <summary>Apex, every crossing, distance to a segment and samples of a path, against a dense look at it.</summary>
public sealed class TrajectoryQueryTests
{
    private const double Dense = 1e-3;

    private static readonly Simulator s_simulator = new();

    [Fact]
    public void The_apex_is_where_nothing_is_higher()
    {
        Trajectory path = Path(new Vector3d(3, 9, -14), new Vector3d(0, 20, 0));
        PathPoint apex = path.ApexPoint();
        Assert.Equal(path.Apex, apex.Position.Y, 1e-12);
        Assert.Equal(0, apex.Velocity.Y, 1e-6);
        Assert.Equal(apex.Position, path.PositionAt(apex.Time));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(9)]
    public void A_plane_at_the_height_of_the_contact_is_met_where_the_ball_touches_down(double forward)
    {
        BallState from = s_simulator.Launch(new Vector3d(0, 1.5, 0), new Vector3d(forward, 2, 0), Vector3d.Zero);
        var path = new Trajectory();
        s_simulator.LookAhead(in from, new LookAheadRequest { StopAt = StopAt.Impact }, path);
        Assert.True(path.TryGetTouchdown(0, out BallEvent touchdown));
        Assert.True(path.TryGetCrossing(new Plane3d(touchdown.Position, Vector3d.Up), out PathPoint crossing));
        Assert.Equal(touchdown.Time, crossing.Time, 1e-9);
    }

    [Fact]
    public void Every_ball_that_touches_down_crosses_the_height_of_the_contact()
    {
        var random = new Shots(43);
        for (int i = 0; i < 60; i++)
        {
            Trajectory path = Path(random.Velocity(5, 25, 20, 80), random.Uniform(0, 30) * random.Direction());
            Assert.True(path.TryGetTouchdown(0, out BallEvent touchdown));
            Assert.True(path.TryGetCrossing(new Plane3d(touchdown.Position, Vector3d.Up), out PathPoint crossing));
            Assert.Equal(touchdown.Time, crossing.Time, 1e-9);
        }
    }

    [Fact]
    public void A_plane_below_the_apex_is_crossed_first_on_the_way_up()
    {
        var random = new Shots(41);
        for (int i = 0; i < 200; i++)
        {
            Trajectory path = Path(random.Velocity(5, 25, 20, 80), random.Uniform(0, 30) * random.Direction());
            double height = i % 3 == 0 ? path.Apex - random.Uniform(1e-6, 1e-3) : random.Uniform(0.2, path.Apex);
            Assert.True(path.TryGetCrossing(new Plane3d(new Vector3d(0, height, 0), Vector3d.Up), out PathPoint crossing));
            Assert.Equal(height, crossing.Position.Y, 1e-9);
            Assert.True(crossing.Velocity.Y > 0);
        }
    }

    [Fact]
    public void No_point_of_the_path_is_nearer_to_a_segment()
    {
        var random = new Shots(42);
        for (int i = 0; i < 20; i++)
        {
            Trajectory path = Path(random.Velocity(8, 25, 5, 40), random.Uniform(0, 30) * random.Direction());
            Vector3d from = path.PositionAt(random.Uniform(0, path.EndTime)) + random.Direction();
            Vector3d to = from + (random.Uniform(0, 3) * random.Direction());
            PathPoint closest = path.ClosestApproach(from, to);
            double best = double.PositiveInfinity;
            for (double time = 0; time <= path.EndTime; time += Dense)
            {
                Vector3d place = path.PositionAt(time);
                for (double share = 0; share <= 1; share += 0.01)
                {
                    best = Math.Min(best, Vector3d.Distance(place, Vector3d.Lerp(from, to, share)));
                }
            }

            Assert.InRange(closest.Distance, best - 0.03, best + 1e-9);
        }
    }

    [Fact]
    public void Samples_are_places_of_the_path_and_end_with_its_end()
    {
        Trajectory path = Path(new Vector3d(3, 9, -14), default);
        var places = new Vector3d[1000];
        int count = path.Sample(places, 0.05);
        Assert.Equal((int)Math.Ceiling(path.EndTime / 0.05) + 1, count);
        for (int i = 0; i < count - 1; i++)
        {
            Assert.Equal(path.PositionAt(i * 0.05), places[i]);
        }

        Assert.Equal(path.Final.Position, places[count - 1]);
        Assert.Equal(3, path.Sample(new Vector3d[3], 0.05));
    }

    private static Trajectory Path(Vector3d velocity, Vector3d spin)
    {
        var path = new Trajectory(4096);
        BallState ball = s_simulator.Launch(new Vector3d(0, 0.11, 0), velocity, spin);
        s_simulator.LookAhead(in ball, new LookAheadRequest { Duration = 60 }, path);
        return path;
    }
}
