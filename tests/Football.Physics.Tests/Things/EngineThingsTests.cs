using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics.Tests.Things;

/// <summary>The table of engine colliders: when it asks the engine, which colliders it finds, how fast they are, and which were pushed.</summary>
public sealed class EngineThingsTests
{
    private const double Radius = 0.11;

    /// <summary>A cast answers all questions within its volume: 2 cm about a ball, or about the segment of a path.</summary>
    [Fact]
    public void One_cast_answers_for_its_volume()
    {
        var engine = new ShapesAsEngine();
        engine.Add("floor", new PlaneShape(Vector3d.Zero, Vector3d.Up));
        EngineThings things = ThingsOf(engine);
        var place = new Vector3d(1, Radius, 2);
        things.LookAt(in place, 0, 0);
        Assert.Equal(1, engine.Casts);
        Assert.Equal(1, things.Count);
        things.LookAt(in place, 0, 0);
        things.LookAt(place + new Vector3d(0.009, 0, 0), 0, 0);
        things.LookAt(place + new Vector3d(0, 0, -0.005), 0, 0.014);
        Assert.Equal(1, engine.Casts);
        things.LookAt(place + new Vector3d(0, 0, -0.005), 0, 0.016);
        Assert.Equal(2, engine.Casts);
        things.Forget();
        things.LookAt(place + new Vector3d(0, 0, -0.005), 0, 0.016);
        Assert.Equal(3, engine.Casts);

        // Beside the segment of a path, at any point of it, and beyond its ends.
        var path = PathCubic.Line(in place, new Vector3d(20, 0, 0), 0.1);
        things.LookAlong(in path, 0);
        Assert.Equal(4, engine.Casts);
        foreach (double along in new[] { -0.009, 0, 0.7, 2, 2.009 })
        {
            things.LookAt(place + new Vector3d(along, 0, 0), 0, 0);
        }

        things.LookAt(place + new Vector3d(1.3, 0, 0.0095), 0, 0);
        Assert.Equal(4, engine.Casts);
        things.LookAt(place + new Vector3d(1.3, 0, 0.0105), 0, 0);
        Assert.Equal(5, engine.Casts);
    }

    /// <summary>The engine says how fast its colliders are. A cast that hits a faster one, which rotates, is repeated in a wider volume; nothing of it is kept.</summary>
    [Fact]
    public void A_rotating_collider_widens_the_cast_that_hits_it_and_no_other_one()
    {
        var rod = new EngineCollider("rod", new BoxShape(Vector3d.Zero, new Vector3d(0.3, 0.4, 1.2)));
        var engine = new Rigid(rod) { MaximumSpeed = 3, Time = 0.1 };
        EngineThings things = ThingsOf(engine);
        double[] radii = [Radius + 0.02 + 0.3, Radius + 0.02 + (0.1 * (1 + (6 * new Vector3d(0.3, 0, 1.2).Length)))];
        for (int i = 0; i < 4; i++)
        {
            rod.MoveTo(new Vector3d(0, 5, 0), Quaterniond.Identity, new Vector3d(1, 0, 0), new Vector3d(0, 6 * (i % 2), 0));
            things.Forget();
            things.LookAt(new Vector3d(0, 5, 0), 0, 0);
            Assert.Equal(radii[i % 2], engine.Last.Radius, 1e-9);
            Assert.Equal(3, things.GreatestSpeed);
        }
    }

    /// <summary>A push is undone to the last bit, whether or not the engine placed the collider again in between.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_push_leaves_no_bit_behind(bool isPlacedAgain)
    {
        var random = new Random(5);
        var pushes = EnginePushes.Of(new ShapesAsEngine());
        var kept = new List<(EngineCollider Collider, EnginePush Push)>();
        var crate = new EngineCollider("crate", new BoxShape(Vector3d.Zero, new Vector3d(0.3, 0.4, 1.2))) { Mass = 2 };
        for (int i = 0; i < 200; i++)
        {
            var at = new Vector3d(random.NextDouble(), random.NextDouble(), 9 * random.NextDouble());
            Vector3d velocity = at * random.NextDouble();
            var turned = Quaterniond.FromAxisAngle(Vector3d.Up, random.NextDouble());
            Put();
            RigidMotion before = crate.Placement.Motion;
            Bounds3d box = crate.Placement.BoundsAt(0.3);
            pushes.Read(kept);
            for (int k = 0; k < 2; k++)
            {
                pushes.Note(crate);
                crate.Push(crate.Placement.Motion.Velocity + (at / 3), 0.1 + (random.NextDouble() / 7));
                if (isPlacedAgain)
                {
                    Put();
                }
            }

            pushes.Write(kept);
            Assert.True(before.IsSame(crate.Placement.Motion));
            Assert.Equal(box, crate.Placement.BoundsAt(0.3));

            void Put()
            {
                crate.MoveTo(at, turned, velocity, Vector3d.Zero);
                crate.FoundAt(0.1);
            }
        }
    }

    /// <summary>Pushes of earlier times of the engine end at the next step of a group, so that they hold nobody together.</summary>
    [Fact]
    public void A_step_of_a_group_forgets_pushes_of_earlier_times()
    {
        var crate = new EngineCollider("crate", new SphereShape(Vector3d.Zero, 1)) { Mass = 2 };
        var engine = new Rigid(crate);
        EngineThings things = ThingsOf(engine);
        crate.MoveTo(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
        crate.FoundAt(0);
        things.Pushes.Note(crate);
        crate.Push(new Vector3d(1, 0, 0), 0);
        things.BeginPushes();
        Assert.True(things.Pushes.Has(0, 0, 0.01, out _));
        engine.Time = 0.01;
        things.BeginPushes();
        Assert.False(things.Pushes.Has(0, 0.01, 0.01, out _));
    }

    /// <summary>The engine has its own clock: a collider that moves is found where it may be when the ball passes, whichever clock is ahead.</summary>
    [Theory]
    [InlineData(0, 0)]
    [InlineData(0.5, 0)]
    [InlineData(0, 0.5)]
    [InlineData(-0.5, 0)]
    [InlineData(3, 3.2)]
    public void A_cast_is_wider_by_the_way_between_the_clocks(double time, double engineTime)
    {
        const double Duration = 0.25;
        var engine = new Rigid(new EngineCollider("box", new SphereShape(Vector3d.Zero, 1))) { MaximumSpeed = 8, Time = engineTime };
        EngineThings things = ThingsOf(engine);
        things.LookAlong(PathCubic.Line(Vector3d.Zero, new Vector3d(4, 0, 0), Duration), time);
        double apart = Math.Max(Math.Abs(time - engineTime), Math.Abs(time + Duration - engineTime));
        Assert.Equal(Radius + 0.02 + (8 * apart), engine.Last.Radius, 1e-9);
        Assert.Equal(1, engine.Last.Distance, 1e-9);
    }

    /// <summary>A carrier that the engine no longer has does not carry: the ball falls.</summary>
    [Fact]
    public void A_ball_on_an_unknown_collider_falls()
    {
        var engine = new ShapesAsEngine();
        engine.Add("floor", new PlaneShape(Vector3d.Zero, Vector3d.Up));
        var simulator = new Simulator(new Scene { Ball = new BallProperties { Radius = Radius }, Air = new Air { Density = 0 }, Gravity = 9.81, Ground = Ground.None, EngineColliders = engine });
        BallState state = simulator.Launch(new Vector3d(0, 3, 0), Vector3d.Zero, Vector3d.Zero);
        state.Motion = MotionState.Rest;
        foreach (int carrier in new[] { EngineCollider.FirstNumber, EngineCollider.FirstNumber + 1, new EngineCollider("gone").Number })
        {
            BallState ball = state;
            ball.Carrier = carrier;
            var log = new StepLog();
            simulator.Step(ref ball, 0.1, log);
            simulator.Step(ref ball, 0.1, log);
            Assert.Equal(MotionState.Airborne, ball.Motion);
            Assert.Equal(3 - (0.5 * 9.81 * 0.04), ball.Position.Y, 1e-9);
        }
    }

    /// <summary>A state stores the number of a collider; the colliders of the last step have indices.</summary>
    [Fact]
    public void The_number_of_a_carrier_finds_its_collider_in_the_last_step()
    {
        var engine = new ShapesAsEngine();
        engine.Add("wall", new PlaneShape(new Vector3d(-0.3, 0, 0), new Vector3d(1, 0, 0)));
        engine.Add("floor", new PlaneShape(Vector3d.Zero, Vector3d.Up));
        var simulator = new Simulator(new Scene { Ground = Ground.None, EngineColliders = engine });
        BallState state = simulator.Launch(new Vector3d(-0.15, 0.3, 0), Vector3d.Zero, Vector3d.Zero);
        simulator.Run(ref state, 0.01, 20, StopAt.Rest, new StepLog());
        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.InRange(state.Carrier, EngineCollider.FirstNumber, long.MaxValue);
        simulator.Step(ref state, 0.01, new StepLog());
        Assert.Equal("floor", simulator.World.Colliders[simulator.World.ColliderOf(state.Carrier, state.Position, state.Time)].Name);
    }

    /// <summary>Pushes hold until the engine's time advances. A look-ahead keeps those of the step that goes on after it.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_push_at_a_later_time_ends_earlier_ones_except_in_a_look_ahead(bool looksAhead)
    {
        var pushes = EnginePushes.Of(new ShapesAsEngine());
        var kept = new List<(EngineCollider Collider, EnginePush Push)>();
        EngineCollider[] all = [.. Enumerable.Range(0, 3).Select(i => new EngineCollider($"{i}", new SphereShape(Vector3d.Zero, 1)) { Mass = 2 })];
        foreach (EngineCollider collider in all)
        {
            collider.MoveTo(new Vector3d(collider.Number % 7, 0, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
            collider.FoundAt(0);
        }

        Push(all[0], 0);
        Push(all[1], 0);
        Push(all[0], 0);
        Assert.Equal(2, Count());
        Assert.Equal(new Vector3d(2, 0, 0), all[0].Placement.Motion.Velocity);
        if (looksAhead)
        {
            pushes.Read(kept);
            pushes.Hold(kept);
        }

        // The engine places all of them again, at a later time.
        foreach (EngineCollider collider in all)
        {
            collider.MoveTo(new Vector3d(collider.Number % 7, 1, 0), Quaterniond.Identity, Vector3d.Zero, Vector3d.Zero);
            collider.FoundAt(0.5);
        }

        Push(all[2], 0.5);
        Assert.Equal(looksAhead ? 3 : 1, Count());
        Assert.Equal(looksAhead ? 0 : double.NaN, all[0].PushedAt);
        if (looksAhead)
        {
            pushes.Write(kept);
            pushes.Hold(null);
            Assert.Equal(2, Count());
            Assert.Equal(new Vector3d(2, 0, 0), all[0].Placement.Motion.Velocity);
            Assert.Equal(Vector3d.Zero, all[2].Placement.Motion.Velocity);
        }

        pushes.Forget();
        Assert.Equal(0, Count());
        Assert.All(all, collider => Assert.Equal(Vector3d.Zero, collider.Placement.Motion.Velocity));

        void Push(EngineCollider collider, double time)
        {
            pushes.Note(collider);
            collider.Push(collider.Placement.Motion.Velocity + new Vector3d(1, 0, 0), time);
        }

        int Count()
        {
            int count = 0;
            while (pushes.Has(count, 0, 0.1, out Bounds3d box))
            {
                // At least the collider now, and where it goes in the step.
                Assert.True(box.Max.X - box.Min.X >= 2.1 - 1e-9, $"{box.Min} {box.Max}");
                count++;
            }

            return count;
        }
    }

    private static EngineThings ThingsOf(IEngineColliders engine) =>
        new Simulator(new Scene { Ball = new BallProperties { Radius = Radius }, Ground = Ground.None, EngineColliders = engine }).World!.Engine!;

    /// <summary>An engine that finds one collider everywhere.</summary>
    private sealed class Rigid(EngineCollider collider) : IEngineColliders
    {
        public double Time { get; set; }

        public double MaximumSpeed { get; set; }

        public SphereCast Last { get; private set; }

        public void Cast(in SphereCast cast, EngineHits hits)
        {
            Last = cast;
            hits.Add(collider);
        }
    }
}
