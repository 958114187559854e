namespace FootballPhysics.Tests.Predictors;

/// <summary>A result says what its kick does.</summary>
public sealed class AimResultTests
{
    private static readonly AimRequest s_pass = new() { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(3, 1, -20), Speed = 20, TopSpin = 12, SideSpin = -7 };

    [Fact]
    public void The_arc_is_the_one_that_was_found()
    {
        var aimer = new Aimer(Scene.Published);
        Assert.Equal(AimArc.Low, aimer.Find(s_pass).Arc);
        Assert.Equal(AimArc.Low, aimer.Find(s_pass with { Arc = AimArc.High }).Arc); // it is steeper than 45°
        AimResult high = aimer.Find(s_pass with { Arc = AimArc.High, MaximumElevationDegrees = 85 });
        Assert.Equal((AimStatus.Hit, AimArc.High), (high.Status, high.Arc));
        Assert.Equal(AimArc.High, aimer.Find(s_pass with { MinimumElevationDegrees = 50, MaximumElevationDegrees = 85 }).Arc);
    }

    [Fact]
    public void A_kick_that_rolls_says_so()
    {
        var aimer = new Aimer(Scene.Published);
        Assert.True(aimer.Find(new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(35, 0.11, 4), Speed = 15 }).Rolls);
        Assert.False(aimer.Find(s_pass).Rolls);
    }

    [Fact]
    public void Its_numbers_are_those_of_the_request()
    {
        AimResult kick = new Aimer(new Simulator(Scene.Published)).Find(s_pass);
        Assert.Equal(20, kick.Speed, 1e-9);
        Assert.Equal(12, kick.TopSpin, 1e-9);
        Assert.Equal(-7, kick.SideSpin, 1e-9);
        Assert.InRange(kick.ElevationDegrees, 5, 30);
        Assert.InRange(kick.AzimuthDegrees, -20, 0); // to the right of forward
        Vector3d again = kick.Speed * new Vector3d(
            -Math.Sin(kick.AzimuthDegrees * Math.PI / 180) * Math.Cos(kick.ElevationDegrees * Math.PI / 180),
            Math.Sin(kick.ElevationDegrees * Math.PI / 180),
            -Math.Cos(kick.AzimuthDegrees * Math.PI / 180) * Math.Cos(kick.ElevationDegrees * Math.PI / 180));
        Assert.True(Vector3d.Distance(again, kick.Velocity) < 1e-9);
    }

    [Fact]
    public void A_point_on_the_way_that_is_missed_is_no_hit()
    {
        AimResult result = new Aimer(Scene.Published).Find(s_pass with { Waypoint = new Vector3d(1, 4, -10), MaximumTopSpin = 5, MaximumSideSpin = 5 });
        Assert.Equal((AimStatus.WaypointMissed, true), (result.Status, result.HitsTarget));
        Assert.True(result.WaypointMiss > 0.1 && result.Miss <= 0.01);
    }

    [Fact]
    public void A_ball_can_be_kicked_with_it()
    {
        AimResult kick = new Aimer(Scene.Published).Find(s_pass);
        var ball = new Ball();
        ball.Kick(in kick);
        Assert.Equal(kick.Velocity, ball.State.Velocity);
        var runner = new FixedStepRunner();
        runner.QueueKick(in kick);
        Assert.Equal(kick.Velocity, runner.Kicks[0].Velocity);
    }

    [Fact]
    public void A_request_without_a_target_is_refused() =>
        Assert.Contains("aim.target", Assert.Throws<ArgumentOutOfRangeException>(() => new Aimer(Scene.Published).Find(new AimRequest { Speed = 20 })).Message, StringComparison.Ordinal);
}
