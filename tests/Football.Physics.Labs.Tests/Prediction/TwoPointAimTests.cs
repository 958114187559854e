using FootballPhysics.Aiming;

namespace FootballPhysics.Labs.Tests.Predictors;

/// <summary>A point on the way and a target.</summary>
public sealed class TwoPointAimTests
{
    /// <summary>The kick for the target alone is not the one that came near the point: its own miss there is told, measured or not.</summary>
    [Fact]
    public void A_kick_for_the_target_alone_is_no_hit_of_both()
    {
        var request = new AimRequest
        {
            From = new Vector3d(0, 0.11, 0),
            Target = new Vector3d(25.61015641475195, 3.134920612085321, -0.744245637757711),
            Waypoint = new Vector3d(7.846570690671645, 2.3210332258104875, -0.22802578450969788),
            Speed = 26.904411966867936,
            Tolerance = 0.01,
            WaypointTolerance = 0.01,
            MaximumIterations = 1,
        };
        var aimer = new Aimer(new Simulator(new Scene { Ball = BallProperties.Tunnel }));
        AimResult unmeasured = aimer.Find(request, measure: false);
        AimResult measured = aimer.Find(request);
        Assert.NotEqual(AimStatus.Hit, unmeasured.Status);
        Assert.Equal(measured.Status, unmeasured.Status);
    }

    [Fact]
    public void Direct_passes_both_points_of_every_kick_there_is()
    {
        var aimer = new Aimer(Scene.Published);
        int simulations = 0;
        foreach (AimRequest request in AimSets.TwoPoint(1, 300))
        {
            AimResult result = aimer.Find(request);
            simulations += result.Simulations;
            AimCheck.Holds(request, in result);
            Assert.True(result.Miss <= 1e-3 && result.WaypointMiss <= 1e-2, $"{result.Status} {result.Miss} {result.WaypointMiss}: {request}");
        }

        Assert.InRange(simulations / 300.0, 1, 2);
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void Where_the_spin_is_at_its_limit_the_target_is_hit_and_the_miss_of_the_point_is_told(bool around)
    {
        var aimer = new ThesisAimer(Scene.Published, settings: new SolverSettings { Integrator = Integrator.Rk2 }, timeStep: 0.04);
        int saturated = 0;
        int simulations = 0;
        foreach (AimRequest request in around ? AimSets.AroundTheWall(41) : AimSets.OverTheWall(41))
        {
            AimResult direct = aimer.Direct.Find(request);
            AimCheck.Holds(request, in direct);
            Assert.True(direct.Miss <= 1e-3, $"{direct.Status} {direct.Miss}: {request}");
            AimResult thesis = aimer.Find(request, AimMethod.TwoPoint);
            AimCheck.Holds(request, in thesis);
            simulations += thesis.Simulations;
            Assert.True(thesis.Miss <= 0.01, $"{thesis.Status} {thesis.Miss}: {request}");

            // Within the limits, up to rounding.
            var shot = new AimShot(request, direct, direct.Miss, 0);
            Assert.InRange(shot.SideSpin, -40 - 1e-9, 40 + 1e-9);
            Assert.InRange(shot.TopSpin, -40 - 1e-9, 40 + 1e-9);
            bool limited = Math.Abs(shot.SideSpin) > 39.999 || Math.Abs(shot.TopSpin) > 39.999;
            saturated += limited ? 1 : 0;
            Assert.True(limited || direct.WaypointMiss <= 1e-2, $"{direct.WaypointMiss}: {request}");
        }

        Assert.InRange(saturated, 5, 38);
        Assert.InRange(simulations / 41.0, 10, 45);
    }

    [Fact]
    public void Without_spin_it_hits_the_target()
    {
        var aimer = new Aimer(Scene.Published);
        foreach (AimRequest request in AimSets.OverTheWall(21))
        {
            AimResult result = aimer.Find(request with { MaximumTopSpin = 0, MaximumSideSpin = 0 });
            Assert.True(result.Miss <= 1e-3, $"{result.Status} {result.Miss}");
            Assert.Equal(0, result.Spin.Length, 1e-12);
            Assert.True(result.WaypointMiss > 0.01);
        }
    }
}
