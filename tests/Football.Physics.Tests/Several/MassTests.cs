using FootballPhysics.Simulation;

namespace FootballPhysics.Tests.Several;

/// <summary>Bodies, obstacles and an engine's colliders that weigh something.</summary>
public sealed class MassTests
{
    [Fact]
    public void An_infinite_mass_is_none_to_the_bit()
    {
        BallState[] ends = [.. new[] { double.PositiveInfinity, 1e300 }.Select(mass =>
        {
            var bodies = new KinematicBodies();
            bodies.Add("leg", new CapsuleShape(new Vector3d(0, 0.15, 0), new Vector3d(0, 0.9, 0), 0.1), mass: mass);
            var simulator = new Simulator(Scene.Default with { Bodies = bodies });
            BallState state = simulator.Launch(new Vector3d(0.03, 0.4, -3), new Vector3d(0, 1, 12), new Vector3d(20, 30, 0));
            for (int i = 0; i < 200; i++)
            {
                simulator.Step(ref state, 0.01, new StepLog());
            }

            return state;
        })];
        Assert.True(Snapshot.Same(in ends[0], in ends[1]));
    }

    [Fact]
    public void A_body_goes_on_with_what_the_impact_left_it_and_the_event_tells_the_impulse()
    {
        var bodies = new KinematicBodies();
        KinematicBody head = bodies.Add("head", BodyKind.Head);
        head.MoveTo(new Vector3d(0, 1.7, 0), new Vector3d(0, 0, 1), 0);
        var simulator = new Simulator(Scene.Default with { Bodies = bodies });
        BallState ball = simulator.Launch(new Vector3d(0, 1.75, 2), new Vector3d(0, 0.5, -14), default);
        var log = new StepLog();
        simulator.Run(ref ball, 0.01, 1, StopAt.Impact, log);
        BallEvent hit = log.Events[log.Events.Count - 1];
        Vector3d impulse = simulator.ImpactOf(in hit).Impulse;
        Assert.Equal("head", simulator.NameOf(hit.ColliderIndex));
        Assert.InRange(Vector3d.Distance(head.Velocity, new Vector3d(0, 0, 1) - (impulse / 5)), 0, 1e-14);
        Assert.Equal(hit.Time, head.Time);

        // Off it by the restitution of the two together, which falls with the speed from that at 6 m/s: e times what came.
        double before = Vector3d.Dot(hit.VelocityBefore - new Vector3d(0, 0, 1), hit.Normal);
        double after = Vector3d.Dot(hit.Velocity - head.Velocity, hit.Normal);
        Assert.Equal(-SurfaceMaterial.Head.NormalRestitution * Math.Sqrt((1 + (36.0 / 900)) / (1 + (before * before / 900))) * before, after, 1e-9);
    }

    [Fact]
    public void An_obstacle_with_a_mass_is_pushed_by_steps_and_not_by_looks_and_comes_back()
    {
        var scene = Scene.Default with { Obstacles = [new Obstacle { Name = "cone", Shape = BodyKind.Cone.Shape, Mass = 0.3 }] };
        var simulator = new Simulator(scene);
        BallState start = simulator.Launch(new Vector3d(0, 0.11, 2), new Vector3d(0, 0, -10), default);
        var path = new Trajectory();
        simulator.LookAhead(in start, new LookAheadRequest { TimeStep = 0.01, Duration = 1 }, path);
        BallState foreseen = path.Final;
        new Aimer(simulator).Find(new AimRequest { From = new Vector3d(0, 0.11, 2), Target = new Vector3d(0, 0.5, -8) });
        BallState ball = start;
        simulator.Run(ref ball, 0.01, 1, StopAt.Time, new StepLog());
        Assert.True(Snapshot.Same(in foreseen, in ball));

        // It has gone: the same again finds it elsewhere, until it is put back.
        BallState again = start;
        simulator.Run(ref again, 0.01, 1, StopAt.Time, new StepLog());
        Assert.False(Snapshot.Same(in again, in ball));
        simulator.ResetObstacles();
        again = start;
        simulator.Run(ref again, 0.01, 1, StopAt.Time, new StepLog());
        Assert.True(Snapshot.Same(in again, in ball));
    }

    /// <summary>Hit twice within one time of the engine: the second time it comes as the first left it, whenever it is found again.</summary>
    [Fact]
    public void An_engines_collider_gives_way_until_its_time_goes_on()
    {
        double[] speeds = [.. new[] { 0.5, double.PositiveInfinity }.Select(mass =>
        {
            var engine = new OneSphere(mass);
            var simulator = new Simulator(Scene.Default with { EngineColliders = engine });
            var group = new BallGroup(simulator, 2);
            BallState[] balls =
            [
                simulator.Launch(new Vector3d(0, 1.5, 0.7), new Vector3d(0, 0, -12), default),
                simulator.Launch(new Vector3d(0, 1.5, 1.1), new Vector3d(0, 0, -11), default),
            ];
            group.Step(balls, 0.1, new StepLog());
            return balls[1].Velocity.Length;
        })];
        Assert.True(speeds[0] < speeds[1]);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    [InlineData(double.NaN)]
    public void A_mass_that_is_none_is_refused_by_name(double mass)
    {
        var shape = new SphereShape(Vector3d.Zero, 0.2);
        Assert.StartsWith("mass", Assert.Throws<ArgumentOutOfRangeException>(() => new KinematicBodies().Add("a", shape, mass: mass)).Message, StringComparison.Ordinal);
        Assert.StartsWith("engineCollider.mass", Assert.Throws<ArgumentOutOfRangeException>(() => new EngineCollider("a", shape) { Mass = mass }).Message, StringComparison.Ordinal);
        Assert.StartsWith(
            "obstacles[0].mass",
            Assert.Throws<ArgumentOutOfRangeException>(() => new Simulator(Scene.Default with { Obstacles = [new Obstacle { Shape = shape, Mass = mass }] })).Message,
            StringComparison.Ordinal);
    }

    /// <summary>MoveBodies puts colliders where the game has them, so the pushes of earlier ticks are undone. Without it, a push lasts until the engine's time advances.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_push_ends_when_the_game_moves_its_colliders(bool moves)
    {
        var engine = new OneSphere(2);
        var runner = new FixedStepRunner(new Simulator(Scene.Default with { EngineColliders = engine }), 0.01) { MoveBodies = moves ? _ => { } : null };
        runner.Restore(0, runner.Simulator.Launch(new Vector3d(0, 1.5, -0.5), new Vector3d(0, 0, 15), Vector3d.Zero));
        runner.Step();
        Vector3d pushed = engine.Sphere.PushSoFar.Motion.Velocity;
        Assert.True(pushed.Z > 1);
        runner.Step();
        Assert.Equal(moves ? Vector3d.Zero : pushed, engine.Sphere.PushSoFar.Motion.Velocity);
    }

    /// <summary>If all balls share all objects, each ball does; after that, no ball does.</summary>
    [Fact]
    public void Shares_are_filled_and_cleared()
    {
        var simulator = new Simulator(new Scene());
        var shares = new PushShares(new PushedMotions(simulator.World), [simulator, simulator], new BallState[2]);
        Assert.False(shares[0] || shares[1]);
        shares.Fill();
        Assert.True(shares[0] && shares[1]);
        shares.Clear();
        Assert.False(shares[0] || shares[1]);
    }

    private sealed class OneSphere(double mass) : IEngineColliders
    {
        private readonly EngineCollider _sphere = new("bin", new SphereShape(Vector3d.Zero, 0.3), SurfaceMaterial.GoalFrame) { Mass = mass };

        public EngineCollider Sphere => _sphere;

        public double Time => 0;

        public double MaximumSpeed => 30;

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            _sphere.MoveTo(new Vector3d(0, 1.5, 0), Quaterniond.Identity, default, default);
            hits.Add(_sphere);
        }
    }
}
