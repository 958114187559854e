using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Kicks that are looked for among things.</summary>
public sealed class BlockedAimTests
{
    private static readonly Obstacle s_post = new() { Name = "post", Shape = new CapsuleShape(new Vector3d(0, 0, -10), new Vector3d(0, 2.5, -10), 0.06) };

    private static readonly Obstacle s_roof = new() { Name = "roof", Shape = new BoxShape(new Vector3d(0, 7, -10), new Vector3d(20, 0.1, 9)) };

    private static readonly AimRequest s_request = new() { From = new Vector3d(0, Flight.Radius, 0), Target = new Vector3d(0, 1, -20), Speed = 20, MaximumElevationDegrees = 80 };

    [Theory]
    [ProfileData]
    public void A_kick_that_would_hit_a_post_goes_over_it_on_the_other_arc(Profile profile)
    {
        AimResult open = new Aimer(profile.Scene()).Find(s_request);
        AimResult found = new Aimer(profile.Scene() with { Obstacles = [s_post] }).Find(s_request);
        Assert.Equal(AimArc.Low, open.Arc);
        Assert.Equal(AimStatus.Hit, found.Status);
        Assert.Equal(AimArc.High, found.Arc);
        Assert.InRange(found.Miss, 0, s_request.Tolerance);
        Assert.Null(found.BlockedBy);
    }

    [Theory]
    [ProfileData(AimMethod.Direct)]
    [ProfileData(AimMethod.Angle)]
    [ProfileData(AimMethod.Bisection)]
    public void A_kick_with_no_way_is_blocked_and_says_by_what(Profile profile, AimMethod method)
    {
        AimResult found = new ThesisAimer(profile.Scene() with { Obstacles = [s_post, s_roof] }).Find(s_request, method);
        Assert.Equal(AimStatus.Blocked, found.Status);
        Assert.Contains(found.BlockedBy, new[] { "post", "roof" });
        Assert.False(found.HitsTarget);
        Assert.True(found.Miss > 1, $"{found.Miss}");
    }

    [Theory]
    [ProfileData]
    public void With_spin_to_choose_a_kick_goes_round_what_is_in_its_way(Profile profile)
    {
        Scene scene = profile.Scene() with { Obstacles = [s_post, s_roof] };
        AimResult found = new Aimer(scene).Find(s_request with { SpinIsFree = true });
        Assert.Equal(AimStatus.Hit, found.Status);
        Assert.InRange(Math.Abs(found.SideSpin), 1, s_request.MaximumSideSpin);

        // Told again in another method and step, it touches nothing before the target.
        var simulator = new Simulator(scene, Flight.With(Integrator.Rk2));
        BallState state = simulator.Launch(s_request.From, found.Velocity, found.Spin);
        var log = new StepLog();
        simulator.Run(ref state, 0.005, found.Time - 0.01, StopAt.Impact, log);
        Assert.Equal(0, log.Events.Count);
        Assert.InRange((state.Position - s_request.Target).Length, 0, 0.5);
    }

    [Theory]
    [ProfileData]
    public void A_goal_blocks_no_shot_into_it_and_its_net_one_from_behind(Profile profile)
    {
        Scene scene = profile.Scene() with { Goals = [new Goal { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) }] };
        var aimer = new Aimer(scene);
        AimRequest shot = s_request with { Target = new Vector3d(1, 1, -20.3) };
        Assert.Equal(AimStatus.Hit, aimer.Find(shot).Status);
        AimResult corner = aimer.Find(shot with { Target = new Vector3d(3.72, 1, -20), MaximumElevationDegrees = 30 });
        Assert.Equal(AimStatus.Blocked, corner.Status);
        Assert.Equal("left post", corner.BlockedBy);
        AimResult behind = aimer.Find(shot with { From = new Vector3d(0, Flight.Radius, -30), Target = new Vector3d(0, 1, -19), MaximumElevationDegrees = 30 });
        Assert.Equal(AimStatus.Blocked, behind.Status);
        Assert.Equal("back net", behind.BlockedBy);
    }

    [Theory]
    [ProfileData]
    public void A_body_is_in_the_way_when_it_will_be_there(Profile profile)
    {
        var bodies = new KinematicBodies();
        KinematicBody player = bodies.Add("player", new CapsuleShape(Vector3d.Zero, new Vector3d(0, 9, 0), 0.3));
        var aimer = new Aimer(profile.Scene() with { Bodies = bodies });
        AimRequest request = s_request with { MaximumElevationDegrees = 30, KickTime = 12 };
        double time = new Aimer(profile.Scene()).Find(request).Time;

        // He runs across, and is half way when the ball is.
        player.MoveTo(new Vector3d(-3, 0, -10), new Vector3d(6 / time, 0, 0), 12);
        Assert.Equal("player", aimer.Find(request).BlockedBy);
        player.MoveTo(new Vector3d(-3, 0, -10), new Vector3d(6 / time, 0, 0), 13);
        Assert.Equal(AimStatus.Hit, aimer.Find(request).Status);
        player.MoveTo(new Vector3d(-3, 0, -10), new Vector3d(6 / time, 0, 0), 12);
        Assert.Equal(AimStatus.Blocked, aimer.FindAtTime(request, time + 0.05).Status);
        Assert.Equal(AimStatus.Hit, new Aimer(profile.Scene()).FindAtTime(request, time + 0.05).Status);
    }

    [Theory]
    [ProfileData]
    public void A_search_among_things_allocates_nothing(Profile profile)
    {
        var aimer = new Aimer(profile.Scene() with { Obstacles = [s_post, s_roof] });
        AimRequest request = s_request with { SpinIsFree = true };
        Assert.Equal(0, Allocation.Of(() => aimer.Find(request)));
    }
}
