using FootballPhysics.Contacts;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;
using FootballPhysics.Simulation;
using FootballPhysics.Yardsticks;

namespace FootballPhysics.Tests.Things;

/// <summary>A step depends on the state, the motions of the objects and the scene, and never on earlier searches.</summary>
public sealed class OneAnswerTests
{
    private const double Tick = 1.0 / 60;

    /// <summary>The search for bodies has one result, whether or not the boxes of the bodies were read before.</summary>
    [Fact]
    public void A_search_among_turned_bodies_does_not_depend_on_what_was_read_before()
    {
        int reached = 0;
        int corners = 0;
        for (int seed = 0; seed < 40_000; seed++)
        {
            var random = new SeededRandom(SeededRandom.Mix(71, seed));
            IShape shape = random.Any<IShape>(new BoxShape(new Vector3d(0.2, 0.1, 0), new Vector3d(0.5, 0.1, 0.05)), new CapsuleShape(new Vector3d(0, 0.2, 0), new Vector3d(0, 1.5, 0), 0.2));
            Vector3d at = random.Uniform(0, 2) * random.Direction();
            Quaterniond turned = Quaterniond.FromAxisAngle(random.Direction(), random.Uniform(-3, 3));
            Vector3d spin = random.Chance(0.3) ? random.Uniform(0, 20) * random.Direction() : Vector3d.Zero;
            Vector3d velocity = random.Uniform(0, 8) * random.Direction();
            Vector3d from = random.Uniform(0, 2) * random.Direction();
            Vector3d way = random.Uniform(0, 20) * random.Direction();
            double around = random.Uniform(0.1, 1);
            double[] free = new double[3];
            for (int k = 0; k < free.Length; k++)
            {
                var bodies = new KinematicBodies();
                KinematicBody body = bodies.Add("body", shape);
                body.MoveTo(at, turned, velocity, spin, 0);
                _ = k == 1 ? body.BoundsAt(0) : default;
                _ = k == 2 ? bodies.FreeFor(in at, in way, 0, 0.02, 3, ignores: 0) : 0;
                free[k] = bodies.FreeFor(in from, in way, 0, 0.02, around, ignores: 0);
                corners += k == 1 && free[k] == 0.02 && new StraightWay(in from, way - velocity, 0, 0.02, around).Meets(body.BoundsDuring(0, 0.02)) < 0.02 ? 1 : 0;
            }

            Assert.Equal(free[0], free[1]);
            Assert.Equal(free[0], free[2]);
            reached += free[0] < 0.02 ? 1 : 0;
        }

        // There are paths that the box alone would reach, at a corner that the sphere does not have.
        Assert.InRange(reached, 4000, 36_000);
        Assert.InRange(corners, 100, int.MaxValue);
    }

    /// <summary>Wherever the tube holds, the search for that step alone finds no body: a remembered tube and none have the same result.</summary>
    [Theory]
    [InlineData(1.0)]
    [InlineData(1.6)]
    public void A_tube_never_allows_more_than_the_search_of_its_step(double friction)
    {
        int held = 0;
        int near = 0;
        for (int seed = 0; seed < 1000; seed++)
        {
            var random = new SeededRandom(SeededRandom.Mix(72, seed));
            var bodies = new KinematicBodies();
            for (int i = 1 + random.Below(3); i > 0; i--)
            {
                KinematicBody body = bodies.Add("body", new BoxShape(new Vector3d(0.1, 0, 0), new Vector3d(0.6, 0.3, 0.1)));
                Vector3d spin = random.Chance(0.5) ? random.Uniform(0, 9) * random.Direction() : Vector3d.Zero;
                body.MoveTo(random.Uniform(1, 3) * random.Direction(), Quaterniond.FromAxisAngle(random.Direction(), random.Uniform(-3, 3)), random.Uniform(0, 4) * random.Direction(), spin, random.Uniform(0, 0.1));
            }

            Scene scene = Scene.Default with { Ground = Ground.None, Bodies = bodies };
            var world = new World(scene);
            ClearFlight remembers = Clear(scene, world);
            BallState s = new Simulator(scene).Launch(random.Uniform(0, 0.5) * random.Direction(), random.Uniform(0, 30) * random.Direction(), Vector3d.Zero);
            double spinRate = random.Uniform(0, 60);
            double dt = random.Any(0.004, Tick, 1 / 30.0);
            for (int step = 0; step < 40; step++)
            {
                double h = dt * random.Uniform(0.3, 1.15);
                double airSpeedSquared = s.Velocity.LengthSquared * random.Uniform(0.8, 1.2);
                bool holds = s.ClearUntil >= s.Time + h && remembers.Tube!.Holds(in s, h, airSpeedSquared, spinRate, friction);
                BallState fresh = s;
                bool isClear = remembers.Holds(ref s, h, airSpeedSquared, spinRate, friction);
                Assert.Equal(isClear, Clear(scene, world).Holds(ref fresh, h, airSpeedSquared, spinRate, friction));
                Assert.Equal(s, fresh);
                held += holds ? 1 : 0;
                near += isClear ? 0 : 1;

                // Now and then the ball leaves its way, to the edge of the tube.
                s.Position += (h * s.Velocity) + (random.Uniform(0, 0.05) * random.Direction());
                s.Velocity += random.Uniform(0, 1) * random.Direction();
                s.Time += h;
            }
        }

        Assert.InRange(held, 1000, int.MaxValue);
        Assert.InRange(near, 1000, int.MaxValue);
    }

    /// <summary>A body that is told its own motion, and a new body that is told the same, have the bits of the first.</summary>
    [Fact]
    public void A_body_that_is_told_its_own_motion_keeps_its_bits()
    {
        var random = new SeededRandom(73UL);
        for (int i = 0; i < 3000; i++)
        {
            KinematicBody body = Body();
            var any = new Quaterniond(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
            body.MoveTo(random.Direction(), i % 2 == 0 ? any : any.Normalized(), random.Direction(), (i % 3) * random.Direction(), 0);
            if (i % 5 == 0)
            {
                body.Push(random.Direction(), random.Uniform(0, 0.1));
            }

            RigidMotion motion = body.Motion;
            foreach (KinematicBody told in new[] { body, Body() })
            {
                told.MoveTo(motion.Origin, motion.Orientation, motion.Velocity, motion.Spin, motion.Time);
                Assert.True(motion.IsSame(told.Motion));
                Assert.Equal((motion.Swing, motion.IsTurned, motion.Time), (told.Motion.Swing, told.Motion.IsTurned, told.Motion.Time));
                Assert.Equal(body.BoundsDuring(0, 0.01), told.BoundsDuring(0, 0.01));
            }
        }

        static KinematicBody Body() => new KinematicBodies().Add("board", new BoxShape(new Vector3d(0.1, 0, 0), new Vector3d(0.6, 0.3, 0.1)), mass: 3);
    }

    /// <summary>A withdrawn body has no speed left, as one whose motion is restored.</summary>
    [Fact]
    public void A_withdrawn_body_does_not_swing()
    {
        KinematicBody body = new KinematicBodies().Add("board", new BoxShape(Vector3d.Zero, new Vector3d(0.6, 0.3, 0.1)));
        body.MoveTo(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Up, 0);
        Assert.True(body.Motion.Rotates);
        body.Withdraw();
        Assert.Equal(0, body.Motion.GreatestSpeed);
    }

    /// <summary>A rotation by nothing leaves a body unturned: its box has the bits of the shape's own box.</summary>
    [Fact]
    public void A_push_at_the_time_of_a_move_turns_nothing()
    {
        KinematicBody body = new KinematicBodies().Add("board", new BoxShape(new Vector3d(0.1, 0.2, 0.3), new Vector3d(0.6, 0.3, 0.1)), mass: 3);
        body.MoveTo(Vector3d.Zero, Quaterniond.Identity, Vector3d.Zero, Vector3d.Up, 0.5);
        body.Push(new Vector3d(1, 0, 0), 0.5);
        Assert.False(body.Motion.IsTurned);
    }

    /// <summary>A path of a group, or a step of copies, between the moves of the bodies and the step leaves the moves to the recording of the step.</summary>
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void What_is_asked_between_a_move_and_its_step_does_not_hide_the_move_from_a_recording(bool drawsPath)
    {
        FixedStepRunner runner = Runner(out KinematicBodies bodies, out BallGroup group);
        Recording recording = runner.Record();
        Trajectory[] paths = [new Trajectory(), new Trajectory()];
        for (int tick = 0; tick < 30; tick++)
        {
            bodies[0].MoveTo(new Vector3d(0.05 * tick, 0, 0.4 - (0.02 * tick)), Quaterniond.FromAxisAngle(Vector3d.Up, 0.1 * tick), new Vector3d(3, 0, -1.2), Vector3d.Zero, runner.Time);
            BallState[] copies = [runner.StateOf(0), runner.StateOf(1)];
            if (drawsPath)
            {
                group.LookAhead(copies, new LookAheadRequest { Duration = 0.2, TimeStep = Tick }, paths);
            }
            else
            {
                group.Step(copies, Tick, new StepLog());
            }

            runner.Step();
        }

        Runner(out _, out BallGroup fresh);
        Assert.Null(recording.FirstDivergence(fresh));
        Assert.True(runner.StateOf(0).Velocity.Length > 1);

        static FixedStepRunner Runner(out KinematicBodies bodies, out BallGroup group)
        {
            bodies = new KinematicBodies();
            bodies.Add("player", BodyKind.Player);
            group = new BallGroup(new Simulator(Scene.Default with { Bodies = bodies }), 2);
            var runner = new FixedStepRunner(group, Tick);
            runner.Place(new Vector3d(0.6, 0.11, 0), 0);
            runner.Place(new Vector3d(3, 0.11, 0), 1);
            return runner;
        }
    }

    /// <summary>A heap at rest is restored from its bytes, also the balls that only other balls carry. A ball in the ground is not.</summary>
    [Fact]
    public void A_heap_at_rest_is_restored()
    {
        var simulator = new Simulator(Scene.Default);
        const double Radius = 0.11;
        const int Balls = 5;
        var runner = new FixedStepRunner(new BallGroup(simulator, Balls), Tick);
        runner.RestoreAll(0, [.. Enumerable.Range(0, Balls).Select(i => simulator.Launch(new Vector3d(2 * Radius * (i < 3 ? i : i - 2.5), i < 3 ? Radius : 2.8 * Radius, 0), Vector3d.Zero, Vector3d.Zero))]);
        for (int tick = 0; tick < 120; tick++)
        {
            runner.Step();
        }

        BallState[] heap = [.. Enumerable.Range(0, Balls).Select(runner.StateOf)];
        Assert.All(heap, ball => Assert.Equal(MotionState.Rest, ball.Motion));
        Assert.True(heap[4].Position.Y > 2.5 * Radius);
        var bytes = new byte[Snapshot.Size];
        BallState[] read = [.. heap.Select(ball => Read(ball, bytes))];
        var other = new FixedStepRunner(new BallGroup(simulator, Balls), Tick);
        other.RestoreAll(runner.Tick, read);
        foreach (FixedStepRunner each in new[] { runner, other })
        {
            each.Kicks.Add(new KickInput(each.Tick + 3, new Vector3d(4, 1, 2), Vector3d.Zero, 0, 1));
            for (int tick = 0; tick < 30; tick++)
            {
                each.Step();
            }
        }

        Assert.Equal(Enumerable.Range(0, Balls).Select(runner.StateOf), Enumerable.Range(0, Balls).Select(other.StateOf));
        Assert.NotEqual(heap[4].Position, runner.StateOf(4).Position);
        heap[4].Position = new Vector3d(heap[4].Position.X, 0.5 * Radius, heap[4].Position.Z);
        Assert.Throws<ArgumentOutOfRangeException>(() => simulator.Validate(in heap[4]));

        static BallState Read(BallState ball, byte[] bytes)
        {
            Snapshot.Write(in ball, bytes);
            return Snapshot.Read(bytes);
        }
    }

    /// <summary>A ball that is launched with the spin of a launched ball has its bits, also if rounding changes the spin of the first launch.</summary>
    [Fact]
    public void A_ball_launched_from_the_spin_of_another_has_its_bits()
    {
        var simulator = new Simulator();
        int rounded = 0;
        for (int seed = 0; seed < 100_000; seed++)
        {
            var random = new SeededRandom(SeededRandom.Mix(74, seed));
            Vector3d spin = (seed % 2 == 0 ? random.Uniform(0, 30) : random.Log(1e-150, 10_000)) * random.Direction();
            BallState launched = simulator.Launch(new Vector3d(0, 1, 0), Vector3d.Zero, spin);
            Assert.Equal(launched, simulator.Launch(launched.Position, launched.Velocity, launched.Spin));
            Assert.True((launched.Spin - spin).Length <= (1e-14 * spin.Length) + 1e-140);
            BallState kicked = launched;
            simulator.Kick(ref kicked, Vector3d.Zero, launched.Spin);
            Assert.Equal(launched.Spin, kicked.Spin);
            rounded += launched.Spin != spin ? 1 : 0;
        }

        Assert.InRange(rounded, 1000, int.MaxValue);
    }

    private static ClearFlight Clear(Scene scene, World world)
    {
        var air = SceneAir.Of(scene);
        double weight = scene.Gravity;
        return new ClearFlight(world, StabilityLimit.Of(scene, in air, 0, -weight, 4), StabilityLimit.WithFall(air.OrdinaryBound, weight), Vector3d.Zero, weight, 0.5);
    }
}
