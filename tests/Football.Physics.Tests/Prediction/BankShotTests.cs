using FootballPhysics.Yardsticks;

namespace FootballPhysics.Tests.Predictors;

/// <summary>Kicks after bounces and off things: how much it takes to find them, and what they do.</summary>
public sealed class BankShotTests
{
    private const double Tolerance = 1e-3;

    private const int Requests = 8;

    private static readonly Scene Scene = Scene.Measured with
    {
        Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(-9, 0, 0), new Vector3d(1, 0, 0)), Surface = SurfaceMaterial.Board }],
        Goals = [new Goal { Center = new Vector3d(0, 0, -14), Facing = new Vector3d(0, 0, 1), Surface = SurfaceMaterial.GoalFrame, HasNet = false }],
    };

    [Theory]
    [InlineData(20, 60, 40, "ground")]
    [InlineData(-60, -20, 60, "ground,ground")]
    [InlineData(20, 70, 30, "wall")]
    [InlineData(20, 70, 60, "wall,ground")]
    [InlineData(20, 70, 100, "ground,wall")]
    [InlineData(13, 18, 30, "right post")]
    [InlineData(-18, -13, 30, "left post")]
    [InlineData(-12, 12, 60, "crossbar")]
    [InlineData(-12, 12, 100, "crossbar,ground")]
    public void Known_kicks_are_found_again_in_few_simulations_and_do_what_is_asked(double least, double most, int simulations, string things)
    {
        string[] after = things.Split(',');
        var simulator = new Simulator(Scene);
        var aimer = new BankShotAimer(Scene);
        var path = new Trajectory(1024);
        int sum = 0;
        foreach (AimRequest request in Draw(least, most, after))
        {
            AimResult found = aimer.Find(request, after);
            Assert.Equal(AimStatus.Hit, found.Status);
            Assert.InRange(found.Simulations, 1, simulations);
            sum += found.Simulations;
            Assert.InRange(found.Miss, 0, Tolerance);

            // Flown again in steps of a fourth, it meets just these, and then the target.
            BallState again = simulator.Launch(request.From, found.Velocity, found.Spin);
            simulator.LookAhead(in again, new LookAheadRequest { Duration = found.Time, TimeStep = 0.005, StopAt = StopAt.Time }, path);
            Assert.Equal(after, Impacts(path).Select(e => simulator.NameOf(e.ColliderIndex)!));
            Assert.InRange(Vector3d.Distance(path.Final.Position, request.Target), 0, Tolerance + 1e-5);
            Assert.Equal(request.Speed, found.Velocity.Length, 9);
        }

        Assert.InRange(sum, 0, Requests * simulations / 2);
    }

    /// <summary>The force of the seams depends on the orientation, which a leg after an impact takes from the leg before.</summary>
    [Theory]
    [InlineData(20, 60, 40, "ground")]
    [InlineData(20, 70, 40, "wall")]
    [InlineData(20, 70, 60, "wall,ground")]
    [InlineData(-12, 12, 60, "crossbar")]
    public void With_seams_they_are_found_in_as_few_simulations(double least, double most, int simulations, string things)
    {
        string[] after = things.Split(',');
        Scene seamed = Scene with { Forces = ForceSet.Measured with { KnuckleSeed = 11 } };
        var aimer = new BankShotAimer(seamed);
        int sum = 0;
        foreach (AimRequest request in Draw(least, most, after, seamed))
        {
            AimResult found = aimer.Find(request, after);
            Assert.Equal(AimStatus.Hit, found.Status);
            Assert.InRange(found.Miss, 0, Tolerance);
            sum += found.Simulations;
        }

        Assert.InRange(sum, 0, Requests * simulations / 2);
    }

    [Theory]
    [InlineData(20, 60, "ground")]
    [InlineData(20, 70, "wall,ground")]
    [InlineData(13, 18, "right post")]
    public void An_aimer_that_is_warm_allocates_nothing_and_finds_the_same(double least, double most, string things)
    {
        string[] after = things.Split(',');
        AimRequest request = Draw(least, most, after)[0];
        var aimer = new BankShotAimer(Scene);
        AimResult first = aimer.Find(request, after);
        AimResult last = default;
        Assert.Equal(0, Allocation.Of(() => last = aimer.Find(request, after)));
        string[] other = [.. after, "ground"];
        aimer.Find(request, other);
        Assert.Equal(0, Allocation.Of(() => aimer.Find(request, other)));
        Assert.Equal(0, Allocation.Of(() => last = aimer.Find(request, after)));
        Assert.Equal(first.Velocity, last.Velocity);
        Assert.Equal(first.Simulations, last.Simulations);
    }

    [Fact]
    public void A_place_behind_the_wall_is_not_converged()
    {
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(-15, 1, -10), Speed = 22, Tolerance = Tolerance };
        AimResult found = new BankShotAimer(Scene).Find(request, "wall");
        Assert.Equal(AimStatus.NotConverged, found.Status);
        Assert.True(found.Miss > 1);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(5)]
    public void A_wall_that_moves_is_met_where_it_is_then(double kickTime)
    {
        Scene scene = Scene.Measured with
        {
            Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(-9, 0, 0), new Vector3d(1, 0, 0)), Velocity = new Vector3d(0.5, 0, 0), Surface = SurfaceMaterial.Board }],
        };
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(-4, 0.6, -14), Speed = 22, Tolerance = Tolerance, KickTime = kickTime };
        AimResult found = new BankShotAimer(scene).Find(request, "wall");
        Assert.Equal(AimStatus.Hit, found.Status);
        var simulator = new Simulator(scene);
        BallState again = simulator.LaunchAt(request.From, found.Velocity, found.Spin, kickTime);
        simulator.Run(ref again, 0.005, found.Time, StopAt.Time, new StepLog());
        Assert.InRange(Vector3d.Distance(again.Position, request.Target), 0, Tolerance + 1e-5);
    }

    [Fact]
    public void A_scene_with_nothing_to_meet_says_so()
    {
        var aimer = new BankShotAimer(Scene.Measured with { Ground = Ground.None });
        var request = new AimRequest { From = new Vector3d(0, 1, 0), Target = new Vector3d(0, 1, -10), Speed = 22 };
        var refused = Assert.Throws<ArgumentOutOfRangeException>(() => aimer.Find(request, "ground"));
        Assert.Contains("aim.after[0] is ground; allowed: none", refused.Message, StringComparison.Ordinal);
    }

    /// <summary>Fast kicks are ruled by the air: long steps would take a miss for a hit.</summary>
    [Fact]
    public void A_fast_kick_is_flown_in_short_steps()
    {
        var simulator = new Simulator(Scene);
        var aimer = new BankShotAimer(Scene);
        int hits = 0;
        for (int i = 0; i < 8; i++)
        {
            var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(-2 + (0.3 * i), 0.8, -18), Speed = 400, Tolerance = Tolerance };
            AimResult found = aimer.Find(request, "wall");
            if (found.Status != AimStatus.Hit)
            {
                continue;
            }

            hits++;
            var path = new Trajectory(4096);
            simulator.LookAhead(simulator.Launch(request.From, found.Velocity, found.Spin), new LookAheadRequest { Duration = found.Time + 0.01, TimeStep = 0.0005, StopAt = StopAt.Time }, path);
            double closest = Enumerable.Range(-400, 801).Min(k => Vector3d.Distance(path.PositionAt(found.Time + (1e-5 * k)), request.Target));
            Assert.InRange(closest, 0, 1.05 * Tolerance);
        }

        Assert.NotEqual(0, hits);
    }

    /// <summary>Requests for where random kicks come after they have met these things, and no more.</summary>
    private static List<AimRequest> Draw(double least, double most, string[] after, Scene? scene = null)
    {
        var random = new SeededRandom(29L);
        var set = new BankShotSet(new Simulator(scene ?? Scene), after) { Azimuth = (least, most) };
        return [.. Enumerable.Range(0, Requests).Select(_ => set.Draw(random))];
    }

    private static BallEvent[] Impacts(Trajectory path) => [.. path.Events.Span.ToArray().Where(e => e.Kind == BallEventKind.Impact)];
}
