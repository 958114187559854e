using FootballPhysics.Yardsticks;

namespace FootballPhysics.Tests.Things;

/// <summary>What a ball ignores is not there: all bits of its motion are those of the scene without it.</summary>
public sealed class IgnoredThingsTests
{
    private const int Layer = 5;
    private const double Tick = 1.0 / 60;

    private static readonly BallProperties s_ball = BallProperties.Modern with { Ignores = Layers.Of(Layer) };

    public enum Kind
    {
        Body,
        BodyAmongBodies,
        Obstacle,
        MovingObstacle,
        ObstacleAmongBodies,
        EngineCollider,
        EngineColliderAmongBodies,
        Everything,
    }

    public static TheoryData<Kind, int> Kinds
    {
        get
        {
            var data = new TheoryData<Kind, int>();
            foreach (Kind kind in Enum.GetValues<Kind>())
            {
                data.Add(kind, 1);
                data.Add(kind, 3);
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Kinds))]
    public void A_ball_moves_to_the_last_bit_as_without_what_it_ignores(Kind kind, int balls)
    {
        int events = 0;
        for (int seed = 0; seed < 60; seed++)
        {
            var random = new SeededRandom(SeededRandom.Mix((int)kind, seed));
            Scene scene = random.Any(Scene.Default, Scene.Published, Scene.Default with { Air = new Air { Wind = new Vector3d(4, 0, 3) } }) with { Ball = s_ball };
            bool amongBodies = kind is Kind.BodyAmongBodies or Kind.ObstacleAmongBodies or Kind.EngineColliderAmongBodies or Kind.Everything;
            bool amongEngine = kind is Kind.EngineCollider or Kind.EngineColliderAmongBodies or Kind.Everything;
            var without = new Side(scene, kind, isWith: false, amongBodies, amongEngine, balls);
            var with = new Side(scene, kind, isWith: true, amongBodies, amongEngine, balls);
            var starts = new BallState[balls];
            for (int i = 0; i < balls; i++)
            {
                starts[i] = without.Simulator.Launch(new Vector3d(0.4 * i, 0.11, 0), random.Uniform(0, 12) * (random.Heading() + new Vector3d(0, random.Uniform(0, 0.4), 0)), random.Uniform(0, 30) * random.Direction());
            }

            without.Balls = [.. starts];
            with.Balls = [.. starts];
            Vector3d at = random.Uniform(0, 3) * random.Heading();
            Vector3d velocity = random.Uniform(0, 4) * random.Heading();
            double turn = random.Uniform(-8, 8);
            for (int tick = 0; tick < 60; tick++)
            {
                without.Step(at, velocity, turn);
                with.Step(at, velocity, turn);
                at += Tick * velocity;
                for (int i = 0; i < balls; i++)
                {
                    BallState a = without.Balls[i];
                    BallState b = with.Balls[i];
                    Assert.True(
                        a.Position == b.Position && a.Velocity == b.Velocity && a.Spin == b.Spin && a.Orientation == b.Orientation && a.Motion == b.Motion && a.ClearUntil.Equals(b.ClearUntil),
                        $"seed {seed}, tick {tick}, ball {i}: {Snapshot.Difference(in a, in b)}");
                }

                Assert.Equal(without.Events, with.Events);
            }

            events += without.AllEvents;
        }

        Assert.InRange(events, 60, int.MaxValue);
    }

    /// <summary>A scene with or without what the ball ignores.</summary>
    private sealed class Side
    {
        private readonly BallGroup? _group;
        private readonly StepLog _log = new();
        private readonly KinematicBodies _bodies = [];
        private readonly Engine? _engine;
        private readonly int _real;

        public Side(Scene scene, Kind kind, bool isWith, bool amongBodies, bool amongEngine, int balls)
        {
            if (amongBodies)
            {
                _bodies.Add("player", BodyKind.Player);
                _real = 1;
            }

            if (isWith && kind is Kind.Body or Kind.BodyAmongBodies or Kind.Everything)
            {
                _bodies.Add("ghost", BodyKind.Player.Shape, SurfaceMaterial.PublishedSand, mass: 3, layer: Layer);
                _bodies.Add("fast ghost", new BoxShape(Vector3d.Zero, new Vector3d(0.3, 0.3, 0.3)), SurfaceMaterial.PublishedSand, layer: Layer);
            }

            var wall = new Obstacle { Name = "wall", Shape = new BoxShape(new Vector3d(0, 1, -2), new Vector3d(3, 2, 0.2)), Surface = SurfaceMaterial.PublishedSand, Layer = Layer };
            Obstacle[] ghosts = !isWith ? [] : kind switch
            {
                Kind.Obstacle => [wall, wall with { Shape = new PlaneShape(new Vector3d(0, 0, 1), Vector3d.Up) }],
                Kind.MovingObstacle => [wall with { Velocity = new Vector3d(9, 0, 1) }, wall with { Mass = 2, Velocity = new Vector3d(1, 0, 0) }],
                Kind.ObstacleAmongBodies or Kind.Everything => [wall, wall with { Velocity = new Vector3d(30, 0, 1) }],
                _ => [],
            };
            _engine = amongEngine ? new Engine(isWith) : null;
            scene = scene with { Obstacles = ghosts, Bodies = _bodies.Count > 0 ? _bodies : null, EngineColliders = _engine };
            Simulator = new Simulator(scene);
            _group = balls > 1 ? new BallGroup(Simulator, balls) : null;
        }

        public Simulator Simulator { get; }

        public BallState[] Balls { get; set; } = [];

        public int Events => _log.Events.Count;

        public int AllEvents { get; private set; }

        public void Step(Vector3d at, Vector3d velocity, double turn)
        {
            double time = Balls[0].Time;
            for (int i = 0; i < _bodies.Count; i++)
            {
                Quaterniond turned = Quaterniond.FromAxisAngle(Vector3d.Up, turn * (time + i));
                _bodies[i].MoveTo(i < _real ? at : Balls[0].Position.Horizontal + new Vector3d(0.1 * i, 0, 0.05), turned, i < _real ? velocity : 20 * velocity, new Vector3d(0, turn, 0), time);
            }

            _engine?.Put(at + new Vector3d(0.5, 0, 0.5), velocity, time);
            _log.Clear();
            if (_group is not null)
            {
                _group.Step(Balls, Tick, _log);
            }
            else
            {
                Simulator.Step(ref Balls[0], Tick, _log);
            }

            AllEvents += _log.Events.Count;
        }
    }

    /// <summary>An engine with a collider, and with one that the ball ignores.</summary>
    private sealed class Engine(bool isWith) : IEngineColliders
    {
        private readonly EngineCollider _real = new("thing", new BoxShape(Vector3d.Zero, new Vector3d(0.3, 0.5, 0.1)), SurfaceMaterial.Wood);
        private readonly EngineCollider _ghost = new("ghost", new SphereShape(Vector3d.Zero, 0.5), SurfaceMaterial.PublishedSand) { Layer = Layer, Mass = 2 };

        public double Time { get; private set; }

        public double MaximumSpeed => 12;

        public void Put(Vector3d at, Vector3d velocity, double time)
        {
            Time = time;
            _real.MoveTo(at, Quaterniond.FromAxisAngle(Vector3d.Up, 3 * time), velocity, new Vector3d(0, 3, 0));
            _ghost.MoveTo(0.9 * at, Quaterniond.Identity, velocity, new Vector3d(0, 20, 0));
        }

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            hits.Add(_real);
            if (isWith)
            {
                hits.Add(_ghost);
            }
        }
    }
}
