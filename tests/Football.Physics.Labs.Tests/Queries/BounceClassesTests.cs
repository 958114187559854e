using FootballPhysics.Labs.Play;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Labs.Tests.Queries;

/// <summary>The table of bounces by class, on a track that the library simulates: the surface it was simulated on is near, another one is not.</summary>
public sealed class BounceClassesTests
{
    private const double Interval = 0.02;

    [Fact]
    public void The_surface_of_the_track_is_near_in_every_class_and_dry_turf_is_not()
    {
        Ground surface = Ground.Of(SurfaceMaterial.MatchTurf with { NormalRestitution = 0.72, GrazingRestitutionGain = 0.2, ImpactFriction = 0.33, TangentialRestitution = -0.1 });
        MatchFitResult fit = new MatchFit(new Scene { Ball = BallProperties.Modern, Ground = Ground.Of(SurfaceMaterial.MatchTurf) }).Find(Track(surface), new MatchFitRequest { Wind = false, Drag = false });
        BounceRow[] rows = [.. BounceClasses.Of(fit, [("own", surface), ("dryTurf", Ground.Of(SurfaceMaterial.DryTurf))])];
        BounceRow[] seen = [.. rows.Where(row => row.Surface is null)];
        Assert.Equal(["0–6 m/s", "6–10 m/s", "over 10 m/s"], seen.Select(row => row.Class));
        Assert.Equal(9, rows.Length);
        Assert.All(seen, row => Assert.True(row.Impacts >= 3 && row.Off == default, $"{row}"));
        foreach (BounceRow row in rows.Where(row => row.Surface == "own"))
        {
            Assert.True(Math.Abs(row.Off.Restitution) < 0.03 && Math.Abs(row.Off.Kept) < 0.03 && Math.Abs(row.Off.Friction) < 0.05, $"{row}");
        }

        BounceRow dry = rows.Single(row => row.Surface == "dryTurf" && row.Class == "over 10 m/s");
        Assert.True(dry.Off.Restitution < -0.08 && dry.Off.Kept < -0.05, $"{dry}");
        Assert.Equal(0.33, seen[^1].Median.Friction, 0.03);
    }

    /// <summary>Kicks of 7 to 24 m/s, flat and high, each of which bounces.</summary>
    private static TrackPoint[] Track(Ground surface)
    {
        var simulator = new Simulator(new Scene { Ball = BallProperties.Modern, Ground = surface });
        var random = new SeededRandom(17L);
        var log = new StepLog();
        BallState ball = simulator.Launch(new Vector3d(0, simulator.ContactHeight, 0), Vector3d.Zero, Vector3d.Zero);
        List<TrackPoint> track = [];
        for (int kick = 0; kick < 16; kick++)
        {
            double speed = 7 + (17.0 * kick / 15);
            double elevation = (kick % 2 == 0 ? 20 : 38) * Math.PI / 180;
            double way = kick % 2 == 0 ? 1 : -1;
            simulator.Kick(ref ball, new Vector3d(way * speed * Math.Cos(elevation), speed * Math.Sin(elevation), way), Vector3d.Zero);
            int impacts = 0;
            while (impacts < 3)
            {
                track.Add(new TrackPoint(ball.Time, ball.Position + (0.001 * random.Direction()), 1e-4));
                log.Clear();
                simulator.Step(ref ball, Interval, log);
                for (int i = 0; i < log.Events.Count; i++)
                {
                    impacts += log.Events[i].Kind == BallEventKind.Impact ? 1 : 0;
                }
            }
        }

        return [.. track];
    }
}
