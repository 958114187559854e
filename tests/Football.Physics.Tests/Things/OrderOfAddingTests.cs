namespace FootballPhysics.Tests.Things;

/// <summary>The order in which a game adds bodies, or an engine finds its colliders, does not decide where the ball goes.</summary>
public sealed class OrderOfAddingTests
{
    private const double Radius = 0.11;
    private const double Frame = 1.0 / 60;

    public static TheoryData<string, string, double> Pairs
    {
        get
        {
            var data = new TheoryData<string, string, double>();
            foreach (string kind in new[] { "bodies", "engine" })
            {
                foreach (string place in new[] { "ground", "air", "board", "post" })
                {
                    data.Add(kind, place, double.PositiveInfinity);
                    data.Add(kind, place, 75);
                }
            }

            return data;
        }
    }

    /// <summary>Two spheres close on a ball from both sides, to the last bit at the same time.</summary>
    [Theory]
    [MemberData(nameof(Pairs))]
    public void A_mirrored_pair_presses_the_ball_to_the_same_side_in_either_order(string kind, string place, double mass)
    {
        int squeezed = 0;
        int touched = 0;
        for (int draw = 0; draw < 12; draw++)
        {
            var random = new Random(draw);
            (string Name, Vector3d Position, Vector3d Velocity)[] pair = PairOf(random, draw % 3);
            BallState[] first = Play(kind, place, mass, pair, out List<string> events);
            BallState[] second = Play(kind, place, mass, [pair[1], pair[0]], out List<string> others);
            Assert.Equal(events, others);
            for (int i = 0; i < first.Length; i++)
            {
                // Numbers of carriers follow the order of adding, and their names are in the events.
                BallState other = second[i];
                other.Carrier = first[i].Carrier;
                Assert.Equal(first[i], other);
                squeezed += first[i].Motion == MotionState.Pinned ? 1 : 0;
            }

            touched += events.Count(line => line.Contains("Impact", StringComparison.Ordinal));
        }

        Assert.True(touched > 12 && squeezed > 0, $"{touched} impacts, squeezed in {squeezed} frames");
    }

    /// <summary>A crowd of mirrored pairs, added in any order.</summary>
    [Theory]
    [InlineData(4)]
    [InlineData(8)]
    [InlineData(20)]
    public void A_crowd_presses_the_ball_to_the_same_place_in_any_order(int count)
    {
        for (int draw = 0; draw < 10; draw++)
        {
            var random = new Random((100 * count) + draw);
            (string Name, Vector3d Position, Vector3d Velocity)[] all = [.. Enumerable.Range(0, count / 2).SelectMany(i => PairOf(random, i % 3).Select(one => (one.Name + i, one.Position, one.Velocity)))];
            BallState[] expected = Play("bodies", "board", double.PositiveInfinity, all, out _);
            for (int order = 0; order < 3; order++)
            {
                (string Name, Vector3d Position, Vector3d Velocity)[] shuffled = [.. all.OrderBy(_ => random.Next())];
                BallState[] actual = Play("bodies", "board", double.PositiveInfinity, shuffled, out _);
                Assert.Equal(expected.Select(s => (s.Position, s.Velocity, s.Spin, s.Motion)), actual.Select(s => (s.Position, s.Velocity, s.Spin, s.Motion)));
            }
        }
    }

    /// <summary>Two spheres that are mirrored in the plane x = 0, or in z = 0, or in the ball's middle.</summary>
    private static (string Name, Vector3d Position, Vector3d Velocity)[] PairOf(Random random, int mirror)
    {
        double along = 0.25 + (0.2 * random.NextDouble());
        double up = 0.05 * (random.NextDouble() - 0.3);
        double across = mirror == 1 ? 0 : 0.04 * (random.NextDouble() - 0.5);
        double speed = 0.5 + (3 * random.NextDouble());
        var position = new Vector3d(along, up, across);
        var velocity = new Vector3d(-speed, 0, 0);
        Vector3d other = mirror == 2 ? new Vector3d(-along, up, -across) : new Vector3d(-along, up, across);
        return [("right", position, velocity), ("left", other, -velocity)];
    }

    private static BallState[] Play(string kind, string place, double mass, (string Name, Vector3d Position, Vector3d Velocity)[] movers, out List<string> events)
    {
        var centre = new Vector3d(0, place == "air" ? 1 : Radius, 0);
        Obstacle[] obstacles = place switch
        {
            "board" => [new Obstacle { Name = "board", Shape = new BoxShape(new Vector3d(0, 0.5, -0.05 - Radius), new Vector3d(50, 0.5, 0.05)), Surface = SurfaceMaterial.Board }],
            "post" => [new Obstacle { Name = "post", Shape = new CapsuleShape(new Vector3d(0, 0, -0.17), new Vector3d(0, 2, -0.17), 0.06), Surface = SurfaceMaterial.GoalFrame }],
            _ => [],
        };
        var shape = new SphereShape(Vector3d.Zero, 0.12);
        var bodies = new KinematicBodies();
        var engine = new Engine();
        foreach ((string name, Vector3d position, Vector3d velocity) in movers)
        {
            if (kind == "engine")
            {
                engine.Add(new EngineCollider(name, shape, SurfaceMaterial.Boot) { Mass = mass }, centre + position, velocity);
            }
            else
            {
                bodies.Add(name, shape, SurfaceMaterial.Boot, mass);
            }
        }

        var simulator = new Simulator(kind == "engine" ? new Scene { Obstacles = obstacles, EngineColliders = engine } : new Scene { Obstacles = obstacles, Bodies = bodies });
        BallState state = simulator.Launch(centre, Vector3d.Zero, Vector3d.Zero);
        var states = new BallState[40];
        events = [];
        for (int tick = 0; tick < states.Length; tick++)
        {
            engine.Time = state.Time;
            for (int i = 0; i < bodies.Count; i++)
            {
                bodies[i].MoveTo(centre + movers[i].Position + (state.Time * movers[i].Velocity), movers[i].Velocity, state.Time);
            }

            var log = new StepLog();
            simulator.Step(ref state, Frame, log);
            states[tick] = state;
            foreach (BallEvent happened in log.Events.Span)
            {
                events.Add($"{happened.Kind} {(happened.ColliderIndex >= 0 ? simulator.NameOf(happened.ColliderIndex) : "")} {happened.Time:R} {happened.Position:R} {happened.Velocity:R}");
            }
        }

        return states;
    }

    private sealed class Engine : IEngineColliders
    {
        private readonly List<(EngineCollider Collider, Vector3d Position, Vector3d Velocity)> _all = [];

        public double Time { get; set; }

        public double MaximumSpeed => 4;

        public void Add(EngineCollider collider, Vector3d position, Vector3d velocity) => _all.Add((collider, position, velocity));

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            foreach ((EngineCollider collider, Vector3d position, Vector3d velocity) in _all)
            {
                collider.MoveTo(position + (Time * velocity), Quaterniond.Identity, velocity, Vector3d.Zero);
                hits.Add(collider);
            }
        }
    }
}
