namespace FootballPhysics.Tests.Things;

/// <summary>A ball in a crowd: many contacts at one instant.</summary>
public sealed class CrowdTests
{
    private const double Radius = 0.11;
    private const double Frame = 1.0 / 60;

    /// <summary>No frame ends deeper in what stands still, m.</summary>
    private const double Deepest = 1e-9;

    /// <summary>Events of a step.</summary>
    private const int MostEvents = 24;

    public static TheoryData<string, int> Crowds
    {
        get
        {
            var data = new TheoryData<string, int>();
            foreach (string kind in new[] { "board", "corner", "studs", "engine", "group" })
            {
                foreach (int count in new[] { 4, 8, 12, 30 })
                {
                    data.Add(kind, count);
                }
            }

            return data;
        }
    }

    /// <summary>Eight spheres that closed in on a ball at a board pressed it 50 mm into the board: the set had no room for that.</summary>
    [Theory]
    [MemberData(nameof(Crowds))]
    public void Many_that_close_in_press_the_ball_into_nothing_that_stands_still(string kind, int count)
    {
        int squeezed = 0;
        for (int seed = 1; seed <= 4; seed++)
        {
            for (int draw = 0; draw < 5; draw++)
            {
                var crowd = new Crowd(kind, count, new Random((1000 * seed) + draw));
                var log = new StepLog();
                for (int tick = 0; tick < 20; tick++)
                {
                    log.Clear();
                    BallState state = crowd.Step(tick, log);
                    Assert.True(crowd.Depth(in state) <= Deepest, $"seed {seed}, draw {draw}, tick {tick}: {crowd.Depth(in state)} m in {state}");
                    Assert.InRange(log.Events.Count, 0, kind == "group" ? 90 : MostEvents);
                    Assert.Equal(0, log.StalledSteps);
                    Assert.InRange(log.Evaluations, 0, 2000);
                    Assert.True(double.IsFinite(state.Velocity.Length) && state.Velocity.Length < 4);
                    squeezed += state.Motion == MotionState.Pinned ? 1 : 0;
                }
            }
        }

        Assert.True(squeezed > 0, "The crowd leaves the ball no room.");
    }

    /// <summary>Moving contacts without a load are left out beyond 16, and counted.</summary>
    [Fact]
    public void The_log_counts_contacts_that_are_left_out()
    {
        long few = 0;
        long many = 0;
        for (int draw = 0; draw < 5; draw++)
        {
            few += LeftOut(new Crowd("board", 12, new Random(draw)));
            many += LeftOut(new Crowd("board", 60, new Random(draw)));
        }

        Assert.Equal(0, few);
        Assert.InRange(many, 1, long.MaxValue);

        static long LeftOut(Crowd crowd)
        {
            var log = new StepLog();
            for (int tick = 0; tick < 20; tick++)
            {
                crowd.Step(tick, log);
            }

            return log.LeftOut;
        }
    }

    [Fact]
    public void Steps_in_a_crowd_allocate_nothing()
    {
        var crowd = new Crowd("studs", 30, new Random(5));
        var log = new StepLog();
        Assert.Equal(0, Allocation.Of(() =>
        {
            for (int tick = 0; tick < 20; tick++)
            {
                log.Clear();
                crowd.Step(tick, log);
            }

            crowd.Start();
        }));
    }

    /// <summary>A ball in a nest of studs touches more surfaces than a caller has room for on its stack. It rests there, without events, also in a steady wind.</summary>
    [Theory]
    [InlineData(3, 0)]
    [InlineData(7, 0)]
    [InlineData(9, 0)]
    [InlineData(9, 3)]
    [InlineData(24, 0)]
    [InlineData(24, 3)]
    public void A_ball_rests_on_any_number_of_studs(int count, double wind)
    {
        Obstacle[] studs = [.. Studs(count, new Vector3d(0, Radius, 0), 0.02, 0.6)];
        var ball = new Ball(new Scene { Obstacles = studs, Air = Scene.Default.Air with { Wind = new Vector3d(wind, 0, 0) } });
        ball.Place(new Vector3d(0, Radius, 0));
        int events = 0;
        for (int tick = 0; tick < 300; tick++)
        {
            ball.Step(Frame);
            events += tick < 60 ? 0 : ball.Events.Count;
            foreach (BallEvent happened in ball.Events)
            {
                Assert.NotEqual(BallEventKind.Pinned, happened.Kind);
            }
        }

        Assert.Equal(MotionState.Rest, ball.Motion);
        Assert.Equal(0, events);
        Assert.InRange(studs.Max(stud => Radius - stud.Shape.At(ball.State.Position).Distance), double.NegativeInfinity, Deepest);
        Assert.InRange((ball.State.Position - new Vector3d(0, Radius, 0)).Length, 0, 1e-9);
    }

    /// <summary>Sets of more contacts than fit on the stack have memory in the simulator, which threads may share.</summary>
    [Fact]
    public void Threads_that_share_a_simulator_share_no_set()
    {
        const int Balls = 16;
        const int Frames = 40;
        Obstacle[] studs = [.. Studs(24, new Vector3d(0, Radius, 0), 0.02, 0.6).Select(stud => stud with { Shape = new YieldingShape(stud.Shape) })];
        var simulator = new Simulator(new Scene { Obstacles = studs });
        BallState[] Press(int k)
        {
            var log = new StepLog();
            var pressed = new BallState[Frames];
            for (int tick = 0; tick < Frames; tick++)
            {
                log.Clear();
                pressed[tick] = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(0, -0.01 * k, 0.001 * tick), new Vector3d(0, 0.2 * k, 0));
                simulator.Step(ref pressed[tick], Frame, log);
            }

            return pressed;
        }

        BallState[][] alone = [.. Enumerable.Range(0, Balls).Select(Press)];
        var together = new BallState[Balls][];
        Parallel.For(0, Balls, new ParallelOptions { MaxDegreeOfParallelism = 4 }, k => together[k] = Press(k));
        Assert.Equal(Snapshot.Hash([.. alone.SelectMany(balls => balls)]), Snapshot.Hash([.. together.SelectMany(balls => balls)]));
    }

    /// <summary>Small spheres that a ball touches, in a ring about its lower half.</summary>
    private static IEnumerable<Obstacle> Studs(int count, Vector3d centre, double radius, double up)
    {
        for (int i = 0; i < count; i++)
        {
            double around = 2 * Math.PI * (i + 0.1) / count;
            var direction = new Vector3d(Math.Cos(around) * Math.Cos(up), -Math.Sin(up), Math.Sin(around) * Math.Cos(up));
            yield return new Obstacle { Name = $"stud {i}", Shape = new SphereShape(centre + ((Radius + radius) * direction), radius) };
        }
    }

    /// <summary>A shape that sometimes lets another thread run during a query, also while a set is found.</summary>
    private sealed class YieldingShape(IShape shape) : IShape
    {
        private const int Between = 29;

        private int _queries;

        public double MaximumConcaveCurvature => shape.MaximumConcaveCurvature;

        public Bounds3d Bounds => shape.Bounds;

        public ShapePoint At(in Vector3d point)
        {
            if (Interlocked.Increment(ref _queries) % Between == 0)
            {
                Thread.Sleep(0);
            }

            return shape.At(point);
        }
    }

    /// <summary>Small spheres close in on a ball that touches what stands still.</summary>
    private sealed class Crowd : IEngineColliders
    {
        private readonly Vector3d _centre;
        private readonly Obstacle[] _still;
        private readonly Vector3d[] _positions;
        private readonly Vector3d[] _velocities;
        private readonly KinematicBody[] _bodies = [];
        private readonly EngineCollider[] _colliders = [];
        private readonly Simulator _simulator;
        private readonly BallGroup? _group;
        private readonly BallState[] _states = [];
        private BallState _state;

        public Crowd(string kind, int count, Random random)
        {
            double Between(double low, double high) => low + ((high - low) * random.NextDouble());
            _centre = new Vector3d(kind == "corner" ? Radius : 0, Radius, Radius);
            _still = StillOf(kind);
            _positions = new Vector3d[count];
            _velocities = new Vector3d[count];
            for (int i = 0; i < count; i++)
            {
                double around = Math.PI * (kind == "corner" ? 0.5 : 1) * (i + Between(0.3, 0.7)) / count;
                double up = i % 3 * Between(0.3, 0.4);
                var direction = new Vector3d(Math.Cos(around) * Math.Cos(up), Math.Sin(up), Math.Sin(around) * Math.Cos(up));
                _positions[i] = _centre + (Between(0.165, 0.21) * direction);
                _velocities[i] = -Between(0.6, 1) * direction;
            }

            Scene scene = new() { Obstacles = _still };
            IEnumerable<int> all = Enumerable.Range(0, count);
            if (kind == "engine")
            {
                _colliders = [.. all.Select(i => new EngineCollider($"sphere {i}", new SphereShape(Vector3d.Zero, 0.05), SurfaceMaterial.Boot))];
                scene = scene with { EngineColliders = this };
            }
            else
            {
                var bodies = new KinematicBodies();
                _bodies = [.. all.Select(i => bodies.Add($"sphere {i}", new SphereShape(Vector3d.Zero, 0.05), SurfaceMaterial.Boot))];
                scene = scene with { Bodies = bodies };
            }

            _simulator = new Simulator(scene);
            if (kind == "group")
            {
                _group = new BallGroup(_simulator, 2);
                _states = new BallState[2];
            }

            Start();
        }

        public double Time { get; private set; }

        public double MaximumSpeed => 1;

        /// <summary>Puts the ball back.</summary>
        public void Start()
        {
            _state = _simulator.Launch(_centre, Vector3d.Zero, Vector3d.Zero);
            Time = 0;
            for (int i = 0; i < _states.Length; i++)
            {
                // Another ball next to it is pressed too.
                _states[i] = i == 0 ? _state : _simulator.Launch(_centre + new Vector3d(2 * Radius, 0, 0), Vector3d.Zero, Vector3d.Zero);
            }
        }

        public BallState Step(int tick, StepLog log)
        {
            Time = tick * Frame;
            for (int i = 0; i < _bodies.Length; i++)
            {
                _bodies[i].MoveTo(PositionAt(i, tick), VelocityAt(i, tick), _state.Time);
            }

            if (_group is null)
            {
                _simulator.Step(ref _state, Frame, log);
                return _state;
            }

            _group.Step(_states, Frame, log);
            _state = _states[0];
            return Depth(in _states[1]) > Depth(in _state) ? _states[1] : _state;
        }

        /// <summary>How deep a ball is in what stands still, m.</summary>
        public double Depth(in BallState state)
        {
            double depth = Radius - state.Position.Y;
            foreach (Obstacle obstacle in _still)
            {
                depth = Math.Max(depth, Radius - obstacle.Shape.At(state.Position).Distance);
            }

            return depth;
        }

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            int tick = (int)Math.Round(Time / Frame);
            for (int i = 0; i < _colliders.Length; i++)
            {
                _colliders[i].MoveTo(PositionAt(i, tick), Quaterniond.Identity, VelocityAt(i, tick), Vector3d.Zero);
                hits.Add(_colliders[i]);
            }
        }

        private Vector3d PositionAt(int i, int tick) => _positions[i] + (Math.Min(tick, 8) * Frame * _velocities[i]);

        private Vector3d VelocityAt(int i, int tick) => tick < 8 ? _velocities[i] : Vector3d.Zero;

        private Obstacle[] StillOf(string kind)
        {
            var board = new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 0.5, -0.05), new Vector3d(50, 0.5, 0.05)), Surface = SurfaceMaterial.Board };
            var side = new Obstacle { Name = "side", Shape = new BoxShape(new Vector3d(-0.05, 0.5, 0), new Vector3d(0.05, 0.5, 50)), Surface = SurfaceMaterial.Board };
            return kind switch
            {
                "corner" => [board, side],
                "studs" => [board, .. Studs(11, _centre, 0.015, 0.5).Where(stud => stud.Shape.At(_centre).Normal.Z > 0.3)],
                _ => [board],
            };
        }
    }
}
