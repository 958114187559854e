using FootballPhysics.Contacts;

namespace FootballPhysics.Tests.Things;

/// <summary>An engine whose answers hold many colliders, most of them far from the ball.</summary>
public sealed class ManyCollidersTests
{
    private const double Tick = 1.0 / 60;
    private const double Radius = 0.11;

    /// <summary>A collider that is too far does no harm, however many there are and whichever comes first in the answer.</summary>
    [Theory]
    [InlineData(256)]
    [InlineData(257)]
    [InlineData(400)]
    [InlineData(2000)]
    public void A_ball_hits_what_is_near_among_many_that_are_far(int count)
    {
        foreach (int hit in new[] { 0, 1, count / 2, count - 1 })
        {
            var engine = new Answers();
            for (int i = 0; i < count; i++)
            {
                engine.Add(new EngineCollider("bone " + i, new SphereShape(Vector3d.Zero, 0.1)), new Vector3d(0.3 * (i - hit), Radius, -6));
            }

            Assert.Equal("bone " + hit, FirstHit(new Ball(new Scene { EngineColliders = engine })));
        }
    }

    /// <summary>More colliders than the table has at first may be near as well: the ball rolls over a bed of pebbles as if the engine found only the nearest.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void More_than_256_near_the_ball_are_all_met(int seed)
    {
        var random = new Random(seed);
        var all = new Answers();
        var nearest = new Answers { Exact = true };
        var goal = new Goal { Center = new Vector3d(0, 0, -3), Facing = new Vector3d(0, 0, 1) };
        for (int i = 0; i < 3500; i++)
        {
            var place = new Vector3d((0.008 * (i % 50)) - 0.2 + (0.004 * random.NextDouble()), 0.2 + (0.004 * random.NextDouble()), (-0.008 * (i / 50)) + 0.2);
            foreach (Answers engine in new[] { all, nearest })
            {
                engine.Add(new EngineCollider("pebble " + i, new SphereShape(Vector3d.Zero, 0.012)), place);
            }
        }

        var of = new Simulator(new Scene { EngineColliders = all, Goals = [goal] });
        var other = new Simulator(new Scene { EngineColliders = nearest, Goals = [goal] });
        BallState state = of.Launch(new Vector3d(0, 0.5, 0.1), new Vector3d(0.1 * random.NextDouble(), -0.5, -0.8), Vector3d.Zero);
        BallState expected = state;
        int impacts = 0;
        double lowest = double.PositiveInfinity;
        for (int tick = 0; tick < 60; tick++)
        {
            var log = new StepLog();
            of.Step(ref state, Tick, log);
            other.Step(ref expected, Tick, new StepLog());

            // Each bounce multiplies what rounding leaves.
            Assert.True(tick > 40 || (state.Position - expected.Position).Length < 1e-7);
            impacts += log.Events.Impacts > 0 ? 1 : 0;
            lowest = Math.Min(lowest, all.LeastGap(state.Position, Radius));
        }

        Assert.True(all.Longest > EngineThings.Room, "More are found than the table has places for at first.");
        Assert.InRange(impacts, 3, int.MaxValue);
        Assert.InRange(lowest, -1e-9, double.PositiveInfinity);
    }

    /// <summary>Numbers of nets and goals stay as they are when the table grows: a goal behind many colliders is reported by name.</summary>
    [Fact]
    public void A_goal_is_still_a_goal_when_the_table_has_grown()
    {
        // In a step of 0.4 s the box of the flight reaches down to them, and the ball passes above.
        var engine = new Answers();
        for (int i = 0; i < 700; i++)
        {
            engine.Add(new EngineCollider("pebble " + i, new SphereShape(Vector3d.Zero, 0.012)), new Vector3d(0, 0.15 + (1e-4 * i), -5));
        }

        var goal = new Goal { Center = new Vector3d(0, 0, -12), Facing = new Vector3d(0, 0, 1) };
        var simulator = new Simulator(Scene.Vacuum with { EngineColliders = engine, Goals = [goal] });
        List<string> events = Play(simulator, out BallState state);
        List<string> expected = Play(new Simulator(Scene.Vacuum with { Goals = [goal] }), out BallState plain);
        Assert.True(simulator.World!.Colliders.Length > 900, "The table has grown.");
        Assert.Contains(expected, line => line.StartsWith("Goal goal", StringComparison.Ordinal));
        Assert.Contains(expected, line => line.StartsWith("Net", StringComparison.Ordinal));
        Assert.Equal(expected, events);
        Assert.Equal(plain.Position, state.Position);

        static List<string> Play(Simulator simulator, out BallState state)
        {
            var events = new List<string>();
            state = simulator.Launch(new Vector3d(0, Radius, 0), new Vector3d(0, 6, -16), Vector3d.Zero);
            for (int step = 0; step < 10; step++)
            {
                var log = new StepLog();
                simulator.Step(ref state, 0.4, log);
                for (int i = 0; i < log.Events.Count; i++)
                {
                    BallEvent happened = log.Events[i];
                    events.Add($"{happened.Kind} {(happened.ColliderIndex >= 0 ? simulator.NameOf(happened.ColliderIndex) : "")} {happened.Time:R}");
                }
            }

            return events;
        }
    }

    [Fact]
    public void Steps_among_many_colliders_allocate_nothing_once_the_table_has_grown()
    {
        var engine = new Answers();
        for (int i = 0; i < 600; i++)
        {
            engine.Add(new EngineCollider("pebble " + i, new SphereShape(Vector3d.Zero, 0.012)), new Vector3d((0.02 * (i % 30)) - 0.3, 0.2, (-0.02 * (i / 30)) + 0.2));
        }

        var simulator = new Simulator(new Scene { EngineColliders = engine });
        BallState start = simulator.Launch(new Vector3d(0, 0.5, 0.1), new Vector3d(0, -0.5, -0.3), Vector3d.Zero);
        var log = new StepLog();
        Assert.Equal(0, Allocation.Of(() =>
        {
            BallState state = start;
            for (int tick = 0; tick < 60; tick++)
            {
                log.Clear();
                simulator.Step(ref state, Tick, log);
            }
        }));
    }

    private static string FirstHit(Ball ball)
    {
        ball.Kick(new Vector3d(0, 0, -11), Vector3d.Zero);
        while (ball.Time < 1.5)
        {
            ball.Step(Tick);
            foreach (BallEvent happened in ball.Events)
            {
                if (happened.Kind == BallEventKind.Impact && happened.ColliderIndex > 0)
                {
                    return ball.Simulator.NameOf(happened.ColliderIndex)!;
                }
            }
        }

        return "nothing";
    }

    /// <summary>An engine that answers each cast with all that it has, or with no more than it must.</summary>
    private sealed class Answers : IEngineColliders
    {
        private readonly List<(EngineCollider Collider, Vector3d Position)> _all = [];

        public bool Exact { get; init; }

        public double Time => 0;

        public double MaximumSpeed => 0;

        /// <summary>The greatest number of colliders in the box of one cast.</summary>
        public int Longest { get; private set; }

        public void Add(EngineCollider collider, Vector3d position) => _all.Add((collider, position));

        public double LeastGap(Vector3d position, double radius) => _all.Min(one => (position - one.Position).Length) - radius - 0.012;

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            int near = 0;
            for (int i = 0; i < _all.Count; i++)
            {
                (EngineCollider collider, Vector3d position) = _all[i];
                Vector3d apart = position - cast.From;
                double along = Math.Min(cast.Distance, Math.Max(0, Vector3d.Dot(in apart, cast.Direction)));
                bool isNear = (apart - (along * cast.Direction)).Length <= cast.Radius + 0.013;
                near += isNear ? 1 : 0;
                if (isNear || !Exact)
                {
                    collider.MoveTo(position, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
                    hits.Add(collider);
                }
            }

            Longest = Math.Max(Longest, near);
        }
    }
}
