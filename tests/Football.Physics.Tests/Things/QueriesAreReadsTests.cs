using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Queries change nothing that a match can see: among bodies, obstacles and an engine's colliders that the ball pushes.</summary>
public sealed class QueriesAreReadsTests
{
    private const double Tick = 1.0 / 60;

    private static readonly SolverSettings s_rk4 = Flight.With(Integrator.Rk4);

    public static TheoryData<string, string> Looks
    {
        get
        {
            var data = new TheoryData<string, string>();
            foreach (string crate in (string[])["engine", "obstacle", "body"])
            {
                foreach (string look in (string[])["look-ahead", "other simulator", "cache", "interception", "pass", "group", "forces"])
                {
                    data.Add(crate, look);
                }
            }

            return data;
        }
    }

    /// <summary>A shot hits a crate that gives way, with and without a query in every tick: the ball ends at the same bits.</summary>
    [Theory]
    [MemberData(nameof(Looks))]
    public void A_query_in_every_tick_leaves_the_match_as_it_is(string crate, string look)
    {
        Assert.Equal(Play(crate, look, queries: false), Play(crate, look, queries: true));
    }

    /// <summary>A query between two impacts of one time of the engine: the push of the match counts on, that of the query does not.</summary>
    [Fact]
    public void A_push_of_the_match_outlasts_a_look_ahead_that_pushes_on()
    {
        Assert.Equal(Far(looks: false), Far(looks: true));

        static ulong Far(bool looks)
        {
            // The engine's time stands still, so that the first push counts for the whole play.
            var engine = new Crate(4) { Time = 0 };
            var simulator = new Simulator(Scene.Vacuum with { EngineColliders = engine, Ground = Ground.None, Gravity = 0 }, s_rk4);
            BallState ball = simulator.Launch(new Vector3d(0, 0.35, 0), new Vector3d(0, 0, -20), Vector3d.Zero);
            var log = new StepLog();
            ulong hash = 0;
            for (int i = 0; i < 3; i++)
            {
                simulator.Run(ref ball, Tick, 1, StopAt.Impact, log);
                hash = Snapshot.Hash(ball) ^ (31 * hash);
                ball = simulator.Launch(new Vector3d(0, 0.35, 0), new Vector3d(0, 0, -20), Vector3d.Zero);
                if (looks)
                {
                    simulator.LookAhead(in ball, new LookAheadRequest { Duration = 2 }, new Trajectory());
                }
            }

            Assert.Equal(3, log.Events.Impacts);
            return hash;
        }
    }

    /// <summary>A look-ahead of a group plays a step more than once; each time the ball hits the crate as the engine moves it, not as the last play has left it.</summary>
    [Theory]
    [InlineData("engine")]
    [InlineData("obstacle")]
    [InlineData("body")]
    public void A_look_ahead_of_a_step_of_a_group_pushes_an_object_once(string crate)
    {
        Simulator simulator = Hall(crate, out Crate engine);
        var group = new BallGroup(simulator, 2);
        BallState[] balls =
        [
            simulator.Launch(new Vector3d(0, 0.4, -5), new Vector3d(0.3, 1, -15), new Vector3d(0, 3, 0)),
            simulator.Launch(new Vector3d(5, 0.4, -5), new Vector3d(0.3, 1, -15), Vector3d.Zero),
        ];
        Trajectory[] paths = [new Trajectory(), new Trajectory()];
        engine.Time = 0;
        group.LookAhead(balls, new LookAheadRequest { TimeStep = 0.2, Duration = 0.2, StopAt = StopAt.Time }, paths);
        var log = new StepLog();
        group.Step(balls, 0.2, log);
        Assert.True(log.Events.Impacts > 0);
        Assert.True(Snapshot.Same(paths[0].Final, in balls[0]));
        Assert.True(Snapshot.Same(paths[1].Final, in balls[1]));
    }

    [Theory]
    [ProfileData]
    public void Neither_state_nor_events_tell_in_what_order_an_engine_s_colliders_were_found(Profile profile)
    {
        Assert.Equal(Fallen(false), Fallen(true));

        (ulong, int, string?) Fallen(bool looks)
        {
            var engine = new ShapesAsEngine();
            engine.Add("left", new BoxShape(new Vector3d(-6, 0.4, 0), new Vector3d(3.5, 0.4, 3.5)));
            engine.Add("right", new BoxShape(new Vector3d(6, 0.4, 0), new Vector3d(3.5, 0.4, 3.5)));
            var simulator = new Simulator(profile.Scene() with { EngineColliders = engine }, s_rk4);
            if (looks)
            {
                BallState left = simulator.Launch(new Vector3d(-6, 2, 0), Vector3d.Zero, Vector3d.Zero);
                simulator.LookAhead(in left, new LookAheadRequest { Duration = 2 }, new Trajectory());
            }

            BallState ball = simulator.Launch(new Vector3d(5, 1.3, 0), Vector3d.Zero, Vector3d.Zero);
            var log = new StepLog();
            simulator.Run(ref ball, Tick, 20, StopAt.Rest, log);
            Assert.Equal(MotionState.Rest, ball.Motion);
            return (Snapshot.Hash(in ball), log.Events[0].ColliderIndex, simulator.NameOf(log.Events[0].ColliderIndex));
        }
    }

    /// <summary>Two of one name have one number: which of them carries the ball its place tells, also to a simulator that has met neither.</summary>
    [Fact]
    public void A_ball_lies_on_its_own_one_of_several_colliders_of_one_name()
    {
        var engine = new ShapesAsEngine();
        engine.Add("crate", new BoxShape(new Vector3d(-0.6, 0.4, 0), new Vector3d(0.5, 0.4, 0.5)));
        engine.Add("crate", new BoxShape(new Vector3d(0.6, 0.3, 0), new Vector3d(0.5, 0.3, 0.5)));
        Scene scene = Scene.Default with { EngineColliders = engine };
        var simulator = new Simulator(scene, s_rk4);
        BallState ball = simulator.Launch(new Vector3d(0.6, 0.8, 0), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref ball, Tick, 20, StopAt.Rest, log);
        Assert.Equal(0.6 + Flight.Radius, ball.Position.Y, 1e-9);
        Assert.Equal("crate", simulator.NameOf(log.Events[0].ColliderIndex));

        BallState sent = Snapshot.Read(Bytes(in ball));
        var other = new Simulator(scene, s_rk4);
        other.Validate(in sent);
        for (int i = 0; i < 60; i++)
        {
            simulator.Step(ref ball, Tick, log);
            other.Step(ref sent, Tick, log);
        }

        Assert.Equal(MotionState.Rest, sent.Motion);
        Assert.True(Snapshot.Same(in ball, in sent));
    }

    private static byte[] Bytes(in BallState ball)
    {
        byte[] bytes = new byte[Snapshot.Size];
        Snapshot.Write(in ball, bytes);
        return bytes;
    }

    private static Simulator Hall(string crate, out Crate engine)
    {
        var bodies = new KinematicBodies();
        bodies.Add("far player", BodyKind.Player.Shape, SurfaceMaterial.Boot, 75).MoveTo(new Vector3d(60, 0, 0), Vector3d.Zero, 0);
        var box = new BoxShape(Vector3d.Zero, new Vector3d(0.35, 0.35, 0.35));
        if (crate == "body")
        {
            bodies.Add("crate", box, SurfaceMaterial.Wood, 4).MoveTo(new Vector3d(0, 0.35, -7), Vector3d.Zero, 0);
        }

        engine = new Crate(-7);
        return new Simulator(new Scene
        {
            Bodies = bodies,
            EngineColliders = crate == "engine" ? engine : null,
            Obstacles = crate == "obstacle" ? [new Obstacle { Name = "crate", Shape = new BoxShape(new Vector3d(0, 0.35, -7), new Vector3d(0.35, 0.35, 0.35)), Surface = SurfaceMaterial.Wood, Mass = 4 }] : [],
        });
    }

    private static ulong Play(string crate, string look, bool queries)
    {
        Simulator simulator = Hall(crate, out Crate engine);
        var other = look == "other simulator" ? new Simulator(simulator.Scene, s_rk4) : simulator;
        BallState[] states = new BallState[look == "group" ? 2 : 1];
        for (int i = 0; i < states.Length; i++)
        {
            states[i] = simulator.Launch(new Vector3d(5 * i, 0.11, 0), new Vector3d(0.1, 1.2, -13), Vector3d.Zero);
        }

        BallGroup? group = look == "group" ? new BallGroup(simulator, 2) : null;
        var request = new LookAheadRequest { Duration = 1.5 };
        Trajectory[] paths = [new Trajectory(), new Trajectory()];
        var cache = new TrajectoryCache(simulator, request, tolerance: 1e-3);
        var log = new StepLog();
        int hits = 0;
        for (int tick = 0; tick < 150; tick++)
        {
            engine.Time = states[0].Time;
            if (queries)
            {
                Query(look, other, group, states, request, paths, cache);
            }

            log.Clear();
            if (group is not null)
            {
                group.Step(states, Tick, log);
            }
            else
            {
                simulator.Step(ref states[0], Tick, log);
            }

            foreach (BallEvent happened in log.Events)
            {
                hits += happened.Kind == BallEventKind.Impact && happened.ColliderIndex > 0 ? 1 : 0;
            }
        }

        // The shot has hit the crate: else nothing was tried.
        Assert.True(hits > 0);
        return Snapshot.Hash(states);
    }

    private static void Query(string look, Simulator simulator, BallGroup? group, BallState[] states, LookAheadRequest request, Trajectory[] paths, TrajectoryCache cache)
    {
        switch (look)
        {
            case "group":
                group!.LookAhead(states, request, paths);
                break;
            case "cache":
                cache.Invalidate();
                cache.Update(in states[0]);
                break;
            case "interception":
                simulator.LookAhead(in states[0], request, paths[0]);
                _ = new Interception().FindFirst(paths[0], [new Player { Position = new Vector3d(3, 0, -10) }], out _);
                break;
            case "forces":
                foreach (ref readonly BallState state in states.AsSpan())
                {
                    _ = simulator.ForcesAt(in state, Tick);
                }

                break;
            case "pass":
                _ = new Aimer(simulator).Find(new AimRequest { From = states[0].Position, Target = new Vector3d(0, 0.35, -9), Speed = 15 });
                break;
            default:
                simulator.LookAhead(in states[0], request, paths[0]);
                break;
        }
    }

    /// <summary>An engine with one crate of 4 kg.</summary>
    private sealed class Crate(double z) : IEngineColliders
    {
        private readonly EngineCollider _crate = new("crate", new BoxShape(Vector3d.Zero, new Vector3d(0.35, 0.35, 0.35)), SurfaceMaterial.Wood) { Mass = 4 };

        public double Time { get; set; }

        public double MaximumSpeed => 0;

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            _crate.MoveTo(new Vector3d(0, 0.35, -Math.Abs(z)), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
            hits.Add(_crate);
        }
    }
}
