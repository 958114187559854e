using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Motion;

/// <summary>Impacts by the measured laws: check values worked out elsewhere, and what a skimming shot keeps.</summary>
public sealed class MeasuredImpactTests
{
    [Fact]
    public void A_skimming_ball_slips_and_a_steep_one_grips_as_worked_out()
    {
        (Vector3d v, Vector3d w) = After(Ground.Of(SurfaceMaterial.DryTurf), new Vector3d(20, -2, 0), Vector3d.Zero);
        Near(new Vector3d(16.08100853, 1.26582623, 0), v, 5e-9);
        Near(new Vector3d(0, 0, -53.4407928), w, 5e-8);
        (v, w) = After(Ground.Of(SurfaceMaterial.DryTurf), new Vector3d(5, -8, 2), new Vector3d(10, 30, -20));
        Near(new Vector3d(3.656, 4.90320193, 1.568), v, 5e-9);
        Near(new Vector3d(15.89090909, 14.00429513, -38.32727273), w, 5e-8);
        (v, w) = After(Ground.Of(SurfaceMaterial.WetTurf), new Vector3d(20, -2, 0), Vector3d.Zero);
        Assert.Equal(18.41999924, v.X, 5e-9);
        Assert.Equal(-21.54546495, w.Z, 5e-8);
    }

    [Fact]
    public void A_shot_that_skims_wet_turf_keeps_its_speed_and_gains_none_at_the_next_touch()
    {
        Scene scene = Scene.Measured with { Ground = Ground.Of(SurfaceMaterial.WetTurf) };
        double angle = 2 * Math.PI / 180;
        var velocity = new Vector3d(30 * Math.Cos(angle), -30 * Math.Sin(angle), 0);
        Flight.Play(scene, SolverSettings.Default, 0.01, 3, StopAt.Time, new Vector3d(0, 0.11, 0), velocity, Vector3d.Zero, out StepLog log);
        BallEvent[] touches = [.. log.Events.Span.ToArray().Where(item => item.Kind == BallEventKind.Impact)];
        Assert.True(touches.Length >= 2);
        Assert.True(touches[0].Velocity.Length >= 0.95 * touches[0].VelocityBefore.Length, $"{touches[0].Velocity.Length} of {touches[0].VelocityBefore.Length} m/s");
        Assert.True(touches[1].Velocity.Length <= touches[1].VelocityBefore.Length, $"{touches[1].Velocity.Length} of {touches[1].VelocityBefore.Length} m/s");
    }

    [Fact]
    public void No_impact_gains_energy()
    {
        var random = new Shots(77);
        Ground[] grounds = [Ground.Of(SurfaceMaterial.DryTurf), Ground.Of(SurfaceMaterial.WetTurf), Ground.Of(SurfaceMaterial.Concrete), Ground.Of(SurfaceMaterial.LongGrass), Ground.Of(SurfaceMaterial.Snow), Ground.Of(SurfaceMaterial.DryTurf with { ImpactFriction = 0.01 }), Ground.Of(SurfaceMaterial.MatchTurf), Ground.Of(SurfaceMaterial.Concrete with { GrazingRestitutionGain = 1 })];
        BallProperties ball = BallProperties.Tunnel;
        for (int i = 0; i < 2000; i++)
        {
            Vector3d v = random.Velocity(0.1, 60, -89, -0.1);
            Vector3d w = random.Uniform(0, 300) * random.Direction();
            (Vector3d velocity, Vector3d spin) = After(grounds[i % grounds.Length], v, w);
            double before = (ball.Mass * v.LengthSquared) + (ball.MomentOfInertia * w.LengthSquared);
            double after = (ball.Mass * velocity.LengthSquared) + (ball.MomentOfInertia * spin.LengthSquared);
            Assert.True(after <= before * (1 + 1e-14), $"{v}, {w}: {before / 2} J to {after / 2} J");
            Assert.True(velocity.Y > 0);
        }
    }

    /// <summary>e + η (1 − e) c⁴/(c⁴ + 2.8⁴): nothing of it head-on, half of it where the speed along is 2.8 times that towards the ground, all of it at last.</summary>
    [Theory]
    [InlineData(0, 0)]
    [InlineData(2.8, 0.5)]
    [InlineData(1e9, 1)]
    public void Restitution_rises_with_obliqueness(double slope, double share)
    {
        Ground ground = Ground.Of(SurfaceMaterial.DryTurf with { GrazingRestitutionGain = 0.8 });
        double before = After(Ground.Of(SurfaceMaterial.DryTurf), new Vector3d(slope * 4, -4, 0), Vector3d.Zero).Velocity.Y / 4;
        double after = After(ground, new Vector3d(slope * 4, -4, 0), Vector3d.Zero).Velocity.Y / 4;
        Assert.Equal(before + (0.8 * share * (1 - before)), after, 1e-12);
    }

    private static (Vector3d Velocity, Vector3d Spin) After(Ground ground, Vector3d velocity, Vector3d spin)
    {
        ImpactLaw.Apply(BallProperties.Tunnel, new ContactMaterial(ground), Vector3d.Up, Vector3d.Zero, in velocity, in spin, out Vector3d v, out Vector3d w);
        return (v, w);
    }

    private static void Near(Vector3d expected, Vector3d actual, double tolerance) =>
        Assert.True(Vector3d.Distance(expected, actual) <= tolerance, $"{actual}, expected {expected}");
}
