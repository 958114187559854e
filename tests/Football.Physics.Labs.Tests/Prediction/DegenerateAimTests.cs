using FootballPhysics.Aiming;
using FootballPhysics.Scenes;

namespace FootballPhysics.Labs.Tests.Predictors;

/// <summary>Requests without sense get a finite answer of the speed asked for, by every method.</summary>
public sealed class DegenerateAimTests
{
    private static readonly Vector3d s_from = new(0, 0.11, 0);

    private static readonly (string Name, AimRequest Request)[] s_requests =
    [
        ("target at the ball", new AimRequest { From = s_from, Target = s_from }),
        ("target a hair away", new AimRequest { From = s_from, Target = s_from + new Vector3d(1e-9, 1e-9, 0) }),
        ("straight above", new AimRequest { From = s_from, Target = new Vector3d(0, 5, 0), MaximumElevationDegrees = 90 }),
        ("straight above, not allowed", new AimRequest { From = s_from, Target = new Vector3d(0, 5, 0) }),
        ("straight above, spinning", new AimRequest { From = s_from, Target = new Vector3d(0, 5, 0), MaximumElevationDegrees = 90, TopSpin = 30, SideSpin = -20 }),
        ("nearly above", new AimRequest { From = s_from, Target = new Vector3d(1e-7, 5, 0), MaximumElevationDegrees = 90 }),
        ("straight below", new AimRequest { From = new Vector3d(0, 10, 0), Target = new Vector3d(0, 1, 0), MinimumElevationDegrees = -90, MaximumElevationDegrees = 90 }),
        ("far away", new AimRequest { From = s_from, Target = new Vector3d(1e6, 0, -1e6) }),
        ("far above", new AimRequest { From = s_from, Target = new Vector3d(1, 1e6, 0) }),
        ("from far to far", new AimRequest { From = new Vector3d(-1e6, 1e6, 1e6), Target = new Vector3d(1e6, -1e6, -1e6) }),
        ("below ground", new AimRequest { From = s_from, Target = new Vector3d(15, -3, 0) }),
        ("both below ground", new AimRequest { From = new Vector3d(0, -5, 0), Target = new Vector3d(15, -3, 0) }),
        ("on the ground", new AimRequest { From = s_from, Target = new Vector3d(15, 0.11, 0) }),
        ("on the ground, very near", new AimRequest { From = s_from, Target = new Vector3d(0.01, 0.11, 0) }),
        ("one elevation", new AimRequest { From = s_from, Target = new Vector3d(15, 1, 0), MinimumElevationDegrees = 12, MaximumElevationDegrees = 12 }),
        ("only flat", new AimRequest { From = s_from, Target = new Vector3d(15, 1, 0), MinimumElevationDegrees = 0, MaximumElevationDegrees = 0 }),
        ("only up", new AimRequest { From = s_from, Target = new Vector3d(15, 1, 0), MinimumElevationDegrees = 90, MaximumElevationDegrees = 90 }),
        ("only down", new AimRequest { From = s_from, Target = new Vector3d(15, 1, 0), MinimumElevationDegrees = -90, MaximumElevationDegrees = -90 }),
        ("all elevations", new AimRequest { From = s_from, Target = new Vector3d(15, 1, 0), MinimumElevationDegrees = -90, MaximumElevationDegrees = 90 }),
        ("hardly moving", new AimRequest { From = s_from, Target = new Vector3d(15, 1, 0), Speed = 1e-9 }),
        ("slow", new AimRequest { From = s_from, Target = new Vector3d(15, 1, 0), Speed = 0.1 }),
        ("as fast as can be", new AimRequest { From = s_from, Target = new Vector3d(150, 10, 40), Speed = 1000, TopSpin = 3, SideSpin = 7 }),
        ("as much spin as can be", new AimRequest { From = s_from, Target = new Vector3d(15, 1, 3), TopSpin = 6_000, SideSpin = -8_000 }),
        ("one iteration", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), TopSpin = 20, SideSpin = 10, MaximumIterations = 1 }),
        ("a tiny tolerance", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), TopSpin = 20, SideSpin = 10, Tolerance = 1e-300 }),
        ("a huge tolerance", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Tolerance = 1e9 }),
        ("through the ball", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Waypoint = s_from }),
        ("through the target", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Waypoint = new Vector3d(18, 1, 3) }),
        ("through behind the ball", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Waypoint = new Vector3d(-9, 1, 0) }),
        ("through beyond the target", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Waypoint = new Vector3d(30, 1, 3) }),
        ("through high above", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Waypoint = new Vector3d(9, 500, 0) }),
        ("through far to the side", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Waypoint = new Vector3d(9, 1, 1000) }),
        ("through below ground", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Waypoint = new Vector3d(9, -4, 0) }),
        ("through with no spin allowed", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Waypoint = new Vector3d(9, 2, 2), MaximumTopSpin = 0, MaximumSideSpin = 0 }),
        ("through with all spin allowed", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), Waypoint = new Vector3d(9, 2, 4), MaximumTopSpin = 10_000, MaximumSideSpin = 10_000 }),
        ("through to above", new AimRequest { From = s_from, Target = new Vector3d(0, 5, 0), Waypoint = new Vector3d(0, 2, 0) }),
        ("through to the ball", new AimRequest { From = s_from, Target = s_from, Waypoint = new Vector3d(4, 2, 0) }),
        ("through out of reach", new AimRequest { From = s_from, Target = new Vector3d(90, 1, 3), Waypoint = new Vector3d(50, 2, 2) }),
        ("a target that outruns the ball", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), TargetVelocity = new Vector3d(900, 0, 0) }),
        ("a target that comes", new AimRequest { From = s_from, Target = new Vector3d(18, 1, 3), TargetVelocity = new Vector3d(-900, 0, 0) }),
    ];

    private static readonly (string Name, Scene Scene)[] s_scenes =
    [
        ("default", Scene.Published),
        ("vacuum", Scene.Vacuum),
        ("no gravity", Scene.Vacuum with { Gravity = 0 }),
        ("regularised, storm", Scene.Published with { Forces = ForceSet.Regularized, Air = new Air { Wind = new Vector3d(-40, 3, 25) } }),
        ("beach ball", Scene.Published with { Ball = BallProperties.BeachBall }),
        ("raised ground", Scene.Published with { Ground = Ground.PublishedTurf with { Height = 3 } }),
    ];

    public static TheoryData<string, AimMethod> Every()
    {
        var rows = new TheoryData<string, AimMethod>();
        foreach ((string name, AimRequest request) in s_requests)
        {
            foreach (AimMethod method in Enum.GetValues<AimMethod>().Where(method => method != AimMethod.TwoPoint || request.Waypoint is not null))
            {
                rows.Add(name, method);
            }
        }

        return rows;
    }

    [Theory]
    [MemberData(nameof(Every))]
    public void It_has_a_finite_answer_of_the_speed_within_the_bounds(string name, AimMethod method)
    {
        AimRequest request = s_requests.Single(item => item.Name == name).Request;
        foreach ((_, Scene scene) in s_scenes)
        {
            AimResult result = new ThesisAimer(scene, timeStep: 0.02).Find(request, method);
            AimCheck.Holds(request, in result, scene);
        }
    }

    [Fact]
    public void The_slowest_and_the_timely_kick_are_finite_too()
    {
        foreach ((_, Scene scene) in s_scenes)
        {
            var aimer = new Aimer(scene);
            foreach ((string name, AimRequest request) in s_requests.Where(item => item.Request.Waypoint is null))
            {
                AimResult slowest = aimer.FindSlowest(request);
                AimCheck.Holds(request, in slowest, scene, slowest.Velocity.Length);
                Assert.True(slowest.Velocity.Length <= request.Speed * (1 + 1e-9), name);
                AimResult timely = aimer.FindAtTime(request, 1);
                Assert.True(timely.Velocity.IsFinite && double.IsFinite(timely.Miss), name);
                Assert.True(timely.Velocity.Length <= request.Speed * (1 + 1e-9), name);
            }
        }
    }

    [Fact]
    public void Straight_up_and_down_are_hit_where_they_are_allowed()
    {
        var aimer = new Aimer(Scene.Published);
        foreach (string name in (string[])["straight above", "straight below"])
        {
            AimResult result = aimer.Find(s_requests.Single(item => item.Name == name).Request);
            Assert.Equal((name, AimStatus.Hit), (name, result.Status));
        }
    }

    [Fact]
    public void What_was_found_before_does_not_matter()
    {
        var used = new Aimer(Scene.Published);
        foreach ((string name, AimRequest request) in s_requests.Concat(s_requests.Reverse()))
        {
            AimResult fresh = new Aimer(Scene.Published).Find(request);
            AimResult again = used.Find(request);
            Assert.Equal((name, fresh.Velocity, fresh.Spin, fresh.Miss, fresh.Simulations), (name, again.Velocity, again.Spin, again.Miss, again.Simulations));
        }
    }
}
