namespace FootballPhysics.Tests.Predictors;

/// <summary>Each verdict names its bound, its undefined quantity, or its nearest miss.</summary>
public sealed class AimReasonTests
{
    private static readonly AimRequest s_pass = new() { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(3, 1, -20), Speed = 20 };
    private static readonly Aimer s_aimer = new(Scene.Measured);

    [Fact]
    public void A_hit_has_no_reason() => Assert.Null(s_aimer.Find(s_pass).Reason);

    [Fact]
    public void A_target_out_of_reach_names_the_bound()
    {
        AimRequest far = s_pass with { Target = new Vector3d(0, 1, -200) };
        Is(AimStatus.OutOfReach, "all pass below the target or fall short", s_aimer.Find(far));
        Is(AimStatus.OutOfReach, "all pass below the target or fall short", s_aimer.Find(far, measure: false));
        Is(AimStatus.OutOfReach, "all pass below the target or fall short", s_aimer.FindSlowest(far));
        Is(AimStatus.OutOfReach, "too little energy", s_aimer.Find(s_pass with { Target = new Vector3d(0, 60, -10) }));
        Is(AimStatus.OutOfReach, "too little energy", s_aimer.Find(s_pass with { Target = new Vector3d(0, 60, -10), Waypoint = new Vector3d(0, 30, -5) }));
        Is(AimStatus.OutOfReach, "too slow to cover the distance in the requested time", s_aimer.FindAtTime(s_pass, 0.3));
        Is(AimStatus.OutOfReach, "slower at the target than the requested arrival speed", s_aimer.FindAtSpeed(s_pass, 40));

        // Every kick of at least 60° flies over a near target, but a slower one would not.
        AimRequest lobs = s_pass with { Target = new Vector3d(0, 1, -6), MinimumElevationDegrees = 60, MaximumElevationDegrees = 75 };
        Is(AimStatus.OutOfReach, "all pass above the target or below it", s_aimer.Find(lobs));
        Assert.Equal(AimStatus.Hit, s_aimer.FindSlowest(lobs).Status);
    }

    [Fact]
    public void A_degenerate_request_names_the_quantity() =>
        Is(AimStatus.Degenerate, "The direction of the kick is undefined", s_aimer.Find(s_pass with { Target = s_pass.From }));

    [Fact]
    public void A_search_that_finds_nothing_states_the_nearest_miss()
    {
        var windy = new Aimer(Scene.Measured with { Air = new Air { Wind = new Vector3d(3, 0, 0) } });
        Nearest(AimStatus.NotConverged, "no bound excludes one", windy.Find(s_pass with { Target = new Vector3d(0, 1, -80) }));
        Nearest(AimStatus.NotConverged, "reached its limit", windy.Find(s_pass with { Target = new Vector3d(0, 1, -80), MaximumIterations = 1 }));
        Nearest(AimStatus.NotConverged, "arrives at another speed", s_aimer.FindAtSpeed(s_pass, 19));
        Nearest(AimStatus.NotConverged, "hits the given objects in order", new BankShotAimer(Scene.Measured).Find(s_pass with { Target = new Vector3d(0, 1, -200) }, "ground"));
    }

    [Fact]
    public void A_blocked_kick_names_the_object_and_states_the_nearest_miss()
    {
        var wall = new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 20, -10), new Vector3d(30, 20.5, 0.1)) };
        AimResult kick = new Aimer(Scene.Measured with { Obstacles = [wall] }).Find(s_pass);
        Nearest(AimStatus.Blocked, "an object is in its path: board.", kick);
    }

    [Fact]
    public void A_kick_of_the_target_only_states_the_nearest_miss_of_the_waypoint()
    {
        AimResult kick = s_aimer.Find(s_pass with { Waypoint = new Vector3d(1, 4, -10), MaximumTopSpin = 5, MaximumSideSpin = 5 });
        Is(AimStatus.WaypointMissed, $"The nearest miss is {kick.WaypointMiss!.Value.ToString("G3", System.Globalization.CultureInfo.InvariantCulture)} m.", kick);
    }

    [Theory]
    [InlineData(AimMethod.Angle)]
    [InlineData(AimMethod.Bisection)]
    public void A_method_that_tries_two_kicks_calls_a_target_out_of_reach_only_with_a_bound(AimMethod method)
    {
        // The flattest and the steepest kick pass below a target that a kick in between hits.
        var thesis = new ThesisAimer(Scene.Measured);
        AimRequest steep = s_pass with { Target = new Vector3d(0, 1, -28), MaximumElevationDegrees = 60 };
        Assert.Equal(AimStatus.Hit, thesis.Find(steep, AimMethod.Direct).Status);
        Nearest(AimStatus.NotConverged, "pass on the same side of the target", thesis.Find(steep, method));
        Is(AimStatus.OutOfReach, "all pass below the target or fall short", thesis.Find(s_pass with { Target = new Vector3d(0, 1, -200) }, method));
    }

    [Fact]
    public void A_waypoint_that_is_not_between_the_points_has_no_order()
    {
        AimRequest behind = s_pass with { Target = new Vector3d(0, 1, -200), Waypoint = new Vector3d(0, 1, 5) };
        Is(AimStatus.Degenerate, "The order of the points is undefined", new ThesisAimer(Scene.Measured).Find(behind, AimMethod.TwoPoint));
    }

    [Fact]
    public void Every_reason_but_a_hit_has_a_status_and_a_short_sentence()
    {
        AimReason[] reasons = Enum.GetValues<AimReason>();
        Assert.Equal(Enum.GetValues<AimStatus>(), reasons.Select(reason => reason.Status()).Distinct().Order());
        string[] texts = [.. reasons.Where(reason => reason != AimReason.Hit).Select(reason => reason.Text(default)!)];
        Assert.Equal(texts.Length, texts.Distinct().Count());
        Assert.All(texts, text => Assert.All(text.Split(". "), sentence => Assert.InRange(sentence.Split(' ').Length, 4, 20)));
        Assert.All(texts, text => Assert.EndsWith(".", text, StringComparison.Ordinal));
    }

    private static void Is(AimStatus status, string part, AimResult kick)
    {
        Assert.Equal(status, kick.Status);
        Assert.Contains(part, kick.Reason, StringComparison.Ordinal);
    }

    private static void Nearest(AimStatus status, string part, AimResult kick)
    {
        Is(status, part, kick);
        Assert.Contains($"The nearest miss is {kick.Miss.ToString("G3", System.Globalization.CultureInfo.InvariantCulture)} m.", kick.Reason, StringComparison.Ordinal);
    }
}
