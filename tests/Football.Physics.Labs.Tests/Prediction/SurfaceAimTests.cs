namespace FootballPhysics.Labs.Tests.Predictors;

/// <summary>Kicks that were flown on slopes, hills and in wind are found again, and none of them is called out of reach.</summary>
public sealed class SurfaceAimTests
{
    private const int Kicks = 40;

    /// <summary>A roll over hills takes long, because each of its steps asks for the shape of the ground.</summary>
    private const int KicksOnHills = 10;

    private static readonly string[] s_searches = ["Find", "FindSlowest", "FindAtSpeed", "FindAtTime", "not the slowest"];

    public static TheoryData<string, double> Conditions()
    {
        var rows = new TheoryData<string, double>();
        foreach (SurfaceCondition condition in SurfaceCondition.All)
        {
            rows.Add(condition.Name, condition.Wind);
        }

        return rows;
    }

    [Theory]
    [MemberData(nameof(Conditions))]
    public void A_known_kick_is_never_out_of_reach_and_a_hit_hits(string ground, double wind)
    {
        SurfaceCondition condition = SurfaceCondition.All.Single(one => one.Name == ground && one.Wind == wind);
        int kicks = condition.IsUneven ? KicksOnHills : Kicks;
        LabCounts counts = SurfaceKickCounts.Of(seed: 74, kicks, condition);
        string examples = string.Join("\n", counts.Examples);
        Assert.True(counts["kicks"] == kicks && counts["false out of reach"] == 0 && counts["false hits"] == 0, examples);
        Assert.True(s_searches.Sum(search => counts[search]) <= (wind > 0 ? 3 : 1), examples);
    }

    [Fact]
    public void A_target_well_beyond_the_reach_is_nearly_always_told()
    {
        LabCounts counts = FarTargetCounts.Of(seed: 74, 80);
        Assert.InRange(counts["targets"], 20, 80);
        Assert.Equal(0, counts["hits"]);
        Assert.True(counts["out of reach"] >= 0.9 * counts["targets"], string.Join("\n", counts.Examples));
    }

    [Theory]
    [InlineData(0.1)]
    [InlineData(-0.1)]
    public void A_ball_is_passed_along_a_slope_to_a_target_on_it(double rise)
    {
        var simulator = new Simulator(new Scene { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Normal = new Vector3d(0, 1, rise).Normalized() } });
        Vector3d target = simulator.Launch(new Vector3d(1, -5, -12), Vector3d.Zero, Vector3d.Zero).Position;
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = target, Speed = 16, MinimumElevationDegrees = -10, MaximumElevationDegrees = 7 };
        AimResult slowest = new Aimer(simulator).FindSlowest(request);
        Assert.Equal((AimStatus.Hit, true), (slowest.Status, slowest.Rolls));
        Assert.InRange(new ArrivalJudge(simulator).Of(request, in slowest).Miss, 0, 0.0101);
    }

    [Fact]
    public void The_slowest_roll_over_hills_hits_in_other_steps_than_those_of_the_search()
    {
        // Over hills, steps of 0.04 s were 5 mm off after 66 m: a miss of 13 mm was called a hit.
        SurfaceCondition hills = SurfaceCondition.All.Single(one => one.IsUneven && one.Wind > 0);
        var simulator = new Simulator(hills.Scene(new Random(9 * 100_003)));
        var request = new AimRequest
        {
            From = new Vector3d(0, 0.14165606897171687, 0),
            Target = new Vector3d(-29.503329935844658, 0.036688761875306425, -59.782662012154084),
            Speed = 30,
            TopSpin = -26.138543177460573,
            SideSpin = 15.381454986232079,
        };
        AimResult slowest = new Aimer(simulator).FindSlowest(request);
        Assert.Equal((AimStatus.Hit, true), (slowest.Status, slowest.Rolls));
        Assert.InRange(new ArrivalJudge(simulator).Of(request, in slowest).Miss, 0, 0.0101);
    }

    [Theory]
    [InlineData(0.7144776002110786)]
    [InlineData(2.0)]
    public void Of_two_rolls_in_a_cross_wind_the_one_with_the_arrival_speed_is_found(double speed)
    {
        // One roll goes nearly straight and arrives fast, the other one goes against the wind and drifts back.
        var simulator = new Simulator(new Scene { Ground = new Ground { Material = SurfaceMaterial.DryTurf }, Air = new Air { Wind = new Vector3d(2.5690487766330525, 0, -10.306977029988639) } });
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(-17.616746830926335, 0.11, 2.4849556482079938), Speed = 17.8, TopSpin = 3.3, SideSpin = -4.5 };
        AimResult found = new Aimer(simulator).FindAtSpeed(request, speed);
        Assert.Equal((AimStatus.Hit, true), (found.Status, found.Rolls));
        (double miss, double arrival) = new ArrivalJudge(simulator).Of(request, in found);
        Assert.InRange(miss, 0, 0.0101);
        Assert.InRange(arrival, speed - 0.02, speed + 0.02);
    }

    [Fact]
    public void A_moving_target_with_a_waypoint_is_refused()
    {
        var request = new AimRequest { Target = new Vector3d(0, 1, -20), Waypoint = new Vector3d(1, 2, -10), TargetVelocity = new Vector3d(1, 0, 0) };
        const string Message = "aim.targetVelocity cannot be combined with aim.waypoint.";
        Assert.Contains(Message, Assert.Throws<ArgumentOutOfRangeException>(() => new Aimer().Find(request)).Message, StringComparison.Ordinal);
        Assert.Contains("aim.targetVelocity", Assert.Throws<ArgumentOutOfRangeException>(() => new BankShotAimer().Find(request with { Waypoint = null }, "ground")).Message, StringComparison.Ordinal);
    }
}
