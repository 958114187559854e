using FootballPhysics.Contacts;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Nets, mouths and lines of goals are met on whatever way a ball comes to its place; a kick, or another scene, takes it out of none.</summary>
public sealed class PassageTests
{
    private const double Tick = 1.0 / 60;

    /// <summary>The mouth of the goal of these scenes, and where all of a ball is over its line.</summary>
    private const double Mouth = -20;
    private const double Line = Mouth - 0.06 - 0.11;

    private static readonly Goal s_goal = new() { Center = new Vector3d(0, 0, Mouth), Facing = new Vector3d(0, 0, 1) };
    private static readonly Scene s_scene = Scene.Default with { Goals = [s_goal] };

    [Fact]
    public void A_kick_with_the_velocity_that_the_ball_has_changes_nothing_in_a_net()
    {
        var simulator = new Simulator(s_scene);
        BallState left = DeepInTheBackNet(simulator);
        BallState kicked = left;
        simulator.Kick(ref kicked, left.Velocity, left.Spin);
        Assert.NotEqual(0UL, left.Nets);
        Assert.Equal((left.Nets, left.NetSides), (kicked.Nets, kicked.NetSides));
        var log = new StepLog();
        for (int i = 0; i < 240; i++)
        {
            simulator.Step(ref left, Tick, log);
            simulator.Step(ref kicked, Tick, log);
            Assert.Equal(0, (left.Position - kicked.Position).Length, 1e-9);
        }
    }

    [Fact]
    public void No_kick_takes_a_ball_out_of_the_goal_through_its_nets()
    {
        var random = new Shots(81);
        var simulator = new Simulator(s_scene);
        int beyond = 0;
        for (int i = 0; i < 150; i++)
        {
            BallState state = InTheNets(simulator, random, out bool isBeyond);
            beyond += isBeyond ? 1 : 0;
            simulator.Kick(ref state, new Vector3d(random.Uniform(-3, 3), random.Uniform(0, 3), random.Uniform(2, 9)), Vector3d.Zero);
            Play(simulator, ref state, 5);
            Assert.True(Outside(state.Position) < 0.2, $"shot {i}: {state.Position}");
        }

        Assert.InRange(beyond, 20, 150);
    }

    /// <summary>A rollback plays the kick again that came late, from a state of then.</summary>
    [Fact]
    public void A_late_kick_in_a_net_gives_the_bits_of_the_kick_in_time()
    {
        ulong late = Hash(isLate: true, out Vector3d rests);
        Assert.Equal(Hash(isLate: false, out _), late);
        Assert.True(Outside(rests) < 0, $"{rests}");

        static ulong Hash(bool isLate, out Vector3d rests)
        {
            var runner = new FixedStepRunner(new Simulator(s_scene), Tick);
            runner.Place(new Vector3d(-1.5, 0.11, -10));
            runner.QueueKick(new Vector3d(0, 4, -32), default(Vector3d));
            var rollback = new Rollback(runner, 100);
            long deepest = 0;
            while (runner.Tick < 300)
            {
                double z = runner.State.Position.Z;
                runner.Step();
                bool isDeepest = deepest == 0 && z < Mouth - 1 && runner.State.Position.Z > z;
                deepest = isDeepest ? runner.Tick : deepest;
                if (deepest > 0 && runner.Tick == deepest + (isLate ? 30 : 0))
                {
                    rollback.ApplyKick(new KickInput(deepest, new Vector3d(0, 1, 6), default, 3));
                }
            }

            rests = runner.State.Position;
            return Snapshot.Hash(runner.State);
        }
    }

    /// <summary>Nets are known by where they hang: their numbers in the other scene may be others.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void Another_scene_leaves_the_ball_in_the_net(bool isRunner)
    {
        Goal other = s_goal with { Center = new Vector3d(0, 0, -Mouth), Facing = new Vector3d(0, 0, -1) };
        Scene[] scenes = [s_scene with { Ground = Ground.Of(SurfaceMaterial.WetTurf) }, s_scene with { Goals = [other, s_goal] }, s_scene with { Nets = [new Net { Center = new Vector3d(9, 1, 9), Normal = new Vector3d(1, 0, 0), Along = new Vector3d(0, 0, 1), HalfLength = 1, HalfWidth = 1 }] }];
        foreach (Scene next in scenes)
        {
            var simulator = new Simulator(s_scene);
            BallState state = DeepInTheBackNet(simulator);
            string? old = NetOf(simulator, in state);
            var ball = new Ball(simulator) { State = state };
            var runner = new FixedStepRunner(simulator, Tick);
            runner.Restore(0, state);
            var compiled = new Simulator(next);
            ball.Simulator = compiled;
            runner.Simulator = compiled;
            state = isRunner ? runner.State : ball.State;
            Assert.Equal("back net", old);
            Assert.Equal(old, NetOf(compiled, in state));
            Play(compiled, ref state, 5);
            Assert.True(Outside(state.Position) < 0, $"{state.Position}");
        }
    }

    [Fact]
    public void A_goal_is_reported_once_also_where_rain_begins_after_it()
    {
        var ball = new Ball(s_scene);
        ball.Place(new Vector3d(0, 0.11, -19.5));
        ball.Kick(new Vector3d(0, 0, -6), default);
        int goals = 0;
        for (int i = 0; i < 300; i++)
        {
            ball.Step(Tick);
            goals += Goals(ball.Events);
            if (i == 30)
            {
                Assert.Equal(1, goals);
                ball.Simulator = new Simulator(s_scene with { Ground = Ground.Of(SurfaceMaterial.WetTurf) });

                // Out of the mouth and in again, without a kick.
                BallState state = ball.State;
                state.Position = new Vector3d(0, 0.11, -19.5);
                state.Velocity = new Vector3d(0, 0, -6);
                state.SetGroundSpin(new Vector3d(-6 / 0.11, 0, 0));
                state.Motion = MotionState.Rolling;
                ball.State = state;
            }
        }

        Assert.Equal(1, goals);
    }

    [Fact]
    public void A_ball_at_rest_on_the_roof_stays_so_in_the_same_net_of_another_scene()
    {
        var simulator = new Simulator(s_scene);
        BallState state = simulator.Launch(new Vector3d(0.5, 2.9, -20.4), new Vector3d(0.3, 0, 0), Vector3d.Zero);
        Assert.True(simulator.Run(ref state, Tick, 60, StopAt.Rest, new StepLog()));
        var ball = new Ball(simulator) { State = state };
        ball.Simulator = new Simulator(s_scene with { Ground = Ground.Of(SurfaceMaterial.WetTurf), Obstacles = [new Obstacle { Shape = new SphereShape(new Vector3d(9, 1, 0), 0.1) }] });
        Assert.Equal(MotionState.Rest, ball.Motion);
        Assert.Equal("roof net", ball.Simulator.NameOf((int)ball.State.Carrier));
        ball.Step(1.0);
        Assert.Equal(state.Position, ball.Position);

        // Without the net it falls.
        ball.Simulator = new Simulator();
        ball.Step(2.0);
        Assert.True(ball.Position.Y < 1);
    }

    [Theory]
    [InlineData(0.04, 0UL)]
    [InlineData(-0.04, 1UL)]
    public void A_ball_that_is_put_into_a_net_is_on_the_side_of_its_centre(double before, ulong behind)
    {
        // The side net at +x; its normal points into the goal or out of it, the depth tells.
        var simulator = new Simulator(s_scene);
        var ball = new Ball(simulator);
        ball.Place(new Vector3d(3.72 - before, 0.11, -20.6));
        BallState state = ball.State;
        int net = simulator.World.Nets.ToList().FindIndex(sheet => Math.Abs(sheet.PlaceInFrame(state.Position).Z) < 0.05);
        Assert.Equal(1UL, state.Nets >> net & 1);
        Assert.Equal(0.11 - 0.04, simulator.World.Nets[net].Depth(state.Position, NetSheet.SideOf(state.NetSides, net)), 1e-9);
        Assert.Equal(MotionState.Rolling, state.Motion);

        // The net pushes it away, off that side.
        Play(simulator, ref state, 3);
        Assert.Equal(behind == 1, state.Position.X > 3.72 + 0.1);
        Assert.Equal(behind == 0, state.Position.X < 3.72 - 0.1);
    }

    /// <summary>A body is put over a ball, and that out of it: through the mouth, over the line, or into a net.</summary>
    [Theory]
    [InlineData(-20.1, 1)]
    [InlineData(-19.9, 1)]
    [InlineData(-19.5, 0)]
    public void A_ball_that_a_body_pushes_over_the_line_is_a_goal(double from, int expected)
    {
        var bodies = new KinematicBodies();
        KinematicBody pusher = bodies.Add("pusher", new SphereShape(Vector3d.Zero, 0.3), SurfaceMaterial.Boot);
        var simulator = new Simulator(s_scene with { Bodies = bodies });
        BallState state = simulator.Launch(new Vector3d(0, 0.11, from), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        pusher.MoveTo(new Vector3d(0, 0.11, from + 0.05), Vector3d.Zero, 0);
        simulator.Step(ref state, Tick, log);
        Assert.Equal(from - 0.36, state.Position.Z, 1e-6);
        Assert.Equal(expected, Goals(log.Events));

        // And it is over the line once, whatever follows.
        simulator.Step(ref state, Tick, log);
        Assert.Equal(expected, Goals(log.Events));
    }

    [Fact]
    public void A_ball_that_a_body_pushes_into_a_net_is_in_it()
    {
        var bodies = new KinematicBodies();
        KinematicBody pusher = bodies.Add("pusher", new SphereShape(Vector3d.Zero, 0.3), SurfaceMaterial.Boot);
        var simulator = new Simulator(s_scene with { Bodies = bodies });
        BallState state = simulator.Launch(new Vector3d(3.5, 0.11, -20.6), Vector3d.Zero, Vector3d.Zero);
        Assert.Equal(0UL, state.Nets);
        var log = new StepLog();
        pusher.MoveTo(new Vector3d(3.4, 0.11, -20.6), Vector3d.Zero, 0);
        simulator.Step(ref state, 1e-4, log);
        pusher.MoveTo(new Vector3d(0, 50, 0), Vector3d.Zero, state.Time);
        Assert.Single(log.Events.Span.ToArray(), item => item.Kind == BallEventKind.Net);
        Assert.True(state.Position.X > 3.72, $"{state.Position}");
        Play(simulator, ref state, 3);
        Assert.True(state.Position.X < 3.72, $"{state.Position}");
    }

    /// <summary>A thin board behind the mouth stops a push that comes through the mouth first.</summary>
    [Fact]
    public void A_push_through_a_mouth_does_not_go_through_a_board()
    {
        var bodies = new KinematicBodies();
        KinematicBody pusher = bodies.Add("pusher", new SphereShape(Vector3d.Zero, 0.3), SurfaceMaterial.Boot);
        var board = new Obstacle { Shape = new BoxShape(new Vector3d(0, 0.5, -20.1), new Vector3d(1, 0.5, 0.005)) };
        var simulator = new Simulator(s_scene with { Bodies = bodies, Obstacles = [board] });
        BallState state = simulator.Launch(new Vector3d(0, 0.11, -19.95), Vector3d.Zero, Vector3d.Zero);
        var log = new StepLog();
        pusher.MoveTo(new Vector3d(0, 0.11, -19.94), Vector3d.Zero, 0);
        simulator.Step(ref state, Tick, log);
        Assert.True(state.Position.Z > -20.1, $"{state.Position}");
        Assert.Equal(0, Goals(log.Events));
    }

    /// <summary>The walk of a player who squeezes the ball over the line, alone and in a group, whose steps end at other places.</summary>
    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_squeezed_ball_that_is_over_the_line_is_one_goal(bool inGroup)
    {
        var random = new Shots(82);
        int over = 0;
        for (int i = 0; i < 120; i++)
        {
            double radius = random.Uniform(0.29, 0.296);
            double speed = random.Uniform(3.1, 3.4);
            var bodies = new KinematicBodies();
            KinematicBody player = bodies.Add("player", new CapsuleShape(new Vector3d(0, radius, 0), new Vector3d(0, 1.5, 0), radius), SurfaceMaterial.Boot, 75);
            var simulator = new Simulator(Pitch.Futsal.On(new Scene { Bodies = bodies }));
            double line = random.Uniform(-19.97, -19.95);
            BallState[] states = [simulator.Launch(new Vector3d(0.25, 0.11, line), Vector3d.Zero, Vector3d.Zero)];
            BallGroup? group = inGroup ? new BallGroup(simulator, 1) : null;
            var log = new StepLog();
            var at = new Vector3d(0.25 + random.Uniform(-0.014, -0.011), 0, line + radius + 0.11 + random.Uniform(0.19, 0.2));
            int goals = 0;
            for (int tick = 0; tick < 20; tick++)
            {
                Vector3d velocity = at.Z > -20.1 ? new Vector3d(0, 0, -speed) : Vector3d.Zero;
                player.MoveTo(at, velocity, states[0].Time);
                at += Tick * velocity;
                log.Clear();
                if (group is null)
                {
                    simulator.Step(ref states[0], Tick, log);
                }
                else
                {
                    group.Step(states, Tick, log);
                }

                goals += Goals(log.Events);
            }

            bool isOver = states[0].Position.Z < -20.2;
            over += isOver ? 1 : 0;
            Assert.Equal(isOver ? 1 : 0, goals);
        }

        Assert.InRange(over, 60, 120);
    }

    /// <summary>A state that is rounded for the wire moves by half a millimetre: a slow ball is rounded through the mouth.</summary>
    [Fact]
    public void A_ball_that_is_rounded_through_the_mouth_has_come_through_it()
    {
        // The mouth lies between two places of the wire form.
        Scene scene = s_scene with { Goals = [s_goal with { Center = new Vector3d(0, 0, Mouth - 8e-4) }] };
        for (int i = 0; i < 200; i++)
        {
            var runner = new FixedStepRunner(new Simulator(scene), Tick) { QuantizationInterval = 1 };
            runner.Place(new Vector3d(0, 0.11, -19.95 - (1e-4 * i)));
            runner.QueueKick(new Vector3d(0, 0, -1.1), default(Vector3d));
            int goals = 0;
            for (int tick = 0; tick < 60; tick++)
            {
                runner.Step();
                goals += Goals(runner.Events);
            }

            Assert.True(runner.State.Position.Z < Line);
            Assert.Equal(1, goals);
        }
    }

    /// <summary>Rounded over the line at the end of a step, and kicked before the next: the goal is told all the same.</summary>
    [Fact]
    public void A_kick_does_not_take_the_ball_out_of_the_mouth()
    {
        var simulator = new Simulator(s_scene);
        BallState state = simulator.Launch(new Vector3d(0, 0.11, Line + 1e-4), Vector3d.Zero, Vector3d.Zero);
        Assert.Equal(1UL, state.GoalsEntered);
        state.Position = new Vector3d(0, 0.11, Line - 2e-4);
        simulator.Kick(ref state, new Vector3d(0, 0, -1), Vector3d.Zero);
        var log = new StepLog();
        simulator.Run(ref state, Tick, 0.5, StopAt.Time, log);
        Assert.Equal(1, Goals(log.Events));
    }

    private static int Goals(EventBuffer events) => events.Span.ToArray().Count(item => item.Kind == BallEventKind.Goal);

    private static string? NetOf(Simulator simulator, in BallState s) => simulator.NameOf(simulator.World.ThingOfNet(simulator.World.NetForces.Deepest(in s)));

    private static BallState DeepInTheBackNet(Simulator simulator)
    {
        BallState state = simulator.Launch(new Vector3d(-1.5, 0.11, -10.5), new Vector3d(0, 4, -32), Vector3d.Zero);
        var log = new StepLog();
        while (state.Time < 1 && !(state.Nets != 0 && state.Velocity.Z >= -0.3))
        {
            simulator.Step(ref state, 1e-3, log);
        }

        return state;
    }

    /// <summary>A shot into the goal, some steps after it has met a net.</summary>
    private static BallState InTheNets(Simulator simulator, Shots random, out bool isBeyond)
    {
        var from = new Vector3d(random.Uniform(-6, 6), 0.11, random.Uniform(-14, -8));
        Vector3d way = new Vector3d(random.Uniform(-3.2, 3.2), random.Uniform(0.3, 1.6), Mouth) - from;
        BallState state = simulator.Launch(from, (random.Uniform(16, 34) * way.Normalized()) + new Vector3d(0, random.Uniform(0.5, 3), 0), Vector3d.Zero);
        var log = new StepLog();
        while (state.Time < 3 && !(state.Nets != 0 && state.Position.Z < Mouth))
        {
            simulator.Step(ref state, Tick, log);
        }

        for (int wait = random.Chance(0.5) ? 3 : 8; wait > 0; wait--)
        {
            simulator.Step(ref state, Tick, log);
        }

        isBeyond = Outside(state.Position) > 0;
        return state;
    }

    private static void Play(Simulator simulator, ref BallState state, double duration) => simulator.Run(ref state, Tick, duration, StopAt.Time, new StepLog());

    /// <summary>How far a place is beyond the back, the side and the roof nets, m; negative in the goal, and before it.</summary>
    private static double Outside(Vector3d place)
    {
        // The back net slants from 0.8 m behind the line at 2.5 m down to 2 m behind it.
        double back = Mouth - 2 + (1.2 / 2.5 * place.Y) - place.Z;
        double beside = Math.Max(Math.Abs(place.X) - 3.72, place.Y - 2.5);
        return place.Z > Mouth ? -1 : Math.Max(back, beside);
    }
}
