namespace FootballPhysics.Tests.Things;

/// <summary>Objects that return more than they get, and say how much.</summary>
public sealed class BumperTests
{
    private const double Radius = 0.11;

    private static readonly SurfaceMaterial s_plain = SurfaceMaterial.GoalFrame with { RestitutionSpeedScale = double.PositiveInfinity, ImpactFriction = 0 };

    private static Scene Against(SurfaceMaterial surface, double mass = double.PositiveInfinity, Vector3d velocity = default) => new()
    {
        Gravity = 0,
        Ground = Ground.None,
        Forces = ForceSet.None,
        Obstacles = [new Obstacle { Name = "bumper", Shape = new BoxShape(new Vector3d(0, 0, -2), new Vector3d(1, 1, 0.5)), Surface = surface, Mass = mass, Velocity = velocity }],
    };

    private static BallEvent Hit(Scene scene, Vector3d velocity)
    {
        var simulator = new Simulator(scene);
        var log = new StepLog();
        BallState s = simulator.Launch(new Vector3d(0, 0, -1.385), velocity, Vector3d.Zero);
        simulator.Run(ref s, 0.01, 10, StopAt.Impact, log);
        return Assert.Single(log.Events.Span.ToArray());
    }

    [Theory]
    [InlineData(0.8, 0, 4, 3.2)]
    [InlineData(1, 0, 4, 4)]
    [InlineData(3, 0, 4, 12)]
    [InlineData(0.8, 6, 4, 6)]
    [InlineData(0, 0.5, 0.001, 0.5)]
    [InlineData(0.8, 2, 4, 3.2)]
    public void The_ball_leaves_as_fast_as_the_surface_says(double restitution, double least, double speed, double expected)
    {
        BallEvent hit = Hit(Against(s_plain with { NormalRestitution = restitution, MinimumExitSpeed = least }), new Vector3d(0, 0, -speed));
        double added = Math.Max(0, 0.5 * 0.43 * ((expected * expected) - (speed * speed)));
        Assert.Equal(expected, hit.Velocity.Z, 12);
        Assert.Equal(added, hit.AddedEnergy, 12);
        Assert.Equal(-added, Math.Min(0, new Simulator().ImpactOf(in hit).EnergyLost), 12);
    }

    /// <summary>One that weighs something, and one that moves: relative to it, with the energy of both.</summary>
    [Theory]
    [InlineData(2.0, 0)]
    [InlineData(0.43, 0)]
    [InlineData(2.0, 3)]
    public void A_bumper_with_a_mass_gets_the_opposite_impulse_and_both_get_the_energy(double mass, double coming)
    {
        var towards = new Vector3d(0, 0, coming);
        BallEvent hit = Hit(Against(s_plain with { NormalRestitution = 2 }, mass, towards), new Vector3d(0, 0, -5));
        Vector3d impulse = new Simulator().ImpactOf(in hit).Impulse;
        Vector3d after = towards - (impulse / mass);
        Assert.Equal(2 * (5 + coming), (hit.Velocity - after).Z, 9);
        double energy = (0.5 * 0.43 * (hit.Velocity.LengthSquared - 25)) + (0.5 * mass * (after.LengthSquared - towards.LengthSquared));
        Assert.Equal(energy, hit.AddedEnergy, 9);
        Assert.True(hit.AddedEnergy > 1);
    }

    /// <summary>The speeds are relative to a bumper that moves without a mass.</summary>
    [Theory]
    [InlineData(3)]
    [InlineData(-2)]
    public void A_bumper_that_moves_adds_energy_in_its_own_frame(double coming)
    {
        BallEvent hit = Hit(Against(s_plain with { MinimumExitSpeed = 9 }, velocity: new Vector3d(0, 0, coming)), new Vector3d(0, 0, -5));
        Assert.Equal(9 + coming, hit.Velocity.Z, 12);
        Assert.Equal(0.5 * 0.43 * (81 - ((5 + coming) * (5 + coming))), hit.AddedEnergy, 9);
    }

    /// <summary>Between two bumpers the ball gains speed up to a bound, and stays finite.</summary>
    [Fact]
    public void Two_bumpers_make_no_ball_faster_than_1000_metres_a_second()
    {
        Scene one = Against(s_plain with { NormalRestitution = 3, MinimumExitSpeed = 1 });
        Scene scene = one with { Obstacles = [one.Obstacles[0], one.Obstacles[0] with { Shape = new BoxShape(new Vector3d(0, 0, 2), new Vector3d(1, 1, 0.5)) }] };
        var simulator = new Simulator(scene);
        var log = new StepLog();
        BallState s = simulator.Launch(Vector3d.Zero, new Vector3d(0, 0, -2), Vector3d.Zero);
        double fastest = 0;
        for (int i = 0; i < 400; i++)
        {
            log.Clear();
            simulator.Step(ref s, 0.01, log);
            fastest = Math.Max(fastest, s.Velocity.Length);
            Assert.InRange(s.Position.Z, -1.39, 1.39);
        }

        Assert.Equal(1000, fastest, 6);
        Assert.Equal(0, log.StalledSteps);
    }

    /// <summary>A pinball table: a step gains no more than its events say.</summary>
    [Fact]
    public void No_step_gains_more_than_its_events_say()
    {
        var posts = new List<Obstacle>();
        for (int i = 0; i < 12; i++)
        {
            posts.Add(new Obstacle
            {
                Name = FormattableString.Invariant($"post {i}"),
                Shape = new CapsuleShape(new Vector3d((i % 4) - 1.5, 0, -1.5 - (i / 4)), new Vector3d((i % 4) - 1.5, 1, -1.5 - (i / 4)), 0.38),
                Surface = SurfaceMaterial.GoalFrame with { NormalRestitution = 0.5 + (0.2 * i), MinimumExitSpeed = 0.5 * i },
            });
        }

        Scene scene = new() { Obstacles = posts, Forces = new ForceSet { Buoyancy = false } };
        BallProperties ball = scene.Ball;
        int bumps = 0;
        for (int seed = 0; seed < 30; seed++)
        {
            var random = new Random(seed);
            var simulator = new Simulator(scene);
            BallState s = simulator.Launch(new Vector3d(random.NextDouble() - 0.5, Radius, 0), new Vector3d((4 * random.NextDouble()) - 2, 2 * random.NextDouble(), -4 - (8 * random.NextDouble())), Vector3d.Zero);
            var log = new StepLog();
            double Energy() => (0.5 * ball.Mass * s.Velocity.LengthSquared) + (0.5 * ball.MomentOfInertia * s.Spin.LengthSquared) + (ball.Mass * 9.81 * s.Position.Y);
            for (int i = 0; i < 1000 && s.Motion != MotionState.Rest; i++)
            {
                double before = Energy();
                log.Clear();
                simulator.Step(ref s, 0.01, log);
                double added = log.Events.Span.ToArray().Sum(e => e.AddedEnergy);
                bumps += log.Events.Span.ToArray().Count(e => e.AddedEnergy > 0);
                Assert.True(Energy() <= before + added + 1e-6, $"{seed}: {before} + {added} to {Energy()}");
            }

        }

        Assert.True(bumps > 15, $"{bumps} bumps");
    }

    [Fact]
    public void The_ground_and_other_balls_add_nothing()
    {
        static string Refusal(Func<object> make) => Assert.Throws<ArgumentOutOfRangeException>(make).Message;
        SurfaceMaterial bumper = s_plain with { NormalRestitution = 2, MinimumExitSpeed = 1 };
        var pattern = new SurfaceRectangles((new Vector3d(-1, 0, -1), new Vector3d(1, 0, 1), bumper));
        Assert.StartsWith("obstacles[0].surface.normalRestitution is 3.5; allowed: 0 … 3.", Refusal(() => new Simulator(Against(bumper with { NormalRestitution = 3.5 }))), StringComparison.Ordinal);
        Assert.StartsWith("obstacles[0].surface.minimumExitSpeed is -1; allowed: 0 … 1000.", Refusal(() => new Simulator(Against(bumper with { MinimumExitSpeed = -1 }))), StringComparison.Ordinal);
        Assert.StartsWith("ballContact.normalRestitution is 2; allowed: 0 … 1.", Refusal(() => new BallGroup(new Simulator(), 2, bumper)), StringComparison.Ordinal);
        Assert.StartsWith("ballContact.minimumExitSpeed is 1; allowed: 0 … 0.", Refusal(() => new BallGroup(new Simulator(), 2, bumper with { NormalRestitution = 1 })), StringComparison.Ordinal);
        Assert.StartsWith("ground.pattern.surfaces[0].normalRestitution is 2; allowed: 0 … 1.", Refusal(() => new Simulator(new Scene { Ground = new Ground { Material = SurfaceMaterial.DryTurf, Pattern = pattern } })), StringComparison.Ordinal);
    }
}
