using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>The colliders of a game engine, found by its sphere cast.</summary>
public sealed class EngineColliderTests
{
    private static readonly SolverSettings s_rk4 = Flight.With(Integrator.Rk4);

    public static TheoryData<string> Shapes => ["sphere", "capsule", "box", "plane", "moving sphere", "round", "flat"];

    [Theory]
    [ProfileData(Member = nameof(Shapes))]
    public void A_ball_bounces_off_an_engine_s_collider_at_the_same_instant_as_off_our_own_shape(Profile profile, string kind)
    {
        IShape shape = kind switch
        {
            "capsule" => new CapsuleShape(new Vector3d(0.05, 0, -6), new Vector3d(0.05, 2.5, -6), 0.2),
            "box" => new BoxShape(new Vector3d(0, 1, -6), new Vector3d(0.5, 1, 0.2), Quaterniond.FromAxisAngle(Vector3d.Up, 0.3)),
            "plane" or "flat" => new PlaneShape(new Vector3d(0, 0, -6), new Vector3d(0.2, 0.1, 1)),
            _ => new SphereShape(new Vector3d(0.1, 1.2, -6), 0.4),
        };
        Vector3d velocity = kind == "moving sphere" ? new Vector3d(0.3, 0.1, 4) : Vector3d.Zero;
        Scene own = profile.Scene() with { Obstacles = [new Obstacle { Name = "thing", Shape = shape, Velocity = velocity }] };
        var engine = new ShapesAsEngine();
        engine.Add("thing", shape, velocity, isKnown: kind is not ("round" or "flat"));
        BallState expected = Played(new Simulator(own, s_rk4), engine, out List<string> events);
        BallState actual = Played(new Simulator(profile.Scene() with { EngineColliders = engine }, s_rk4), engine, out List<string> again);
        Assert.Contains(events, happened => happened.StartsWith("Impact thing", StringComparison.Ordinal));
        Assert.Equal(events, again);
        Assert.Equal(0, (expected.Position - actual.Position).Length, 1e-7);
        Assert.Equal(0, (expected.Spin - actual.Spin).Length, 1e-6);
    }

    [Fact]
    public void Nothing_thin_is_passed_through_however_fast_the_ball_and_however_long_the_step()
    {
        for (int i = 0; i < 60; i++)
        {
            var engine = new ShapesAsEngine();
            engine.Add("wire", new CapsuleShape(new Vector3d(-3, 1, -20), new Vector3d(3, 1, -20), 0.002));
            var simulator = new Simulator(Scene.Vacuum with { EngineColliders = engine, Ground = Ground.None, Gravity = 0 }, s_rk4);
            BallState state = simulator.Launch(new Vector3d(0, 1 + (0.001 * i), 0), new Vector3d(0.5, 0, -60 - i), Vector3d.Zero);
            var log = new StepLog();
            for (int step = 0; step < 12; step++)
            {
                simulator.Step(ref state, 0.04, log);
            }

            Assert.Equal(1, log.Events.Count);
            Assert.Equal("wire", simulator.NameOf(log.Events[0].ColliderIndex));
        }
    }

    /// <summary>Events beyond the maximum push out older ones. Those that are left still name the colliders, of which a step finds only one.</summary>
    [Fact]
    public void A_log_that_is_full_still_names_the_colliders()
    {
        var engine = new ShapesAsEngine();
        engine.Add("left", new PlaneShape(Vector3d.Zero, new Vector3d(1, 0, 0)));
        engine.Add("right", new PlaneShape(new Vector3d(3, 0, 0), new Vector3d(-1, 0, 0)));
        var simulator = new Simulator(new Scene { EngineColliders = engine, Ground = Ground.None, Gravity = 0, Forces = ForceSet.None }, s_rk4);
        BallState state = simulator.Launch(new Vector3d(1, 0, 0), new Vector3d(40, 0, 0), Vector3d.Zero);
        var log = new StepLog(4, 32);
        while (log.Events.Dropped < 4)
        {
            simulator.Step(ref state, 0.02, log);
            foreach (ref readonly BallEvent impact in log.Events)
            {
                Assert.Equal(impact.Normal.X > 0 ? "left" : "right", simulator.NameOf(impact.ColliderIndex));
            }
        }
    }

    [Fact]
    public void A_flight_that_bends_meets_what_its_chord_misses()
    {
        var engine = new ShapesAsEngine();
        engine.Add("branch", new SphereShape(new Vector3d(0, 1.7, -5), 0.05));
        Scene scene = Scene.Vacuum with { EngineColliders = engine };
        var simulator = new Simulator(scene, s_rk4);
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0, 0.5 * 9.81 * 0.8, -12.5), Vector3d.Zero);
        var log = new StepLog();
        simulator.Step(ref state, 0.8, log);
        Assert.Equal("branch", simulator.NameOf(log.Events[0].ColliderIndex));
    }

    [Theory]
    [ProfileData]
    public void A_ball_lies_on_an_engine_s_collider_until_that_is_gone(Profile profile)
    {
        var engine = new ShapesAsEngine();
        engine.Add("table", new BoxShape(new Vector3d(0, 1, 0), new Vector3d(1, 0.1, 1)));
        var simulator = new Simulator(profile.Scene() with { EngineColliders = engine }, s_rk4);
        BallState state = simulator.Launch(new Vector3d(0, 1.5, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, 0.02, 10, StopAt.Rest, log);
        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.Equal(1.1 + Flight.Radius, state.Position.Y, 1e-9);
        engine.RemoveAll();
        log.Clear();
        simulator.Step(ref state, 0.02, log);
        Assert.Equal(BallEventKind.ContactEnd, log.Events[0].Kind);
        Assert.Equal(MotionState.Airborne, state.Motion);
    }

    [Theory]
    [ProfileData]
    public void A_step_among_an_engine_s_colliders_allocates_nothing(Profile profile)
    {
        var engine = new ShapesAsEngine();
        engine.Add("wall", new PlaneShape(new Vector3d(0, 0, -4), new Vector3d(0, 0, 1)));
        engine.Add("post", new CapsuleShape(new Vector3d(0.3, 0, -2), new Vector3d(0.3, 2.5, -2), 0.06));
        engine.Add("hill", new SphereShape(new Vector3d(-0.5, -1, -3), 1.4), isKnown: false);
        var simulator = new Simulator(profile.Scene() with { EngineColliders = engine }, s_rk4);
        var log = new StepLog();
        Assert.Equal(0, Allocation.Of(() =>
        {
            BallState state = simulator.Launch(new Vector3d(0.05, 1, 0), new Vector3d(0.1, 2, -20), new Vector3d(20, 30, 0));
            for (int step = 0; step < 200; step++)
            {
                log.Clear();
                simulator.Step(ref state, 0.01, log);
            }
        }));
    }

    [Fact]
    public void Colliders_that_are_always_new_are_met_one_after_the_other()
    {
        var engine = new ShapesAsEngine();
        var simulator = new Simulator(Scene.Vacuum with { EngineColliders = engine, Gravity = 0 }, s_rk4);
        for (int i = 0; i < 600; i++)
        {
            engine.RemoveAll();
            engine.Add($"pole {i}", new SphereShape(new Vector3d(0, 5, -1), 0.2));
            BallState state = simulator.Launch(new Vector3d(0, 5, 0), new Vector3d(0, 0, -20), Vector3d.Zero);
            var log = new StepLog();
            simulator.Step(ref state, 0.1, log);
            Assert.Equal($"pole {i}", simulator.NameOf(log.Events[0].ColliderIndex));
        }
    }

    /// <summary>A place in the table is good for a step; events call a collider by its number, whatever was found before.</summary>
    [Fact]
    public void A_collider_that_comes_back_has_its_number()
    {
        var engine = new Kept();
        var simulator = new Simulator(new Scene { EngineColliders = engine, Gravity = 0 }, s_rk4);
        EngineCollider[] all = [.. Enumerable.Range(0, 300).Select(i => new EngineCollider($"pole {i}", new SphereShape(new Vector3d(0, 5, -1), 0.2)))];
        var often = new EngineCollider("often", new SphereShape(new Vector3d(0, 5, 1), 0.2));
        int place = -1;
        foreach (int i in Enumerable.Range(0, 300).Concat(Enumerable.Range(0, 300)).Concat([7, 7, 290, 7]))
        {
            Assert.Equal($"pole {i}", simulator.NameOf(Meet(all[i], -20)));
            int its = Meet(often, 20);
            Assert.Equal("often", simulator.NameOf(its));
            Assert.True(place < 0 || its == place);
            place = its;
        }

        int Meet(EngineCollider collider, double speed)
        {
            engine.Near = collider;
            BallState state = simulator.Launch(new Vector3d(0, 5, 0), new Vector3d(0, 0, speed), Vector3d.Zero);
            var log = new StepLog();
            simulator.Step(ref state, 0.1, log);
            return log.Events[0].ColliderIndex;
        }
    }

    /// <summary>An engine that finds one collider.</summary>
    private sealed class Kept : IEngineColliders
    {
        public EngineCollider? Near { get; set; }

        public double Time => 0;

        public double MaximumSpeed => 0;

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            Near!.MoveTo(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
            hits.Add(Near);
        }
    }

    [Fact]
    public void An_engine_is_more_than_the_ground_alone()
    {
        Assert.True(new Simulator(Scene.Published).World.IsLevelGroundAlone);
        Assert.False(new Simulator(Scene.Published with { EngineColliders = new ShapesAsEngine() }).World.IsLevelGroundAlone);
    }

    [Fact]
    public void What_an_engine_says_wrong_is_refused_by_name()
    {
        var known = new EngineCollider("post", new SphereShape(Vector3d.Zero, 1));
        var mesh = new EngineCollider("mesh");
        Assert.Contains("post", Assert.Throws<InvalidOperationException>(() => known.TouchAt(Vector3d.Zero, Vector3d.Up, Vector3d.Zero)).Message, StringComparison.Ordinal);
        Assert.Contains("mesh", Assert.Throws<InvalidOperationException>(() => mesh.MoveTo(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero)).Message, StringComparison.Ordinal);
        Assert.Contains("normal", Assert.Throws<ArgumentOutOfRangeException>(() => mesh.TouchAt(Vector3d.Zero, Vector3d.Zero, Vector3d.Zero)).Message, StringComparison.Ordinal);
        Assert.Contains("curvature", Assert.Throws<ArgumentOutOfRangeException>(() => mesh.TouchAt(Vector3d.Zero, Vector3d.Up, Vector3d.Zero, -1)).Message, StringComparison.Ordinal);
        Assert.Contains("velocity", Assert.Throws<ArgumentOutOfRangeException>(() => known.MoveTo(Vector3d.Zero, Quaterniond.Identity, new Vector3d(2000, 0, 0), Vector3d.Zero)).Message, StringComparison.Ordinal);
    }

    private static BallState Played(Simulator simulator, ShapesAsEngine engine, out List<string> events)
    {
        engine.Time = 0;
        BallState state = simulator.Launch(new Vector3d(0, 1, 0), new Vector3d(0.1, 2.5, -22), new Vector3d(10, 20, -5));
        var log = new StepLog();
        events = [];
        for (int step = 0; step < 60; step++)
        {
            engine.Time = state.Time;
            simulator.Step(ref state, 0.02, log);
        }

        for (int i = 0; i < log.Events.Count; i++)
        {
            BallEvent happened = log.Events[i];
            events.Add($"{happened.Kind} {simulator.NameOf(happened.ColliderIndex)} {Math.Round(happened.Time, 8)}");
        }

        return state;
    }
}
