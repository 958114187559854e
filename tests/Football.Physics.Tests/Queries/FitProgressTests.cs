namespace FootballPhysics.Tests.Queries;

/// <summary>Fits report their progress in the calling thread, and the receiver can cancel them.</summary>
public sealed class FitProgressTests
{
    [Fact]
    public void A_fit_of_a_launch_reports_its_progress_and_has_the_same_result()
    {
        TrackPoint[] track = Track();
        var request = new TrackFitRequest { Lift = true };
        var told = new Receiver(null, int.MaxValue);
        TrackFitResult watched = new TrackFit().Find(track, request, told, default);
        TrackFitResult plain = new TrackFit().Find(track, request);
        Assert.Equal((plain.Velocity, plain.Spin, plain.ChiSquared), (watched.Velocity, watched.Spin, watched.ChiSquared));
        Assert.Equal(told.Values.Order(), told.Values);
        Assert.Equal(1, told.Values[^1]);
        Assert.InRange(told.Values.Count(value => value is > 0.1 and < 0.9), 20, int.MaxValue);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(150)]
    public void A_receiver_of_the_progress_cancels_a_fit_of_a_launch(int reports)
    {
        using var source = new CancellationTokenSource();
        var told = new Receiver(source, reports);
        Assert.Throws<OperationCanceledException>(() => new TrackFit().Find(Track(), null, told, source.Token));
        Assert.Equal(reports, told.Values.Count);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(40)]
    [InlineData(400)]
    public void A_receiver_of_the_progress_cancels_a_fit_of_a_match(int reports)
    {
        using var source = new CancellationTokenSource();
        var told = new Receiver(source, reports);
        Assert.Throws<OperationCanceledException>(() => new MatchFit().Find(Track(), null, told, source.Token));
        Assert.Equal(reports, told.Values.Count);
    }

    [Fact]
    public void A_fit_of_pixels_is_cancelled_too()
    {
        TrackCamera camera = TrackCamera.LookingAt(new Vector3d(60, 25, 0), new Vector3d(0, 2, 0), focalLength: 3000, width: 1920, height: 1080);
        PixelPoint[] pixels = [.. Track().Take(40).Select(point => camera.TryProject(point.Position, out double u, out double v) ? new PixelPoint(point.Time, 0, u, v, 0.5) : default)];
        using var source = new CancellationTokenSource();
        var told = new Receiver(source, 10);
        Assert.Throws<OperationCanceledException>(() => new TrackFit().Find([camera], pixels, null, told, source.Token));
        Assert.Equal(10, told.Values.Count);
    }

    /// <summary>Two kicks of one second and a half, 50 points per second, with errors of up to 1 cm.</summary>
    private static TrackPoint[] Track()
    {
        var simulator = new Simulator();
        var random = new Random(3);
        double Error() => 0.01 * ((2 * random.NextDouble()) - 1);
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 8), new Vector3d(2, 7, -18), new Vector3d(0, 40, 0));
        var track = new TrackPoint[150];
        for (int i = 0; i < track.Length; i++)
        {
            if (i == 75)
            {
                simulator.Kick(ref ball, new Vector3d(-3, 7, 15), new Vector3d(0, -30, 0));
            }

            track[i] = new TrackPoint(0.02 * i, ball.Position + new Vector3d(Error(), Error(), Error()), 0.006);
            simulator.Step(ref ball, 0.02, new StepLog());
        }

        return track;
    }

    private sealed class Receiver(CancellationTokenSource? source, int most) : IProgress<double>
    {
        public List<double> Values { get; } = [];

        public void Report(double value)
        {
            Values.Add(value);
            if (Values.Count == most)
            {
                source?.Cancel();
            }
        }
    }
}
