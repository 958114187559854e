using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Queries;

/// <summary>What the track of a whole match tells; football lab play tells of a thousand simulated minutes.</summary>
public sealed class MatchFitTests
{
    private const double Interval = 0.02;
    private static readonly Vector3d s_launch = new(12, 8, -14);
    private static readonly Vector3d s_header = new(-9, 5, 6);

    [Fact]
    public void Flights_impacts_and_touches_are_found_with_wind_and_drag()
    {
        MatchFitResult fit = new MatchFit(Known).Find(Track(noise: 0.003));
        MatchPiece[] flights = [.. fit.Pieces.Where(piece => piece.Kind == MatchPieceKind.Flight && piece.Duration >= 0.3)];
        Assert.Equal(flights.Length, fit.Flights);
        Assert.True(flights.Length >= 3);
        Assert.True(Vector3d.Distance(s_launch, flights[0].Velocity) < 0.5, $"{flights[0].Velocity}");
        Assert.Contains(fit.Pieces, piece => piece.Kind == MatchPieceKind.Touch && Math.Abs(piece.StartTime - HeaderTime) < 0.04 && Vector3d.Distance(piece.Velocity, s_header) < 0.6);
        Assert.Contains(fit.Pieces, piece => piece.Kind == MatchPieceKind.Impact && piece.Restitution is > 0.4 and < 0.9);
        Assert.InRange(fit.Rms, 0.003, 0.012);
        Assert.InRange(fit.Covered, 0.97, 1);
        Assert.InRange(fit.Scene.Ground.Height, -0.03, 0.03);
        for (int i = 0; i < fit.Names.Count; i++)
        {
            double truth = fit.Names[i] == "wind.x" ? 1.5 : fit.Names[i] == "wind.z" ? 0 : fit.Names[i] == "drag" ? 1 : double.NaN;
            Assert.True(double.IsNaN(truth) || Math.Abs(fit.Value(i) - truth) < 4 * fit.StandardError(i), $"{fit.Names[i]} {fit.Value(i)} ± {fit.StandardError(i)}");
        }
    }

    [Fact]
    public void The_same_track_gives_the_same_bits_and_its_pieces_are_in_order()
    {
        TrackPoint[] track = Track(noise: 0.02);
        MatchFitResult one = new MatchFit(Known).Find(track);
        MatchFitResult two = new MatchFit(Known).Find(track);
        Assert.Equal(one.Pieces.Count, two.Pieces.Count);
        for (int i = 0; i < one.Pieces.Count; i++)
        {
            Assert.Equal(one.Pieces[i].Velocity, two.Pieces[i].Velocity);
            Assert.Equal(one.Pieces[i].Spin, two.Pieces[i].Spin);
            Assert.True(i == 0 || one.Pieces[i].StartTime >= one.Pieces[i - 1].StartTime);
            Assert.Equal(one.Pieces[i].Points, one.Pieces[i].Observed.Count);
            Assert.Equal(one.Pieces[i].Points, one.Pieces[i].Fitted.Count);
        }
    }

    [Fact]
    public void A_seam_a_gap_and_points_that_jump_spoil_their_own_piece_alone()
    {
        List<TrackPoint> track = [.. Track(noise: 0.003)];
        track.RemoveAll(point => point.Time is > 4.0 and < 4.4);
        for (int i = 0; i < track.Count; i += 37)
        {
            track[i] = new TrackPoint(track[i].Time, track[i].Position + new Vector3d(2, 1, -3), 1e-4);
        }

        MatchFitResult fit = new MatchFit(Known).Find([.. track]);
        Assert.Contains(fit.Pieces, piece => piece.Kind == MatchPieceKind.Lost && piece.StartTime < 4.05 && piece.EndTime > 4.35);
        MatchPiece first = fit.Pieces.First(piece => piece.Kind == MatchPieceKind.Flight);
        Assert.True(Vector3d.Distance(s_launch, first.Velocity) < 0.5, $"{first.Velocity}");
        Assert.InRange(fit.Rms, 0.003, 0.015);
    }

    [Fact]
    public void Points_that_are_given_twice_count_once()
    {
        TrackPoint[] track = Track(noise: 0.003);
        MatchFitResult once = new MatchFit(Known).Find(track);
        MatchFitResult twice = new MatchFit(Known).Find([.. track.SelectMany(point => new[] { point, point })]);
        Assert.True(once.Flights >= 3);
        Assert.Equal(once.Flights, twice.Flights);
        Assert.Equal(once.Noise, twice.Noise);
        Assert.Equal(
            once.Pieces.Select(piece => (piece.Kind, piece.StartTime, piece.EndTime, piece.Points, piece.Velocity, piece.Spin)),
            twice.Pieces.Select(piece => (piece.Kind, piece.StartTime, piece.EndTime, piece.Points, piece.Velocity, piece.Spin)));
    }

    [Fact]
    public void Points_that_follow_at_once_do_not_cut_flights_short()
    {
        TrackPoint[] track = [.. Track(noise: 0.003).SelectMany(point => new[] { point, new TrackPoint(point.Time + 1e-10, point.Position, point.Noise) })];
        MatchFitResult fit = new MatchFit(Known).Find(track);
        Assert.True(fit.Flights >= 3, $"{fit.Flights}");
        Assert.InRange(fit.Covered, 0.97, 1);
    }

    [Fact]
    public void What_is_not_asked_for_stays_the_scenes()
    {
        var request = new MatchFitRequest { Wind = false, Drag = false, Surface = false, Height = false };
        MatchFitResult fit = new MatchFit(Known).Find(Track(noise: 0.003), request);
        Assert.Empty(fit.Names);
        Assert.Equal(Known.Air, fit.Scene.Air);
        Assert.Equal(Known.Ground, fit.Scene.Ground);
        Assert.Equal(Known.Ball, fit.Scene.Ball);
    }

    [Fact]
    public void It_tells_how_far_it_is_and_can_be_ended()
    {
        var told = new Told();
        new MatchFit(Known).Find(Track(noise: 0.003), progress: told);
        Assert.Equal(1, told.Values[^1]);
        Assert.Equal(told.Values.Order(), told.Values);
        using var source = new CancellationTokenSource();
        source.Cancel();
        Assert.Throws<OperationCanceledException>(() => new MatchFit(Known).Find(Track(noise: 0.003), cancellation: source.Token));
    }

    [Fact]
    public void Tracks_that_are_none_are_refused_by_name()
    {
        TrackPoint[] track = Track(noise: 0.003);
        Assert.Throws<ArgumentNullException>(() => new MatchFit().Find(null!));
        Assert.Contains("track's points", Assert.Throws<ArgumentOutOfRangeException>(() => new MatchFit().Find(track[..7])).Message, StringComparison.Ordinal);
        track[5] = new TrackPoint(-1, track[5].Position);
        Assert.Contains("track[5].time", Assert.Throws<ArgumentOutOfRangeException>(() => new MatchFit().Find(track)).Message, StringComparison.Ordinal);
        Assert.Contains("match.windDeviation", Assert.Throws<ArgumentOutOfRangeException>(() => new MatchFit().Find(track, new MatchFitRequest { WindDeviation = 0 })).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_ball_that_lies_still_has_no_flight()
    {
        TrackPoint[] track = [.. Enumerable.Range(0, 100).Select(i => new TrackPoint(0.04 * i, new Vector3d(1, 0.11, 2)))];
        MatchFitResult fit = new MatchFit().Find(track);
        Assert.Equal(0, fit.Flights);
        Assert.Equal(0, fit.Rms);
        Assert.All(fit.Pieces, piece => Assert.Equal(MatchPieceKind.Ground, piece.Kind));
    }

    private const double HeaderTime = 5.4;

    private static Scene Known { get; } = new() { Ball = BallProperties.Modern, Ground = Ground.Of(SurfaceMaterial.MatchTurf) };

    /// <summary>A kick, bounces, a header on the way, and more bounces, in wind.</summary>
    private static TrackPoint[] Track(double noise)
    {
        var simulator = new Simulator(Known with { Air = Known.Air with { Wind = new Vector3d(1.5, 0, 0) } });
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, 0.11, 0), Vector3d.Zero, Vector3d.Zero);
        var random = new Shots(3);
        var track = new TrackPoint[500];
        for (int i = 0; i < track.Length; i++)
        {
            if (i == 50)
            {
                simulator.Kick(ref ball, s_launch, new Vector3d(10, 20, -15));
            }
            else if (i == (int)(HeaderTime / Interval) || i == 180)
            {
                simulator.Kick(ref ball, i == 180 ? new Vector3d(3, 14, 12) : s_header, new Vector3d(-10, 5, 0));
            }

            track[i] = new TrackPoint(i * Interval, ball.Position + new Vector3d(Normal(random, noise), Normal(random, noise), Normal(random, noise)), 1e-4);
            log.Clear();
            simulator.Step(ref ball, Interval, log);
        }

        return track;
    }

    private static double Normal(Shots random, double deviation)
    {
        double sum = -6;
        for (int i = 0; i < 12; i++)
        {
            sum += random.Uniform(0, 1);
        }

        return deviation * sum;
    }

    private sealed class Told : IProgress<double>
    {
        public List<double> Values { get; } = [];

        public void Report(double value) => Values.Add(value);
    }
}
