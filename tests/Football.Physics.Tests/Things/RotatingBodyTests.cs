using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Bodies and an engine's colliders that rotate about their position within a step.</summary>
public sealed class RotatingBodyTests
{
    private const double Tolerance = 0.03;

    private static readonly Vector3d OnGround = new(0, 0.11, 0);

    private static readonly double[] s_rates = [30, 60, 240];

    private static readonly Hinged s_bat = new()
    {
        Shape = new CapsuleShape(new Vector3d(0.5, 0, 0), new Vector3d(1.1, 0, 0), 0.035),
        Pivot = new Vector3d(-0.8, 0.11, 0),
        Axis = Vector3d.Up,
        Start = -0.7,
        Rate = 20,
    };

    private static readonly Hinged s_door = new()
    {
        Shape = new BoxShape(new Vector3d(0.75, 1, 0), new Vector3d(0.75, 1, 0.02)),
        Pivot = new Vector3d(-0.8, 0, 0),
        Axis = Vector3d.Up,
        Start = -0.5,
        Rate = 3,
    };

    public static TheoryData<Mover, double> MoversAndRates()
    {
        var data = new TheoryData<Mover, double>();
        foreach (Mover mover in Enum.GetValues<Mover>())
        {
            foreach (double hz in s_rates)
            {
                data.Add(mover, hz);
            }
        }

        return data;
    }

    /// <summary>A leg that swings about its hip kicks a ball that lies on the pitch, is new, was kicked with nothing, or rolls away.</summary>
    [Theory]
    [MemberData(nameof(MoversAndRates))]
    public void A_leg_about_its_hip_kicks_a_ball_on_the_ground(Mover mover, double hz)
    {
        var scene = new HingedScene(Leg(10), mover, new Scene { Ball = BallProperties.Tunnel, Ground = Ground.Of(SurfaceMaterial.DryTurf) });
        foreach (int start in new[] { 0, 1, 2 })
        {
            var ball = new Ball(scene.Scene);
            if (start > 0)
            {
                ball.Kick(new Vector3d(0, 0, start == 2 ? -0.5 : 0), default);
            }

            var hits = new List<BallEvent>();
            for (int i = 0; i < 0.2 * hz; i++)
            {
                scene.Move(ball.Time);
                ball.Step(1 / hz);
                foreach (ref readonly BallEvent item in ball.Events)
                {
                    if (item.Kind == BallEventKind.Impact && ball.Simulator.NameOf(item.ColliderIndex) == "thing")
                    {
                        hits.Add(item);
                    }
                }
            }

            // The leg drives the ball into the ground, which throws it against the leg again at the same instant.
            Assert.InRange(hits.Count, 1, 2);
            Assert.Equal(hits[0].Time, hits[^1].Time);

            // Where it hits they touch, and on the mean path to there not before.
            Assert.Equal(Flight.Radius, Leg(10).Distance(hits[0].Position, hits[0].Time), 1e-7);
            Vector3d mean = (hits[0].Position - OnGround) / hits[0].Time;
            Assert.Equal(Leg(10).FirstTouch(OnGround, mean, Flight.Radius, 0.2, out _), hits[0].Time, start == 2 ? 1e-4 : 1e-8);
            Assert.InRange(new Vector3d(ball.Velocity.X, 0, ball.Velocity.Z).Length, 8.5, 12.5);
        }
    }

    /// <summary>v' = v + (1 + e) u n, with u of the point of contact.</summary>
    [Theory]
    [MemberData(nameof(MoversAndRates))]
    public void In_the_void_the_ball_gets_the_speed_of_the_point_that_hits_it(Mover mover, double hz)
    {
        Close(new Vector3d(0, -4.109, -11.936), After(Leg(10), mover, hz, OnGround, default, 0.3, out BallEvent hit));
        Assert.Equal(0.1010, hit.Time, 5e-5);
        Assert.Equal(2.525, After(Leg(2), mover, hz, OnGround, default, 0.8, out _).Length, Tolerance * 2.525);
        Assert.Equal(25.25, After(Leg(20), mover, hz, OnGround, default, 0.2, out _).Length, Tolerance * 25.25);
        Assert.Equal(12.37, After(Leg(10), mover, hz, OnGround, new Vector3d(0, 0, -0.5), 0.3, out _).Length, Tolerance * 12.37);
        Close(new Vector3d(4.28, 0, -23.21), After(s_bat, mover, hz, OnGround, default, 0.2, out _));
        Close(new Vector3d(0.58, 0, -3.50), After(s_door, mover, hz, OnGround, default, 0.4, out _));
    }

    [Theory]
    [InlineData(Mover.Body)]
    [InlineData(Mover.Engine)]
    [InlineData(Mover.ExactEngine)]
    public void A_flipper_hits_at_every_rate(Mover mover)
    {
        foreach (double rate in new double[] { 1, 2, 3, 5, 8, 10, 15, 20, 25, 30, 35, 40 })
        {
            foreach (double hz in s_rates)
            {
                var flipper = new Hinged { Shape = new CapsuleShape(Vector3d.Zero, new Vector3d(1.2, 0, 0), 0.05), Axis = new Vector3d(0, 0, 1), Rate = rate };
                var at = new Vector3d(0.8 * Math.Cos(Math.PI / 6), 0.8 * Math.Sin(Math.PI / 6), 0);
                Vector3d velocity = After(flipper, mover, hz, at, default, 0.55 / rate + (2 / hz), out _);
                Assert.Equal(1.176 * rate, velocity.Length, Tolerance * 1.176 * rate);
            }
        }
    }

    /// <summary>However far it rotates in a step: here 4 rad in one of 0.1 s.</summary>
    [Theory]
    [InlineData(Mover.Body)]
    [InlineData(Mover.ExactEngine)]
    public void A_flipper_hits_what_it_would_pass_within_one_step(Mover mover)
    {
        var flipper = new Hinged { Shape = new CapsuleShape(Vector3d.Zero, new Vector3d(1.2, 0, 0), 0.05), Axis = new Vector3d(0, 0, 1), Rate = 40 };
        Vector3d at = 0.8 * new Vector3d(Math.Cos(3.0), Math.Sin(3.0), 0);
        double expected = flipper.FirstTouch(at, default, Flight.Radius, 0.1, out _);
        Assert.InRange(expected, 0.06, 0.075);
        var scene = new HingedScene(flipper, mover, HingedScene.Void);
        var simulator = new Simulator(scene.Scene);
        BallState state = simulator.Launch(at, default, default);
        var log = new StepLog();
        scene.Move(0);
        simulator.Step(ref state, 0.1, log);
        Assert.Equal(expected, Flight.First(log, BallEventKind.Impact).Time, 1e-9);
        Assert.Equal(1.176 * 40, state.Velocity.Length, Tolerance * 1.176 * 40);
    }

    /// <summary>Random shapes, pivots, axes, rates and steps against samples of the gap that are 1e-5 s apart.</summary>
    [Theory]
    [InlineData(Mover.Body)]
    [InlineData(Mover.Engine)]
    public void Random_things_hit_when_and_where_samples_say(Mover mover)
    {
        int hits = 0;
        int misses = 0;
        for (int seed = 0; seed < 600; seed++)
        {
            var random = new Random(seed);
            Hinged thing = Drawn(random);
            Vector3d velocity = seed % 3 == 0 ? default : Within(random, 15);

            // At some time the ball would be near the middle of the shape, or of where that passes.
            double near = 0.02 + (0.25 * random.NextDouble());
            Vector3d middle = 0.5 * (thing.Shape.Bounds.Min + thing.Shape.Bounds.Max);
            Vector3d from = thing.PivotAt(near) + thing.At(near).Rotate(middle) + Within(random, 0.4) - (near * velocity);
            double hz = new[] { 240.0, 60, 30, 10 }[seed % 4];
            const double Duration = 0.3;
            if (thing.Distance(from, 0) < Flight.Radius + 1e-3)
            {
                continue;
            }

            double expected = thing.FirstTouch(from, velocity, Flight.Radius, Duration, out double least);
            BallEvent? hit = FirstHit(thing, mover, hz, from, velocity, Duration);
            if (double.IsInfinity(expected))
            {
                // A dip between two samples is no deeper than what is closed in half of one.
                Assert.True(hit is null || least < 1e-3, $"seed {seed}: hit at {hit?.Time}, though the gap is {least} at least");
                misses++;
                continue;
            }

            Vector3d at = from + (expected * velocity);
            Vector3d n = thing.Normal(at, expected);
            double closing = -Vector3d.Dot(velocity - thing.SurfaceVelocity(at - (Flight.Radius * n), expected), n);
            Assert.True(hit is not null, $"seed {seed}: no hit, expected at {expected} closing at {closing}");
            Assert.True(Math.Abs(hit.Value.Time - expected) * Math.Max(closing, 1) < 1e-6, $"seed {seed}: hit at {hit.Value.Time}, expected at {expected}");
            Assert.Equal(0, (hit.Value.Position - at).Length, 1e-3);
            hits++;
        }

        Assert.InRange(hits, 250, 600);
        Assert.InRange(misses, 50, 600);
    }

    /// <summary>A look-ahead and a group of two balls see the same hit, to the last bit of its time.</summary>
    [Theory]
    [InlineData(Mover.Body)]
    [InlineData(Mover.Engine)]
    public void Look_aheads_and_groups_see_the_same(Mover mover)
    {
        var scene = new HingedScene(s_bat, mover, HingedScene.Void);
        var simulator = new Simulator(scene.Scene);
        BallState alone = simulator.Launch(OnGround, new Vector3d(0, 0, 0.3), default);
        scene.Move(0);
        var path = new Trajectory();
        simulator.LookAhead(in alone, new LookAheadRequest { Duration = 0.2, TimeStep = 0.2 }, path);
        Assert.True(path.TryGetHit(0, out BallEvent ahead));
        BallEvent hit = Flight.First(scene.Play(ref alone, simulator, 60, 0.2), BallEventKind.Impact);
        Assert.Equal(hit.Time, ahead.Time, 1e-12);
        Assert.Equal(0, (hit.Velocity - ahead.Velocity).Length, 1e-9);

        var grouped = new HingedScene(s_bat, mover, HingedScene.Void);
        var group = new BallGroup(new Simulator(grouped.Scene), 2);
        BallState[] states = [simulator.Launch(OnGround, new Vector3d(0, 0, 0.3), default), simulator.Launch(OnGround + new Vector3d(0.3, 0, 0), new Vector3d(-0.1, 0, 0), default)];
        var log = new StepLog();
        for (int i = 0; i < 12; i++)
        {
            grouped.Move(states[0].Time);
            group.Step(states, 1 / 60.0, log);
        }

        BallEvent[] hits = [.. log.Events.Span.ToArray().Where(item => item.Kind == BallEventKind.Impact)];
        Assert.Equal(2, hits.Length);
        BallEvent first = Assert.Single(hits, item => item.Ball == 0);
        Assert.Equal(hit.Time, first.Time, 1e-12);
        Assert.Equal(0, (hit.Velocity - first.Velocity).Length, 1e-9);
    }

    /// <summary>Both balls push a leg with a mass, which goes on rotating: from the impact on at the place and angle that it has got to.</summary>
    [Fact]
    public void A_pushed_body_goes_on_rotating()
    {
        var scene = new HingedScene(s_bat, Mover.Body, HingedScene.Void, mass: 2);
        var simulator = new Simulator(scene.Scene);
        BallState state = simulator.Launch(OnGround, default, default);
        scene.Move(0);
        var log = new StepLog();
        simulator.Step(ref state, 0.1, log);
        BallEvent hit = Flight.First(log, BallEventKind.Impact);
        KinematicBody bat = scene.Body;
        Assert.Equal(hit.Time, bat.Time, 1e-12);
        Quaterniond expected = s_bat.At(hit.Time);
        Assert.Equal(0, (bat.Orientation.Rotate(new Vector3d(1, 2, 3)) - expected.Rotate(new Vector3d(1, 2, 3))).Length, 1e-12);
        Assert.Equal(0, (s_bat.Pivot - bat.Position).Length, 1e-12);
        Assert.Equal(0, ((2 * bat.Velocity) + (0.43 * hit.Velocity)).Length, 1e-9);
        Assert.Equal(new Vector3d(0, 20, 0), bat.Spin);
    }

    /// <summary>Bodies that rotate far from the ball, and look-aheads long after they were placed: the tube sees the whole circle.</summary>
    [Theory]
    [InlineData(0.5)]
    [InlineData(3)]
    [InlineData(12)]
    public void A_fast_ball_flies_into_a_propeller(double distance)
    {
        var propeller = new Hinged { Shape = new CapsuleShape(new Vector3d(-1, 0, 0), new Vector3d(1, 0, 0), 0.05), Axis = new Vector3d(0, 0, 1), Rate = 31, Start = 0.4 };
        int hits = 0;
        for (double speed = 2; speed < 40; speed *= 1.3)
        {
            var from = new Vector3d(0.6, 0.1, distance);
            var velocity = new Vector3d(0, 0, -speed);
            double until = (distance / speed) + 0.3;
            double expected = propeller.FirstTouch(from, velocity, Flight.Radius, until, out _);
            BallEvent? hit = FirstHit(propeller, Mover.Body, 60, from, velocity, until);
            Assert.Equal(double.IsInfinity(expected), hit is null);
            Assert.Equal(expected, hit?.Time ?? expected, 1e-8);
            hits += hit is null ? 0 : 1;
        }

        Assert.InRange(hits, 5, 11);
    }

    /// <summary>A walk along the gap looks at the shape a few dozen times, also in a long step.</summary>
    [Fact]
    public void A_search_looks_at_the_shape_a_few_dozen_times()
    {
        var counted = new CountedShape(new CapsuleShape(Vector3d.Zero, new Vector3d(1.2, 0, 0), 0.05));
        var flipper = new Hinged { Shape = counted, Axis = new Vector3d(0, 0, 1), Rate = 40 };
        var scene = new HingedScene(flipper, Mover.Body, HingedScene.Void);
        var simulator = new Simulator(scene.Scene);
        BallState state = simulator.Launch(0.8 * new Vector3d(Math.Cos(3.0), Math.Sin(3.0), 0), default, default);
        scene.Move(0);
        counted.Looks = 0;
        simulator.Step(ref state, 0.1, new StepLog());
        Assert.True(state.Velocity.Length > 40);
        Assert.InRange(counted.Looks, 10, 250);
    }

    /// <summary>A drum of a shape that the library does not know rotates beside a ball at rest, and never comes closer: the search must see that without looking at each micrometre.</summary>
    [Fact]
    public void A_ball_at_rest_beside_a_drum_costs_few_looks()
    {
        var counted = new CountedShape(new CapsuleShape(new Vector3d(0, -1, 0), new Vector3d(0, 1, 0), 0.3));
        var drum = new Hinged { Shape = counted, Axis = Vector3d.Up, Rate = 20, Pivot = new Vector3d(0.3 + Flight.Radius, 0, 0) };
        var scene = new HingedScene(drum, Mover.Body, new Scene { Ball = BallProperties.Tunnel, Ground = Ground.Of(SurfaceMaterial.DryTurf) });
        var ball = new Ball(scene.Scene);
        scene.Move(0);
        Assert.True(scene.Body.Motion.Rotates);
        for (int i = 0; i < 60; i++)
        {
            scene.Move(ball.Time);
            ball.Step(1 / 60.0);
        }

        Assert.Equal(MotionState.Rest, ball.Motion);
        Assert.InRange(counted.Looks, 60, 60 * 3000);
    }

    /// <summary>A spin that leaves the shape as it is rotates nothing: a ball about its centre, a drum about its axis.</summary>
    [Fact]
    public void A_spin_that_changes_nothing_costs_nothing()
    {
        var bodies = new KinematicBodies();
        KinematicBody ball = bodies.Add("ball", new SphereShape(Vector3d.Zero, 0.3));
        KinematicBody drum = bodies.Add("drum", new CapsuleShape(new Vector3d(-1, 0, 0), new Vector3d(1, 0, 0), 0.3));
        Quaterniond turn = Quaterniond.FromAxisAngle(new Vector3d(0, 0, 1), Math.PI / 2);
        ball.MoveTo(default, turn, default, new Vector3d(3, 4, 5), 0);
        drum.MoveTo(default, turn, default, new Vector3d(0, 100, 0), 0);
        Assert.False(ball.Motion.Rotates || drum.Motion.Rotates);
        drum.MoveTo(default, turn, default, new Vector3d(0.1, 100, 0), 0);
        Assert.True(drum.Motion.Rotates);
        Assert.Equal(0.1, drum.Motion.Swing, 1e-9);
    }

    /// <summary>A surface strikes a ball that touches it only if the shape itself closes on the ball.</summary>
    [Fact]
    public void A_surface_whose_shape_stands_still_hits_nothing()
    {
        // At the ball, the spin moves the material out of the shape, which stays where it is.
        var belt = new Obstacle
        {
            Name = "belt",
            Shape = new BoxShape(Vector3d.Zero, new Vector3d(1, 1, 1)),
            Surface = Hinged.Rubber,
            Spin = new Vector3d(0, 0, 2),
            Pivot = new Vector3d(-1, 0, 0),
        };
        var simulator = new Simulator(HingedScene.Void with { Obstacles = [belt], Bodies = null });
        BallState state = simulator.Launch(new Vector3d(0.5, 1 + Flight.Radius, 0), default, default);
        var log = new StepLog();
        simulator.Step(ref state, 0.01, log);
        Assert.Equal(0, state.Velocity.Y, 1e-9);
        Assert.Equal(0, log.Events.Impacts);
    }

    private static Hinged Leg(double rate) => new()
    {
        Shape = new CapsuleShape(new Vector3d(0, -0.85, 0), new Vector3d(0, -0.4, 0), 0.06),
        Pivot = new Vector3d(0, 1, 0),
        Axis = new Vector3d(1, 0, 0),
        Start = -1.2,
        Rate = rate,
    };

    private static Hinged Drawn(Random random)
    {
        Vector3d a = Within(random, 0.8);
        double size = 0.05 + (0.1 * random.NextDouble());
        return new Hinged
        {
            Shape = random.Next(3) switch
            {
                0 => new SphereShape(a, size),
                1 => new CapsuleShape(a, a + Within(random, 1.2), size),
                _ => new BoxShape(a, new Vector3d(size, 0.4 * random.NextDouble() + 0.01, 0.6 * random.NextDouble() + 0.01), Quaterniond.FromRotationVector(Within(random, 3))),
            },
            Pivot = Within(random, 0.8),
            Velocity = Within(random, 2),
            Axis = Unit(Within(random, 1)),
            Start = random.NextDouble() * 7,
            Rate = (random.Next(2) == 0 ? 1 : -1) * (0.5 + (39 * random.NextDouble())),
        };
    }

    private static Vector3d Unit(Vector3d v) => v / v.Length;

    private static Vector3d Within(Random random, double size) =>
        new(size * ((2 * random.NextDouble()) - 1), size * ((2 * random.NextDouble()) - 1), size * ((2 * random.NextDouble()) - 1));

    private static BallEvent? FirstHit(Hinged thing, Mover mover, double hz, Vector3d from, Vector3d velocity, double duration)
    {
        var scene = new HingedScene(thing, mover, HingedScene.Void);
        var simulator = new Simulator(scene.Scene);
        BallState state = simulator.Launch(from, velocity, default);
        StepLog log = scene.Play(ref state, simulator, hz, duration);
        return log.Events.Count > 0 ? log.Events[0] : null;
    }

    /// <summary>The velocity after exactly one impact.</summary>
    private static Vector3d After(Hinged thing, Mover mover, double hz, Vector3d from, Vector3d velocity, double duration, out BallEvent hit)
    {
        var scene = new HingedScene(thing, mover, HingedScene.Void);
        var simulator = new Simulator(scene.Scene);
        BallState state = simulator.Launch(from, velocity, default);
        StepLog log = scene.Play(ref state, simulator, hz, duration);
        Assert.Equal(1, log.Events.Count);
        hit = log.Events[0];

        // By the second model: the instant, and (1 + e) u of the point there.
        double expected = thing.FirstTouch(from, velocity, Flight.Radius, duration, out _);
        Assert.Equal(expected, hit.Time, 1e-9);
        Vector3d n = thing.Normal(hit.Position, expected);
        double closing = Vector3d.Dot(thing.SurfaceVelocity(hit.Position - (Flight.Radius * n), expected) - velocity, n);
        Assert.Equal(0, (velocity + (1.5 * closing * n) - state.Velocity).Length, 1e-6);
        return state.Velocity;
    }

    private static void Close(Vector3d expected, Vector3d actual) => Assert.Equal(0, (expected - actual).Length, Tolerance * expected.Length);

    private sealed class CountedShape(IShape shape) : IShape
    {
        public int Looks { get; set; }

        public double MaximumConcaveCurvature => shape.MaximumConcaveCurvature;

        public Bounds3d Bounds => shape.Bounds;

        public ShapePoint At(in Vector3d point)
        {
            Looks++;
            return shape.At(in point);
        }
    }
}
