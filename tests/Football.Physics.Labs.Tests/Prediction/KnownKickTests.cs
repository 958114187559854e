namespace FootballPhysics.Labs.Tests.Predictors;

/// <summary>Kicks that were flown are found again, by every question whose answer they are.</summary>
public sealed class KnownKickTests
{
    private const int Footballs = 3;
    private static readonly string[] s_questions = ["low arc", "high arc", "at their time", "no slower one"];

    [Fact]
    public void In_still_air_every_one_is_found()
    {
        LabCounts counts = KnownKickCounts.Of(seed: 71, 300, wind: 0, Footballs);
        string examples = string.Join("\n", counts.Examples.Where(example => !example.StartsWith("two points, steep", StringComparison.Ordinal)));
        Assert.True(s_questions.All(question => counts[question] == 0), examples);
        Assert.True(counts["two points below 45°"] <= 1, examples);
    }

    [Fact]
    public void In_wind_nearly_every_one_is_found()
    {
        LabCounts counts = KnownKickCounts.Of(seed: 72, 300, wind: 20, Footballs);
        string examples = string.Join("\n", counts.Examples.Where(example => !example.StartsWith("two points", StringComparison.Ordinal)));
        Assert.True(s_questions.All(question => counts[question] <= 1), examples);
        Assert.InRange(counts["two points below 45°"], 0, 6);
    }

    [Fact]
    public void The_bound_on_a_search_holds()
    {
        LabCounts counts = KnownKickCounts.Of(seed: 73, 100, wind: 20, KnownKick.Balls.Length);
        Assert.InRange(counts["most iterations"], 1, 60);
        Assert.InRange(counts["most simulations"], 1, 16 * 60);
    }

    [Fact]
    public void A_kick_in_wind_that_a_scan_over_elevations_loses_is_found()
    {
        var scene = Scene.Published with { Air = new Air { Wind = new Vector3d(-11.7, 0, -5.3) } };
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(10, 2, -15), Speed = 31, MinimumElevationDegrees = 30, MaximumElevationDegrees = 85 };
        AimResult result = new Aimer(scene).Find(request);
        AimCheck.Holds(request, in result, scene);
        Assert.Equal(AimStatus.Hit, result.Status);
    }

    public static TheoryData<double, double, double, double> GroundTargets() => new()
    {
        { 25, 0, 0, 10.8 },
        { 25, 45, 0, 10.8 },
        { 20, 45, 20, 7.8 },
        { 8, 45, 0, 5.5 },
        { 35, 30, -15, 15 },
    };

    [Theory]
    [MemberData(nameof(GroundTargets))]
    public void The_slowest_pass_along_the_ground_rolls(double distance, double highest, double top, double atMost)
    {
        var request = new AimRequest
        {
            From = new Vector3d(0, 0.11, 0),
            Target = new Vector3d(0, 0.11, -distance),
            Speed = 30,
            TopSpin = top,
            MaximumElevationDegrees = highest,
        };
        AimResult result = new Aimer(Scene.Published).FindSlowest(request);
        AimCheck.Holds(request, in result, speed: result.Velocity.Length);
        Assert.Equal((AimStatus.Hit, 0.0), (result.Status, result.Velocity.Y));
        Assert.InRange(result.Velocity.Length, 0.5 * atMost, atMost);
        Assert.NotEqual(AimStatus.Hit, new Aimer(Scene.Published).Find(request with { Speed = 0.99 * result.Velocity.Length }).Status);
    }

    [Fact]
    public void The_slowest_kick_is_found_where_the_fastest_hits()
    {
        var request = new AimRequest
        {
            From = new Vector3d(0, 0.11, 0),
            Target = new Vector3d(-4.543773466290559, 0.41673442772001806, 28.91283775422973),
            Speed = 30.39412878615811,
            TopSpin = 6.3910076135666,
            SideSpin = -13.305187693522143,
            Tolerance = 1e-3,
        };
        AimResult result = new Aimer(Scene.Published).FindSlowest(request);
        AimCheck.Holds(request, in result, speed: result.Velocity.Length);
        Assert.Equal(AimStatus.Hit, result.Status);
    }

    [Fact]
    public void A_lob_is_found_at_its_own_time()
    {
        var request = new AimRequest
        {
            From = new Vector3d(0, 0.11, 0),
            Target = new Vector3d(3.06, 2.02, -11.56),
            Speed = 21.8,
            SideSpin = 2,
            MaximumElevationDegrees = 90,
            Arc = AimArc.High,
        };
        var aimer = new Aimer(Scene.Published);
        AimResult found = aimer.Find(request);
        AimResult timed = aimer.FindAtTime(request, found.Time);
        Assert.Equal((AimStatus.Hit, AimStatus.Hit), (found.Status, timed.Status));
        Assert.Equal(found.Time, timed.Time, 1e-9);
    }

    [Fact]
    public void A_pass_along_the_ground_is_found_at_its_own_time()
    {
        var aimer = new Aimer(Scene.Published);
        foreach (double distance in (double[])[5, 12, 25])
        {
            var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(distance, 0.11, 3), Speed = 16, SideSpin = 10, MaximumElevationDegrees = 0 };
            AimResult found = aimer.Find(request);
            AimResult timed = aimer.FindAtTime(request, found.Time);
            Assert.Equal((AimStatus.Hit, AimStatus.Hit), (found.Status, timed.Status));
        }
    }

    [Fact]
    public void A_time_that_is_too_short_has_the_distance_that_is_left()
    {
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(20, 1, 0), Speed = 25 };
        AimResult result = new Aimer(Scene.Published).FindAtTime(request, 0.4);
        Assert.Equal(AimStatus.OutOfReach, result.Status);
        Assert.InRange(result.Miss, 8, 12);
    }

    [Fact]
    public void A_drive_that_the_ground_holds_is_no_hit()
    {
        var request = new AimRequest
        {
            From = new Vector3d(0, 0.11, 0),
            Target = new Vector3d(-7.8158, 0.3815, -22.8196),
            Speed = 33.3534,
            TopSpin = -56.22,
            MaximumElevationDegrees = 60,
            Tolerance = 1e-3,
        };
        var aimer = new Aimer(Scene.Published);
        AimResult measured = aimer.Find(request);
        AimCheck.Holds(request, in measured);
        AimResult estimated = aimer.Find(request, measure: false);
        Assert.Equal(measured.Status == AimStatus.Hit, estimated.Status == AimStatus.Hit);
    }

    [Fact]
    public void A_target_on_the_grass_is_raised_to_contact_height_as_the_ball_is()
    {
        var request = new AimRequest { From = Vector3d.Zero, Target = new Vector3d(15, 0, 0) };
        AimResult result = new Aimer(Scene.Published).Find(request);
        Assert.Equal(AimStatus.Hit, result.Status);
        Assert.InRange(result.Simulations, 1, 30);
    }

    [Theory]
    [InlineData(AimMethod.Direct)]
    [InlineData(AimMethod.Angle)]
    [InlineData(AimMethod.Bisection)]
    public void A_target_at_the_ball_is_degenerate(AimMethod method) =>
        Assert.Equal(AimStatus.Degenerate, new ThesisAimer(Scene.Published).Find(new AimRequest { From = new Vector3d(0, 0.5, 0), Target = new Vector3d(0, 0.5, 0) }, method).Status);

    [Fact]
    public void The_steeper_of_two_kicks_is_on_the_low_arc_where_it_is_there_first()
    {
        foreach ((BallProperties ball, AimRequest request) in new[]
        {
            (BallProperties.BeachBall, new AimRequest
            {
                From = new Vector3d(0, 0.2, 0),
                Target = new Vector3d(1.498859899243839, 4.910540333761371, 1.0317475899279027),
                Speed = 21.26021822740334,
                TopSpin = -31.190410992684967,
                SideSpin = -15.236235067824012,
                MaximumElevationDegrees = 85,
            }),
            (BallProperties.Tunnel, new AimRequest
            {
                From = new Vector3d(0, 1.244815239875957, 0),
                Target = new Vector3d(-0.29855781053946595, 24.431971713560444, 1.4942964189357022),
                Speed = 26.891291924701672,
                TopSpin = -48.17137885753595,
                SideSpin = -26.76439591532778,
                MaximumElevationDegrees = 85,
            }),
        })
        {
            var aimer = new Aimer(Scene.Published with { Ball = ball });
            AimResult low = aimer.Find(request);
            AimResult high = aimer.Find(request with { Arc = AimArc.High });
            Assert.Equal((AimStatus.Hit, AimStatus.Hit), (low.Status, high.Status));
            Assert.True(low.Time < high.Time && low.ElevationDegrees > high.ElevationDegrees, $"{low} {high}");
        }
    }

    public static TheoryData<Vector3d, Vector3d, Vector3d, double> LightTwoPoints() => new()
    {
        { new(0, 2.6241135629937586, 0), new(2.0670143059474375, 5.235458854887758, 0.03920694314201605), new(3.318899906000829, 5.241073378732097, 0.15439822059940364), 14.800238371733686 },
        { new(0, 0.2, 0), new(-1.869688776179993, 1.527724391076089, 5.292014750494533), new(-1.8516105752879695, 1.5211640034935674, 6.29902905711263), 28.312030505999935 },
        { new(0, 0.6943155534538978, 0), new(-3.6642354661457524, 5.933719387141995, 1.70713509004538), new(-4.16238167508296, 5.741180246074848, 2.448763367996713), 32.073428485111066 },
    };

    [Theory]
    [MemberData(nameof(LightTwoPoints))]
    public void A_light_ball_passes_two_points_that_it_passed_before(Vector3d from, Vector3d through, Vector3d target, double speed)
    {
        var request = new AimRequest { From = from, Waypoint = through, Target = target, Speed = speed, MaximumElevationDegrees = 85, Tolerance = 1e-3 };
        AimResult result = new Aimer(Scene.Published with { Ball = BallProperties.BeachBall }).Find(request);
        Assert.Equal(AimStatus.Hit, result.Status);
        Assert.InRange(result.WaypointMiss!.Value, 0, request.WaypointTolerance);
    }

    [Fact]
    public void The_slowest_kick_takes_a_few_flights()
    {
        var aimer = new Aimer(Scene.Published);
        AimRequest[] requests = AimSets.Thesis(seed: 1, 64);
        int simulations = 0;
        foreach (AimRequest request in requests)
        {
            AimResult slowest = aimer.FindSlowest(request);
            simulations += slowest.Simulations;
            Assert.Equal(AimStatus.Hit, slowest.Status);
            Assert.NotEqual(AimStatus.Hit, aimer.Find(request with { Speed = 0.999 * slowest.Speed, Tolerance = 1e-3 }).Status);
        }

        Assert.InRange(simulations, 64, 8 * 64);
    }
}
