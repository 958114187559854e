namespace Football.Physics.Tests.Predictors;

/// <summary>Kicks after bounces and off things: how much it takes to find them, and what they do.</summary>
public sealed class BankShotTests
{
    private const double Tolerance = 1e-3;

    /// <summary>More simulations than this are those of a search over all directions.</summary>
    private const int Few = 60;

    private static readonly Scene Scene = Scene.Measured with
    {
        Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(-9, 0, 0), new Vector3d(1, 0, 0)), Surface = Surface.Board }],
        Goals = [new Goal { Center = new Vector3d(0, 0, -14), Facing = new Vector3d(0, 0, 1), Surface = Surface.MeasuredFrame, HasNet = false }],
    };

    /// <summary>Kicks by speed, elevation and azimuth (to the left), degrees, and what they meet.</summary>
    public static TheoryData<double, double, double, string[]> Kicks => new()
    {
        { 18, 12, 25, ["ground"] },
        { 20, 20, 20, ["ground"] },
        { 16, 9, -30, ["ground", "ground"] },
        { 22, 9, 45, ["wall"] },
        { 17, 25, 60, ["wall"] },
        { 22, 12, 55, ["wall", "ground"] },
        { 18, 10, 48, ["ground", "wall"] },
        { 20, 7, 14.9, ["right post"] },
        { 24, 7, -14.9, ["left post"] },
        { 22, 12.2, 3, ["crossbar", "ground"] },
    };

    [Theory]
    [MemberData(nameof(Kicks))]
    public void A_kick_that_is_known_is_found_again_in_few_simulations_and_does_what_is_asked(double speed, double elevation, double azimuth, string[] after)
    {
        AimRequest request = Request(speed, elevation, azimuth, after);
        var aimer = new BankShotAimer(Scene);
        AimResult found = aimer.Find(request, after);
        Assert.Equal(AimStatus.Hit, found.Status);
        Assert.InRange(found.Simulations, 1, Few);
        Assert.InRange(found.Miss, 0, Tolerance);

        // Flown again in steps of a fourth, it meets just these, and then the target.
        var simulator = new Simulator(Scene);
        BallState again = simulator.Launch(request.From, found.Velocity, found.Spin);
        var path = new Trajectory(1024);
        simulator.LookAhead(in again, new LookAheadRequest { Duration = found.Time, TimeStep = 0.005, StopAt = StopAt.Time }, path);
        Assert.Equal(after, [.. Impacts(path).Select(e => simulator.NameOf(e.Thing)!)]);
        Assert.InRange(Vector3d.Distance(path.Final.Position, request.Target), 0, Tolerance + 1e-5);
        Assert.Equal(request.Speed, found.Velocity.Length, 9);
    }

    [Theory]
    [MemberData(nameof(Kicks))]
    public void An_aimer_that_is_warm_allocates_nothing_and_finds_the_same(double speed, double elevation, double azimuth, string[] after)
    {
        AimRequest request = Request(speed, elevation, azimuth, after);
        var aimer = new BankShotAimer(Scene);
        AimResult first = aimer.Find(request, after);
        AimResult last = default;
        Assert.Equal(0, Allocation.Of(() => last = aimer.Find(request, after)));
        Assert.Equal(first.Velocity, last.Velocity);
        Assert.Equal(first.Simulations, last.Simulations);
    }

    [Fact]
    public void Random_requests_that_have_an_answer_are_met_nearly_all()
    {
        var random = new SeededRandom(29L);
        var aimer = new BankShotAimer(Scene);
        int hits = 0;
        int few = 0;
        const int requests = 60;
        for (int i = 0; i < requests; i++)
        {
            string[] after = (i % 3) switch { 0 => ["wall"], 1 => ["right post"], _ => ["ground"] };
            (double least, double most) = (i % 3) switch { 0 => (20.0, 70.0), 1 => (13.0, 18.0), _ => (20.0, 60.0) };
            AimRequest? request = null;
            while (request is null)
            {
                request = TryRequest(random.Uniform(15, 26), random.Uniform(4, 30), random.Uniform(least, most), after);
            }

            AimResult found = aimer.Find(request, after);
            hits += found.Status == AimStatus.Hit ? 1 : 0;
            few += found.Simulations <= Few ? 1 : 0;
        }

        Assert.InRange(hits, requests - 1, requests);
        Assert.InRange(few, requests - 3, requests);
    }

    [Fact]
    public void A_place_behind_the_wall_is_not_converged()
    {
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(-15, 1, -10), Speed = 22, Tolerance = Tolerance };
        AimResult found = new BankShotAimer(Scene).Find(request, "wall");
        Assert.Equal(AimStatus.NotConverged, found.Status);
        Assert.True(found.Miss > 1);
    }

    [Fact]
    public void A_wall_that_moves_is_met_where_it_is_then()
    {
        Scene scene = Scene.Measured with
        {
            Obstacles = [new Obstacle { Name = "wall", Shape = new PlaneShape(new Vector3d(-9, 0, 0), new Vector3d(1, 0, 0)), Velocity = new Vector3d(0.5, 0, 0), Surface = Surface.Board }],
        };
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(-4, 0.6, -14), Speed = 22, Tolerance = Tolerance };
        AimResult found = new BankShotAimer(scene).Find(request, "wall");
        Assert.Equal(AimStatus.Hit, found.Status);
        var simulator = new Simulator(scene);
        BallState again = simulator.Launch(request.From, found.Velocity, found.Spin);
        simulator.Run(ref again, 0.005, found.Time, StopAt.Time, new StepLog());
        Assert.InRange(Vector3d.Distance(again.Position, request.Target), 0, Tolerance + 1e-5);
    }

    private static AimRequest Request(double speed, double elevation, double azimuth, string[] after)
    {
        AimRequest? request = TryRequest(speed, elevation, azimuth, after);
        Assert.NotNull(request);
        return request;
    }

    /// <summary>A request for where a kick comes after it has met these things; null where it meets others.</summary>
    private static AimRequest? TryRequest(double speed, double elevation, double azimuth, string[] after)
    {
        var from = new Vector3d(0, 0.11, 0);
        double angle = azimuth * Math.PI / 180;
        double up = elevation * Math.PI / 180;
        var velocity = speed * new Vector3d(-Math.Sin(angle) * Math.Cos(up), Math.Sin(up), -Math.Cos(angle) * Math.Cos(up));
        var simulator = new Simulator(Scene);
        BallState kick = simulator.Launch(from, velocity, KickSpin.Vector(velocity, 5, -8));
        var path = new Trajectory(1024);
        simulator.LookAhead(in kick, new LookAheadRequest { Duration = 5, TimeStep = 0.01, StopAt = StopAt.Time }, path);
        BallEvent[] impacts = Impacts(path);
        if (impacts.Length <= after.Length || !impacts.Take(after.Length).Select(e => simulator.NameOf(e.Thing)).SequenceEqual(after))
        {
            return null;
        }

        double begin = impacts[after.Length - 1].Time;
        Vector3d target = path.PositionAt(begin + (0.6 * (impacts[after.Length].Time - begin)));
        return new AimRequest { From = from, Target = target, Speed = speed, TopSpin = 5, SideSpin = -8, Tolerance = Tolerance };
    }

    private static BallEvent[] Impacts(Trajectory path) => [.. path.Events.Span.ToArray().Where(e => e.Kind == BallEventKind.Impact)];
}
