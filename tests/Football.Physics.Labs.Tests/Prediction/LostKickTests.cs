using FootballPhysics.Aiming;

namespace FootballPhysics.Labs.Tests.Predictors;

/// <summary>Kicks that were flown, and that searches over the time, or for two points, lost.</summary>
public sealed class LostKickTests
{
    private static AimRequest Request(Vector3d from, Vector3d target, double speed, double top, double side, double lowest, double highest) => new()
    {
        From = from,
        Target = target,
        Speed = speed,
        TopSpin = top,
        SideSpin = side,
        MinimumElevationDegrees = lowest,
        MaximumElevationDegrees = highest,
        Tolerance = 1e-3,
    };

    private static Scene Scene(Vector3d wind, BallProperties? ball = null) =>
        FootballPhysics.Scene.Published with { Ball = ball ?? BallProperties.Tunnel, Air = new Air { Wind = wind } };

    /// <summary>A kick that hits within the bounds, and its speed, m/s; the fastest that is allowed is a fifth more.</summary>
    public static TheoryData<string, AimRequest, Vector3d> Slow() => new()
    {
        {
            "the next longer time grazes the drag law's jump, so that its kick is not known",
            Request(
                new(0, 1.9740654263384947, 0), new(-53.38641298931043, 2.4755263643146983, 19.023119332589186), 31.284547157718123, -5.575936034124311, 23.427014971816448,
                23.958324197660353, 39.95832419766035),
            Vector3d.Zero
        },
        {
            "no kick takes the next longer time: topspin pushes every one beyond the target",
            Request(
                new(0, 2.426973130133456, 0), new(3.950347482875606, 29.409680760659793, -6.908327588387935), 31.047992094442243, 27.610266663883948, -32.75282284373083,
                75.53365769774358, 90),
            Vector3d.Zero
        },
        {
            "of the times that are looked at first, one is too flat and the next too steep",
            Request(
                new(0, 0.11, 0), new(15.909123054844844, 9.209191630488307, -17.14185429391636), 16.19104999638677, 45.91806223425924, -10.189871424897511,
                70.2409893112448, 86.2409893112448),
            new Vector3d(11.501932521423488, 0, -16.312439836771926)
        },
        {
            "two kicks are slower than their neighbours",
            Request(
                new(0, 0.11, 0), new(-3.226525977053755, 8.519436957988784, 4.587381314978476), 13.693969686838784, -25.901590043633053, -22.709879359560965,
                75.52628409421364, 90),
            new Vector3d(-13.869646364113084, 0, 6.221568686254393)
        },
        {
            "the slowest is kicked away from the target, and its backspin brings it there",
            Request(
                new(0, 2.061249324228265, 0), new(7.574419337565229, 23.883154178983837, 3.5419182878991484), 34.24755639827231, -36.065358242981766, 17.390751776933087,
                75.98514979238861, 90),
            Vector3d.Zero
        },
        {
            "the slowest is kicked away from the target, against the wind",
            Request(
                new(0, 2.575399367485847, 0), new(-8.449205680341144, 22.026547909204208, -4.1607866325948875), 21.327118247899747, -27.617913055055734, 12.747157673699391,
                0, 85),
            new Vector3d(-13.252457469040191, 0, -3.2586155859579717)
        },
    };

    [Theory]
    [MemberData(nameof(Slow))]
    public void None_is_slower_than_the_slowest(string because, AimRequest request, Vector3d wind)
    {
        AimRequest faster = request with { Speed = 1.2 * request.Speed };
        AimResult slowest = new Aimer(Scene(wind)).FindSlowest(faster);
        AimCheck.Holds(faster, in slowest, Scene(wind), slowest.Speed);
        Assert.True(slowest.Status == AimStatus.Hit && slowest.Speed <= request.Speed, $"{because}: {slowest}");
    }

    [Fact]
    public void A_steep_kick_away_from_its_target_is_found_at_its_own_time()
    {
        AimRequest still = Request(
            new(0, 0.11, 0), new(3.3359378692260955, 34.323980758526396, -0.09642025428634748), 34.94816118383228, -38.870587008479326, -1.4575611108250754, 76.06088747785468, 90);
        AimResult found = new Aimer(Scene(Vector3d.Zero)).FindAtTime(still, 1.7843101104647447);
        Assert.Equal((AimStatus.Hit, true), (found.Status, found.Velocity.X < 0));

        AimRequest windy = Request(
            new(0, 0.7928346437368703, 0), new(-7.806621987119231, 34.193247390501796, -4.288276168554724), 32.46522243016642, -15.611020413046248, -3.8593047083631618, 0, 85);
        Scene futsal = Scene(new Vector3d(-4.664492182789927, 0, -2.6887594098478087), BallProperties.Futsal);
        Assert.Equal(AimStatus.Hit, new Aimer(futsal).FindAtTime(windy, 3.4733963015867895).Status);
    }

    [Fact]
    public void A_light_ball_passes_two_points_although_its_angles_and_spins_do_almost_the_same()
    {
        var request = new AimRequest
        {
            From = new Vector3d(0, 1.8156848189959696, 0),
            Waypoint = new Vector3d(-1.160251610684084, 2.5077647138233905, 2.5406006873103726),
            Target = new Vector3d(2.445295352470876, 2.2485201868058016, 3.0054643198824396),
            Speed = 22.91941769324216,
            MaximumTopSpin = 40,
            MaximumSideSpin = 40,
            MaximumElevationDegrees = 85,
            Tolerance = 1e-3,
        };
        Scene scene = Scene(new Vector3d(17.747920387461132, 0, -1.7470939101089937), BallProperties.BeachBall);
        AimResult result = new Aimer(scene).Find(request);
        AimCheck.Holds(request, in result, scene);
        Assert.Equal(AimStatus.Hit, result.Status);
        Assert.InRange(result.WaypointMiss!.Value, 0, request.WaypointTolerance);
    }
}
