using FootballPhysics.Yardsticks;

namespace FootballPhysics.Tests.Queries;

/// <summary>The live filter, on balls simulated with noise.</summary>
public sealed class BallFilterTests
{
    private const double Noise = 0.01;
    private const double Interval = 0.02;

    private static readonly Vector3d s_spin = new(10, 20, -15);

    /// <summary>A kick at 0.5 s from rest, and another one in the air at 1.6 s.</summary>
    private static (double Time, Vector3d Seen, BallState Truth)[] Track(double end = 3, double start = 0)
    {
        var random = new SeededRandom(7);
        var simulator = new Simulator(Scene.Default, new SolverSettings { Integrator = Integrator.Rk4 });
        BallState ball = simulator.Launch(new Vector3d(1, simulator.ContactHeight, 2), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        var points = new List<(double, Vector3d, BallState)>();
        for (int i = 0; i * Interval <= end; i++)
        {
            if (i is 25 or 80)
            {
                simulator.Kick(ref ball, i == 25 ? new Vector3d(18, 9, 3) : new Vector3d(-12, 5, 4), s_spin);
            }

            points.Add((start + (i * Interval), ball.Position + (Noise * new Vector3d(Normal(random), Normal(random), Normal(random))), ball));
            simulator.Run(ref ball, Interval, Interval, StopAt.Time, log);
        }

        return [.. points];
    }

    private static BallFilter Filter() => new(settings: new BallFilterSettings { Noise = Noise });

    [Theory]
    [InlineData(0)]
    [InlineData(1.7e9)]
    [InlineData(-3e5)]
    public void Finds_kicks_velocity_and_spin(double start)
    {
        BallFilter filter = Filter();
        List<double> kicks = [];
        foreach ((double time, Vector3d seen, BallState truth) in Track(start: start))
        {
            filter.Update(time, seen);
            if (filter.Estimate.HasKick && (kicks.Count == 0 || filter.Estimate.KickTime - kicks[^1] > 0.1))
            {
                kicks.Add(filter.Estimate.KickTime);
            }

            double since = time - start > 1.59 ? time - start - 1.6 : time - start - 0.5;
            if (since > 10 * Interval)
            {
                Assert.InRange((filter.Estimate.State.Velocity - truth.Velocity).Length, 0, 5 * Math.Sqrt(3) * filter.Estimate.VelocityDeviation);
                Assert.InRange((filter.Estimate.State.Position - truth.Position).Length, 0, 5 * Math.Sqrt(3) * filter.Estimate.PositionDeviation);
                Assert.InRange((filter.Estimate.State.Spin - truth.Spin).Length, 0, 5 * Math.Sqrt(3) * filter.Estimate.SpinDeviation);
            }
        }

        Assert.Equal(2, kicks.Count);
        Assert.Equal(start + 0.5, kicks[0], 0.021);
        Assert.Equal(start + 1.6, kicks[1], 0.021);
    }

    [Fact]
    public void Looks_ahead_with_a_deviation()
    {
        BallFilter filter = Filter();
        (double Time, Vector3d Seen, BallState Truth)[] track = Track(2.5);
        foreach ((double time, Vector3d seen, _) in track[..^25])
        {
            filter.Update(time, seen);
        }

        var path = new Trajectory();
        filter.LookAhead(0.5, path);
        (double end, _, BallState last) = track[^1];
        Assert.Equal(end, path.EndTime, 1e-9);
        double told = filter.DeviationAt(end);
        Assert.InRange(told, filter.Estimate.PositionDeviation, 1);
        Assert.InRange((path.PositionAt(end) - last.Position).Length, 0, 4 * Math.Sqrt(3) * told);
        Assert.InRange(filter.DeviationAt(path.StartTime), 0.5 * filter.Estimate.PositionDeviation, 2 * filter.Estimate.PositionDeviation);
    }

    [Fact]
    public void Wrong_repeated_and_missing_points_are_no_kicks()
    {
        BallFilter filter = Filter();
        foreach ((double time, Vector3d seen, BallState truth) in Track(1.5))
        {
            bool isWrong = Math.Abs(time - 1.0) < 1e-9;
            if (time is > 1.1 and < 1.3)
            {
                continue;
            }

            Vector3d point = isWrong ? seen + new Vector3d(0, 3, 1) : seen;
            filter.Update(time, point);
            byte[] before = filter.Save();
            filter.Update(time, point);
            Assert.Equal(before, filter.Save());
            Assert.Equal(isWrong, time > 0.6 && filter.Estimate.IsOutlier);
            Assert.False(filter.Estimate.HasKick && time > 1.05);
            if (time > 0.8 && !isWrong)
            {
                Assert.InRange((filter.Estimate.State.Position - truth.Position).Length, 0, 0.05);
            }
        }
    }

    [Fact]
    public void A_late_point_counts_and_an_early_one_is_rejected()
    {
        (double Time, Vector3d Seen, BallState Truth)[] track = Track(1.4);
        BallFilter late = Filter();
        BallFilter never = Filter();
        for (int i = 0; i < track.Length; i++)
        {
            if (i != 50)
            {
                late.Update(track[i].Time, track[i].Seen);
                never.Update(track[i].Time, track[i].Seen);
            }
        }

        late.Update(track[50].Time, track[50].Seen);
        Assert.Equal(track[^1].Time, late.Estimate.State.Time, 1e-12);
        Assert.True(late.Estimate.PositionDeviation < never.Estimate.PositionDeviation);
        byte[] before = late.Save();
        ArgumentOutOfRangeException refused = Assert.Throws<ArgumentOutOfRangeException>(() => late.Update(-5, Vector3d.Zero));
        Assert.Contains("time", refused.Message, StringComparison.Ordinal);
        Assert.Equal(before, late.Save());
    }

    [Fact]
    public void A_restored_filter_gives_the_same_bits()
    {
        (double Time, Vector3d Seen, BallState Truth)[] track = Track(4.5);
        foreach (int at in (int[])[1, 20, 28, 82, 200])
        {
            BallFilter filter = Filter();
            BallFilter other = Filter();
            for (int i = 0; i < track.Length; i++)
            {
                filter.Update(track[i].Time, track[i].Seen);
                if (i == at)
                {
                    other.Restore(filter.Save());
                }
                else if (i > at)
                {
                    other.Update(track[i].Time, track[i].Seen);
                    Assert.True(Snapshot.Same(filter.Estimate.State, other.Estimate.State));
                }
            }

            Assert.Equal(filter.Save(), other.Save());
        }
    }

    [Fact]
    public void Damaged_bytes_are_rejected()
    {
        BallFilter filter = Filter();
        foreach ((double time, Vector3d seen, _) in Track(0.8))
        {
            filter.Update(time, seen);
        }

        byte[] saved = filter.Save();
        var random = new SeededRandom(3);
        for (int i = 0; i < 300; i++)
        {
            byte[] damaged = [.. saved];
            damaged[random.Below(damaged.Length)] ^= (byte)(1 + random.Below(255));
            Assert.Throws<ArgumentException>(() => filter.Restore(damaged));
            Assert.Throws<ArgumentException>(() => filter.Restore(saved.AsSpan(0, random.Below(saved.Length))));
        }

        Assert.Throws<ArgumentException>(() => new BallFilter(settings: new BallFilterSettings { Noise = 0.02 }).Restore(saved));
        Assert.Throws<ArgumentException>(() => new BallFilter(Scene.Published, new BallFilterSettings { Noise = Noise }).Restore(saved));
        Assert.Equal(saved, filter.Save());
    }

    [Fact]
    public void Points_do_not_allocate()
    {
        (double Time, Vector3d Seen, BallState Truth)[] track = Track();
        var path = new Trajectory();
        BallFilter filter = Filter();
        long allocated = 0;
        for (int round = 0; round < 2; round++)
        {
            filter.Reset();
            long before = GC.GetAllocatedBytesForCurrentThread();
            foreach ((double time, Vector3d seen, _) in track)
            {
                filter.Update(time, seen);
                filter.LookAhead(0.5, path);
            }

            allocated = GC.GetAllocatedBytesForCurrentThread() - before;
        }

        Assert.Equal(0, allocated);
    }

    [Theory]
    [InlineData(double.NaN, 0, 0.01, "time")]
    [InlineData(double.PositiveInfinity, 0, 0.01, "time")]
    [InlineData(1, double.NaN, 0.01, "position")]
    [InlineData(1, 0, 0.0, "deviation")]
    [InlineData(1, 0, -1.0, "deviation")]
    [InlineData(1, 0, double.NaN, "deviation")]
    public void Bad_input_is_named_and_changes_nothing(double time, double x, double deviation, string field)
    {
        BallFilter filter = Filter();
        filter.Update(0.9, new Vector3d(0, 1, 0));
        byte[] before = filter.Save();
        ArgumentOutOfRangeException refused = Assert.Throws<ArgumentOutOfRangeException>(() => filter.Update(time, new Vector3d(x, 1, 0), deviation));
        Assert.Contains(field, refused.Message, StringComparison.Ordinal);
        Assert.Equal(before, filter.Save());
    }

    [Fact]
    public void Pixels_of_two_cameras_and_points_without_height_find_the_ball()
    {
        TrackCamera left = TrackCamera.LookingAt(new Vector3d(0, 12, 40), new Vector3d(5, 1, 0), 1500, 1920, 1080);
        TrackCamera right = TrackCamera.LookingAt(new Vector3d(40, 12, 20), new Vector3d(5, 1, 0), 1500, 1920, 1080);
        var pixels = new BallFilter();
        var plan = new BallFilter(settings: new BallFilterSettings { Noise = Noise });
        foreach ((double time, Vector3d seen, BallState truth) in Track(1.5))
        {
            foreach (TrackCamera camera in (TrackCamera[])[left, right])
            {
                Assert.True(camera.TryProject(seen, out double u, out double v));
                pixels.Update(time, camera, u, v);
            }

            plan.Update(time, seen.X, seen.Z);
            if (time > 1)
            {
                Assert.InRange((pixels.Estimate.State.Position - truth.Position).Length, 0, 0.1);
                Assert.InRange((pixels.Estimate.State.Velocity - truth.Velocity).Length, 0, 1);
                Assert.InRange((plan.Estimate.State.Position - truth.Position).Horizontal.Length, 0, 0.2);
            }
        }
    }

    [Theory]
    [InlineData(18, 9, 3)]
    [InlineData(12, 3, -4)]
    [InlineData(15, 14, 0)]
    [InlineData(14, 0, 5)]
    public void A_height_that_no_point_shows_has_a_deviation_that_covers_it(double x, double y, double z)
    {
        var random = new SeededRandom(11);
        var simulator = new Simulator(Scene.Default, new SolverSettings { Integrator = Integrator.Rk4 });
        BallState ball = simulator.Launch(new Vector3d(1, simulator.ContactHeight, 2), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        BallFilter filter = Filter();
        for (int i = 0; i < 90; i++)
        {
            if (i == 25)
            {
                simulator.Kick(ref ball, new Vector3d(x, y, z), s_spin);
            }

            filter.Update(i * Interval, ball.Position.X + (Noise * Normal(random)), ball.Position.Z + (Noise * Normal(random)));
            if (i >= 29)
            {
                BallEstimate found = filter.Estimate;
                Assert.InRange((found.State.Position - ball.Position).Length, 0, 3 * Math.Sqrt(3) * found.PositionDeviation);
                Assert.InRange((found.State.Velocity - ball.Velocity).Length, 0, 3 * Math.Sqrt(3) * found.VelocityDeviation);
            }

            simulator.Run(ref ball, Interval, Interval, StopAt.Time, log);
        }
    }

    private static double Normal(SeededRandom random) => Math.Sqrt(-2 * Math.Log(1 - random.Next())) * Math.Cos(2 * Math.PI * random.Next());
}
