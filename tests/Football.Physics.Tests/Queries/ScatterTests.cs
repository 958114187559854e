using FootballPhysics.Numerics;

namespace FootballPhysics.Tests.Queries;

/// <summary>Where the kicks of a player go.</summary>
public sealed class ScatterTests
{
    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, -11), Facing = new Vector3d(0, 0, 1) };
    private static readonly Player s_keeper = new() { Position = new Vector3d(0, 0, -11), Reach = 1.5, MaximumHeight = 2.5 };
    private static readonly Vector3d s_from = new(0, 0.11, 0);
    private static readonly Vector3d s_velocity = new(4, 3, -22);
    private static readonly Vector3d s_spin = new(5, 20, 0);

    [Fact]
    public void A_small_spread_is_told_by_derivatives_as_flights_tell_it()
    {
        var scatter = new GoalChance(Scene.Measured);
        var spread = new KickSpread { SpeedPercent = 1, ElevationDegrees = 0.5, AzimuthDegrees = 0.5, SpinPercent = 5, SpeedWithElevation = -0.5 };
        GoalChanceResult told = scatter.Find(s_from, s_velocity, s_spin, spread, s_goal, s_keeper);
        GoalChanceResult flown = scatter.FindByFlights(s_from, s_velocity, s_spin, spread, s_goal, s_keeper, 20_000);
        Assert.Equal(GoalChanceMethod.Derivatives, told.Method);
        Assert.Equal(GoalChanceMethod.Flights, flown.Method);
        Assert.Equal(flown.OnTarget, told.OnTarget, 0.015);
        Assert.Equal(flown.Covered, told.Covered, 0.015);
        Assert.Equal(flown.LongAxis, told.LongAxis, 0.003);
        Assert.Equal(flown.ShortAxis, told.ShortAxis, 0.003);
        Assert.Equal(flown.Aside, told.Aside, 0.004);
        Assert.Equal(flown.Height, told.Height, 0.004);
    }

    /// <summary>Spin pushes less and less aside the more there is: the mean of the kicks crosses short of the one that is meant.</summary>
    [Theory]
    [InlineData(20)]
    [InlineData(-20)]
    public void The_mean_of_kicks_whose_side_spin_spreads_lies_on_the_side_where_there_is_less_of_it(double turning)
    {
        var scatter = new GoalChance(new Scene());
        var velocity = new Vector3d(0, 4, -24);
        var spin = new Vector3d(0, turning, 0);
        var spread = new KickSpread { SpeedPercent = 1, ElevationDegrees = 1, AzimuthDegrees = 0.3, SpinPercent = 30 };
        var none = new KickSpread { SpeedPercent = 0.01, ElevationDegrees = 0.01, AzimuthDegrees = 0.01, SpinPercent = 0.01 };
        double meant = scatter.Find(s_from, velocity, spin, none, s_goal).Aside;
        GoalChanceResult told = scatter.Find(s_from, velocity, spin, spread, s_goal);
        GoalChanceResult flown = scatter.FindByFlights(s_from, velocity, spin, spread, s_goal, null, 100_000);
        Assert.Equal(GoalChanceMethod.Derivatives, told.Method);
        Assert.InRange(Math.Abs(meant) - Math.Abs(flown.Aside), 0.013, 0.019);
        Assert.Equal(flown.Aside, told.Aside, 2e-3);
    }

    /// <summary>What comes near a post or the bar goes in as played kicks do: by derivatives, by flights, and in a scene in which the goal stands already.</summary>
    [Theory]
    [InlineData(3.58, 1.1)]
    [InlineData(-3.64, 0.5)]
    [InlineData(0, 2.4)]
    [InlineData(3.5, 2.3)]
    public void Kicks_near_the_frame_score_as_those_that_are_played(double aside, double height)
    {
        const int Kicks = 4000;
        AimResult aim = new Aimer().Find(new AimRequest { From = s_from, Target = new Vector3d(aside, height, -11), Speed = 22 });
        var spread = new KickSpread { SpeedPercent = 1, ElevationDegrees = 0.5, AzimuthDegrees = 0.5 };
        var simulator = new Simulator(new Scene { Goals = [s_goal] });
        var random = new Random(7);
        int goals = 0;
        int posts = 0;
        for (int i = 0; i < Kicks; i++)
        {
            (Vector3d velocity, Vector3d spin) = spread.Draw(random, aim.Velocity, aim.Spin);
            BallState ball = simulator.Launch(s_from, velocity, spin);
            var log = new StepLog();
            simulator.Run(ref ball, 0.02, 2, StopAt.Time, log);
            BallEvent[] events = log.Events.Span.ToArray();
            bool isGoal = events.Any(item => item.Kind == BallEventKind.Goal);
            goals += isGoal ? 1 : 0;
            posts += !isGoal && events.Any(item => item.Kind == BallEventKind.Impact && simulator.NameOf(item) is "left post" or "right post" or "crossbar") ? 1 : 0;
        }

        // Three standard errors of the played kicks, and of the flights.
        double played = (double)goals / Kicks;
        GoalChanceResult told = new GoalChance().Find(s_from, aim.Velocity, aim.Spin, spread, s_goal);
        GoalChanceResult stands = new GoalChance(new Scene { Goals = [s_goal] }).Find(s_from, aim.Velocity, aim.Spin, spread, s_goal);
        GoalChanceResult flown = new GoalChance().FindByFlights(s_from, aim.Velocity, aim.Spin, spread, s_goal, null, Kicks);
        Assert.Equal(GoalChanceMethod.Derivatives, told.Method);
        Assert.Equal(played, told.Scores, 0.024);
        Assert.Equal(played, flown.Scores, 0.035);
        Assert.Equal(told.Scores, stands.Scores, 1e-12);
        Assert.InRange(played, 0.05, 0.95);
        Assert.Equal((double)posts / Kicks, flown.Post!.Value, 0.035);
        Assert.True(posts > 100);
    }

    [Fact]
    public void A_large_spread_is_flown()
    {
        var scatter = new GoalChance(Scene.Measured);
        GoalChanceResult told = scatter.Find(s_from, s_velocity, s_spin, new KickSpread { SpeedPercent = 15, ElevationDegrees = 6, AzimuthDegrees = 6 }, s_goal);
        Assert.Equal((GoalChanceMethod.Flights, GoalChance.Flights), (told.Method, told.Kicks));
        Assert.InRange(told.OnTarget, 0.2, 0.99);
    }

    private static readonly GoalChanceRequest s_wild = new()
    {
        Position = s_from,
        Velocity = s_velocity,
        Spin = s_spin,
        Spread = new KickSpread { SpeedPercent = 6, ElevationDegrees = 3, AzimuthDegrees = 3 },
        Goal = s_goal,
        Keeper = s_keeper,
    };

    /// <summary>The kicks of a request cost what it says, and the standard error it states is that of other seeds.</summary>
    [Theory]
    [InlineData(500)]
    [InlineData(2000)]
    public void The_budget_is_kept_and_the_error_that_is_stated_is_that_of_other_seeds(int kicks)
    {
        const int Seeds = 24;
        var chance = new GoalChance();
        GoalChanceResult truth = chance.Find(s_wild with { Kicks = 50_000, Seed = 99, AlwaysSimulate = true });
        double squares = 0;
        double stated = 0;
        for (int seed = 0; seed < Seeds; seed++)
        {
            GoalChanceResult found = chance.Find(s_wild with { Kicks = kicks, Seed = seed, AlwaysSimulate = true });
            Assert.Equal((GoalChanceMethod.Flights, kicks), (found.Method, found.Kicks));
            squares += (found.Scores - truth.Scores) * (found.Scores - truth.Scores);
            stated += found.StandardError * found.StandardError;
        }

        double independent = Math.Sqrt(truth.Scores * (1 - truth.Scores) / kicks);
        Assert.InRange(Math.Sqrt(squares / stated), 0.5, 1.6);
        Assert.InRange(Math.Sqrt(stated / Seeds), 0.2 * independent, independent);
    }

    /// <summary>Equal requests give equal bits: again, by another calculator, on another thread, and whatever was computed before.</summary>
    [Fact]
    public async Task Equal_requests_give_equal_bits()
    {
        var chance = new GoalChance();
        GoalChanceResult first = chance.Find(s_wild with { Kicks = 700, Seed = 3 });
        chance.Find(s_wild with { Kicks = 300, Seed = 4, Keeper = null });
        Assert.Equal(first, chance.Find(s_wild with { Kicks = 700, Seed = 3 }));
        Assert.Equal(first, await Task.Run(() => new GoalChance().Find(s_wild with { Kicks = 700, Seed = 3 })));
        Assert.NotEqual(first, chance.Find(s_wild with { Kicks = 700, Seed = 4 }));
    }

    [Fact]
    public void Progress_is_reported_and_a_simulation_can_be_cancelled()
    {
        var chance = new GoalChance();
        var shares = new List<double>();
        chance.Find(s_wild with { Kicks = 600, AlwaysSimulate = true }, new Reports(shares.Add));
        Assert.Equal([256.0 / 600, 512.0 / 600, 1], shares);
        using var source = new CancellationTokenSource();
        shares.Clear();
        var cancelling = new Reports(share =>
        {
            shares.Add(share);
            source.Cancel();
        });
        Assert.Throws<OperationCanceledException>(() => chance.Find(s_wild with { Kicks = 600, AlwaysSimulate = true }, cancelling, source.Token));
        Assert.Single(shares);
        Assert.Throws<OperationCanceledException>(() => chance.Find(s_wild, null, source.Token));
        Assert.Throws<ArgumentNullException>(() => chance.Find(null!));
        Assert.Contains("2 … 100000000", Assert.Throws<ArgumentOutOfRangeException>(() => chance.Find(s_wild with { Kicks = 1 })).Message, StringComparison.Ordinal);
    }

    private sealed class Reports(Action<double> report) : IProgress<double>
    {
        public void Report(double value) => report(value);
    }

    /// <summary>A diving goalkeeper covers less of fast kicks than of slow ones: derivatives count that, or the kicks are simulated.</summary>
    [Theory]
    [InlineData(3.86, -2.27, 1.53, 20.1)]
    [InlineData(4.00, -2.41, 1.78, 24.2)]
    [InlineData(0.96, 2.23, 0.78, 21.8)]
    [InlineData(0.76, 2.31, 0.94, 20.9)]
    [InlineData(2.84, 2.80, 1.92, 20.7)]
    [InlineData(1.00, 1.00, 0.50, 24.0)]
    public void Where_the_goalkeeper_decides_the_chance_is_that_of_simulated_kicks(double degrees, double aside, double height, double speed)
    {
        var keeper = new Player { Position = new Vector3d(0, 0, -10.6), Reaction = 0.2, Acceleration = 8, Speed = 5, Reach = 1.9, MaximumHeight = 2.6 };
        AimResult aim = new Aimer().Find(new AimRequest { From = s_from, Target = new Vector3d(aside, height, -11), Speed = speed });
        var request = new GoalChanceRequest
        {
            Position = s_from,
            Velocity = aim.Velocity,
            Spin = aim.Spin,
            Spread = new KickSpread { SpeedPercent = 2 * degrees, ElevationDegrees = degrees, AzimuthDegrees = degrees },
            Goal = s_goal,
            Keeper = keeper,
        };
        var chance = new GoalChance();
        GoalChanceResult found = chance.Find(request);
        GoalChanceResult flown = chance.Find(request with { Kicks = 40_000, Seed = 5, AlwaysSimulate = true });
        Assert.Equal(flown.Scores, found.Scores, 0.005 + (3 * found.StandardError));
        Assert.InRange(found.StandardError, 0, 0.01);
        Assert.Equal(found.Method == GoalChanceMethod.Derivatives, found.StandardError == 0);
    }

    [Fact]
    public void Lanes_and_single_balls_are_the_same_kicks()
    {
        // A net far away keeps a scene out of the lanes.
        Scene alone = Scene.Measured with
        {
            Nets = [new Net { Center = new Vector3d(900, 5, 0), Normal = new Vector3d(1, 0, 0), Along = new Vector3d(0, 1, 0), HalfLength = 1, HalfWidth = 1 }],
        };
        var spread = new KickSpread { SpeedPercent = 6, ElevationDegrees = 4, AzimuthDegrees = 3 };
        GoalChanceResult lanes = new GoalChance(Scene.Measured).FindByFlights(s_from, s_velocity, s_spin, spread, s_goal, s_keeper, 600, 5);
        GoalChanceResult single = new GoalChance(alone).FindByFlights(s_from, s_velocity, s_spin, spread, s_goal, s_keeper, 600, 5);
        Assert.Equal(single.Aside, lanes.Aside, 1e-3);
        Assert.Equal(single.HeightDeviation, lanes.HeightDeviation, 1e-3);
        Assert.Equal(single.OnTarget, lanes.OnTarget, 3.0 / 600);
    }

    /// <summary>With seams, lanes do not carry the kicks: derivatives are as accurate as single kicks, and thousands of single kicks are refused.</summary>
    [Fact]
    public void With_seams_a_chance_is_that_of_single_kicks_and_thousands_are_refused()
    {
        Scene seamed = Scene.Measured with { Forces = ForceSet.Measured with { KnuckleSeed = 8 } };
        var chance = new GoalChance(seamed);
        var request = new GoalChanceRequest
        {
            Position = s_from,
            Velocity = s_velocity,
            Spin = s_spin,
            Orientation = new Quaterniond(0, 0.6, 0, 0.8),
            Spread = new KickSpread { SpeedPercent = 1, ElevationDegrees = 0.5, AzimuthDegrees = 0.5 },
            Goal = s_goal,
            Keeper = s_keeper,
        };
        GoalChanceResult found = chance.Find(request);
        GoalChanceResult flown = chance.Find(request with { Kicks = 1000, AlwaysSimulate = true });
        Assert.Equal((GoalChanceMethod.Derivatives, GoalChanceMethod.Flights), (found.Method, flown.Method));
        Assert.Equal(flown.Aside, found.Aside, 0.01);
        Assert.Equal(flown.Height, found.Height, 0.01);
        Assert.Equal(flown.AsideDeviation, found.AsideDeviation, 0.05 * found.AsideDeviation);
        Assert.Equal(flown.HeightDeviation, found.HeightDeviation, 0.05 * found.HeightDeviation);
        Assert.Equal(flown.OnTarget, found.OnTarget, 0.03);

        // The kick goes elsewhere in another orientation, and without seams.
        Assert.True(Math.Abs(found.Aside - chance.Find(request with { Orientation = null }).Aside) > 1e-3);
        Assert.Equal(chance.Find(request with { Orientation = new Simulator(seamed).LaunchOrientation }), chance.Find(request with { Orientation = null }));

        string message = Assert.Throws<ArgumentOutOfRangeException>(() => chance.Find(request with { Kicks = 1001, AlwaysSimulate = true })).Message;
        Assert.Contains("goalChance.kicks is 1001; allowed: 2 … 1000 with forces.knuckleSeed", message, StringComparison.Ordinal);
        Assert.Contains("launch.orientation", Assert.Throws<ArgumentOutOfRangeException>(() => chance.Find(request with { Orientation = default(Quaterniond) })).Message, StringComparison.Ordinal);
        Assert.Contains("forces.knuckleSeed is 8; allowed: none", Assert.Throws<ArgumentOutOfRangeException>(() => new PassFan(seamed)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Flights_in_lanes_allocate_no_more_than_their_hand_over()
    {
        var scatter = new GoalChance(Scene.Measured);
        var spread = new KickSpread { SpeedPercent = 2 };
        Assert.InRange(Allocation.Of(() => scatter.FindByFlights(s_from, s_velocity, s_spin, spread, s_goal, null, 512)), 0, 16384);
    }

    [Fact]
    public void Correlations_that_no_kicks_have_are_refused()
    {
        string message = Assert.Throws<ArgumentOutOfRangeException>(
            () => new KickSpread { SpeedWithElevation = 0.9, SpeedWithAzimuth = 0.9, ElevationWithAzimuth = -0.9 }.Validate()).Message;
        Assert.Contains("positive definite", message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => new KickSpread { SpeedPercent = -1 }.Validate());
    }

    [Theory]
    [InlineData(0, 0.5)]
    [InlineData(1, 0.841344746068543)]
    [InlineData(-2.5, 0.006209665325776)]
    public void The_normal_integral_is_that_of_the_tables(double x, double expected) => Assert.Equal(expected, NormalDistribution.Integral(x), 1e-14);

    [Fact]
    public void A_rectangle_far_wider_than_the_spread_holds_all()
    {
        Assert.Equal(1, NormalDistribution.Rectangle(0.1, -0.2, 0.3, 0.5, 0.7, -9, 9, -9, 9), 1e-9);
        Assert.Equal(0.25, NormalDistribution.Rectangle(0, 0, 1, 2, 0, 0, 99, 0, 99), 1e-6);
        Assert.Equal(0.25 + (Math.Asin(0.6) / (2 * Math.PI)), NormalDistribution.Rectangle(0, 0, 1, 2, 0.6, 0, 99, 0, 99), 1e-6);
    }

    [Fact]
    public void Correlations_that_contradict_one_another_are_refused()
    {
        var spread = new KickSpread { SpeedWithElevation = 1, SpeedWithAzimuth = 0.5, ElevationWithAzimuth = -0.5 };
        Assert.Contains("correlations", Assert.Throws<ArgumentOutOfRangeException>(() => new GoalChance(Scene.Measured).Find(s_from, s_velocity, s_spin, spread, s_goal)).Message, StringComparison.Ordinal);
        Assert.True(new GoalChance(Scene.Measured).Find(s_from, s_velocity, s_spin, spread with { ElevationWithAzimuth = 0.5 }, s_goal).OnTarget >= 0);
    }

    /// <summary>A kick that is drawn is within the limits of a kick, also where the one that is meant is near them.</summary>
    [Fact]
    public void Kicks_near_the_limits_are_drawn_within_them() =>
        Assert.InRange(new GoalChance(Scene.Measured).FindByFlights(s_from, new Vector3d(0, 30, -990), new Vector3d(0, 9_900, 0), new KickSpread { SpinPercent = 10 }, s_goal, null, 500).OnTarget, 0, 1);
}
