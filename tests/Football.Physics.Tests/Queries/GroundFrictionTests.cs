using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Queries;

/// <summary>Sliding and rolling friction from the track of passes along the ground, which the library simulates itself.</summary>
public sealed class GroundFrictionTests
{
    /// <summary>The wait between two passes, s; each is kicked without spin, slides, and rolls.</summary>
    private const double Wait = 3;
    private const int Passes = 14;

    [Theory]
    [InlineData(0.43, 0.064, 0.003, 0.003, 0.02, 1)]
    [InlineData(0.43, 0.064, 0.003, 0.01, 0.04, 2)]
    [InlineData(0.30, 0.05, 0, 0.002, 0.02, 3)]
    [InlineData(0.60, 0.10, 0.008, 0.005, 0.02, 4)]
    [InlineData(0.50, 0.07, 0.006, 0.02, 0.02, 5)]
    public void Frictions_are_found_within_three_deviations(double sliding, double rolling, double bySpeed, double noise, double interval, int seed)
    {
        Scene scene = With(Known, sliding, rolling, bySpeed);
        MatchFitResult fit = new MatchFit(Known).Find([.. Track(scene, noise, interval, seed).Seen], Request);
        Assert.True(fit.Windows.Count(window => window.Motion == MotionState.Rolling) >= Passes / 2, $"{fit.Windows.Count}");
        AssertWithin(sliding, fit, "slidingFriction", 0.05);
        AssertWithin(rolling, fit, "rollingFriction", 0.04);
        AssertWithin(bySpeed, fit, "rollingFrictionBySpeed", 0.006);
        double there = fit.Scene.Ground.Material.RollingResistance + (fit.Scene.Ground.Material.RollingResistancePerSpeed * fit.RollingSpeed);
        Assert.InRange(fit.RollingDeviation, 1e-4, 0.01);
        Assert.InRange(there, rolling + (bySpeed * fit.RollingSpeed) - (3 * fit.RollingDeviation), rolling + (bySpeed * fit.RollingSpeed) + (3 * fit.RollingDeviation));
    }

    [Fact]
    public void Windows_lie_in_slides_and_rolls_and_their_deviations_hold()
    {
        Scene scene = With(Known, 0.45, 0.07, 0.004);
        (List<TrackPoint> seen, List<BallState> truth) = Track(scene, 0.003, 0.02, 7);
        MatchFitResult fit = new MatchFit(Known).Find([.. seen], Request);
        int within = 0;
        foreach (GroundWindow window in fit.Windows)
        {
            BallState[] inside = [.. truth.Where(ball => ball.Time >= window.StartTime - 1e-9 && ball.Time <= window.EndTime + 1e-9)];
            Assert.Equal(window.Points, inside.Length);
            Assert.True(inside.Count(ball => ball.Motion == window.Motion) >= inside.Length - 2, $"{window}");
            Assert.InRange(window.Speed, inside[^1].Velocity.Length - 0.3, inside[0].Velocity.Length + 0.3);
            double resistance = window.Motion == MotionState.Sliding ? 0.45 : 0.07 + (0.004 * window.Speed);
            within += Math.Abs(window.Resistance - resistance) <= 2 * window.StandardError ? 1 : 0;
        }

        Assert.Contains(fit.Windows, window => window.Motion == MotionState.Sliding);
        Assert.Contains(fit.Windows, window => window.Motion == MotionState.Rolling);
        Assert.True(within >= 0.85 * fit.Windows.Count, $"{within} of {fit.Windows.Count}");
    }

    [Fact]
    public void The_published_laws_are_told_by_their_own_air()
    {
        Scene known = Scene.Published;
        Scene scene = With(known, 0.4, 0.06, 0);
        MatchFitResult fit = new MatchFit(known).Find([.. Track(scene, 0.003, 0.02, 11).Seen], Request);
        AssertWithin(0.4, fit, "slidingFriction", 0.05);
        AssertWithin(0.06, fit, "rollingFriction", 0.04);
    }

    [Fact]
    public void A_ball_that_is_carried_or_lies_tells_nothing_of_friction()
    {
        // Two seconds at rest, two at a constant 4 m/s: interpolated, or dribbled.
        TrackPoint[] track = [.. Enumerable.Range(0, 200).Select(i => new TrackPoint(0.02 * i, new Vector3d(Math.Max(0, 0.08 * (i - 100)), 0.11, 0)))];
        MatchFitResult fit = new MatchFit(Known).Find(track, Request);
        Assert.Empty(fit.Windows);
        Assert.DoesNotContain(fit.Names, name => name is "slidingFriction" or "rollingFriction" or "rollingFrictionBySpeed");
        Assert.Equal(0, fit.RollingSpeed);
        Assert.Equal(Known.Ground.Material.SlidingFriction, fit.Scene.Ground.Material.SlidingFriction);
    }

    [Fact]
    public void Without_the_surface_there_are_no_windows()
    {
        TrackPoint[] track = [.. Track(Known, 0.003, 0.02, 5).Seen];
        Assert.Empty(new MatchFit(Known).Find(track, Request with { Surface = false }).Windows);
        Assert.NotEmpty(new MatchFit(Known).Find(track, Request).Windows);
    }

    private static MatchFitRequest Request { get; } = new() { Wind = false, Drag = false };

    private static Scene Known { get; } = new() { Ball = BallProperties.Modern, Ground = Ground.Of(SurfaceMaterial.MatchTurf) };

    private static Scene With(Scene scene, double sliding, double rolling, double bySpeed) =>
        scene with { Ground = scene.Ground with { Material = scene.Ground.Material with { SlidingFriction = sliding, RollingResistance = rolling, RollingResistancePerSpeed = bySpeed } } };

    private static void AssertWithin(double truth, MatchFitResult fit, string name, double most)
    {
        int at = fit.Names.ToList().IndexOf(name);
        Assert.True(at >= 0, name);
        Assert.InRange(fit.StandardError(at), 1e-4, most);
        Assert.True(Math.Abs(fit.Value(at) - truth) <= 3 * fit.StandardError(at), $"{name} {fit.Value(at)} ± {fit.StandardError(at)}, true {truth}");
    }

    /// <summary>Passes along the ground in all directions, one after the other, as a tracker sees them.</summary>
    private static (List<TrackPoint> Seen, List<BallState> Truth) Track(Scene scene, double noise, double interval, int seed)
    {
        var random = new Shots(seed);
        var simulator = new Simulator(scene);
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), Vector3d.Zero, Vector3d.Zero);
        List<TrackPoint> seen = [];
        List<BallState> truth = [];
        int every = (int)Math.Round(Wait / interval);
        for (int i = 0; i < Passes * every; i++)
        {
            if (i % every == 0)
            {
                double speed = random.Uniform(6, 12);
                double x = random.Uniform(-1, 1);
                double z = random.Uniform(-1, 1);
                double size = Math.Sqrt((x * x) + (z * z));
                simulator.Kick(ref ball, new Vector3d(speed * x / size, 0, speed * z / size), Vector3d.Zero);
            }

            truth.Add(ball);
            seen.Add(new TrackPoint(ball.Time, ball.Position + new Vector3d(Normal(random, noise), Normal(random, noise), Normal(random, noise)), 1e-4));
            log.Clear();
            simulator.Step(ref ball, interval, log);
        }

        return (seen, truth);
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
}
