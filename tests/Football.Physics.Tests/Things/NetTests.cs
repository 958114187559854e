using FootballPhysics.Contacts;
using FootballPhysics.Scenes;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Shots into the net: in how many pieces, and where their paths run.</summary>
public sealed class NetTests
{
    /// <summary>Pieces that a shot may take in steps of 10 ms while it flies in a net.</summary>
    private const int MostPieces = 64;

    /// <summary>The evaluations of a step: on average, and at most.</summary>
    private const double UsualEvaluations = 36;
    private const int MostEvaluations = 256;

    private static readonly Scene s_scene = Scene.Default with { Goals = [new Goal { Center = new Vector3d(0, 0, -20), Facing = new Vector3d(0, 0, 1) }] };

    [Theory]
    [InlineData(Integrator.Rk2)]
    [InlineData(Integrator.Rk4)]
    public void A_shot_into_the_net_takes_few_pieces(Integrator integrator)
    {
        var random = new Shots(64);
        var simulator = new Simulator(s_scene, Flight.With(integrator));
        var log = new StepLog();
        int shots = 0;
        long steps = 0;
        long evaluations = 0;
        for (int i = 0; i < 200; i++)
        {
            BallState state = Shot(simulator, random);
            long pieces = 0;
            bool met = false;
            while (state.Time < 5 && (!met || (state.Nets != 0 && state.Motion == MotionState.Airborne)))
            {
                log.Clear();
                simulator.Step(ref state, 0.01, log);
                met |= state.Nets != 0;
                pieces += met && state.Motion == MotionState.Airborne ? log.Steps : 0;
                steps += met ? 1 : 0;
                evaluations += met ? log.Evaluations : 0;
                Assert.True(log.Evaluations <= MostEvaluations, $"shot {i}: {log.Evaluations} evaluations in a step");
            }

            shots += met ? 1 : 0;
            Assert.True(pieces <= MostPieces, $"shot {i}: {pieces} pieces");
        }

        Assert.True(shots > 150);
        Assert.InRange((double)evaluations / steps, 12, UsualEvaluations);
    }

    /// <summary>A look-ahead of ten seconds holds a shot into the net in the memory that it has by default, and its path is that of steps twenty times as short.</summary>
    [Fact]
    public void A_look_ahead_into_the_net_is_complete_and_runs_where_short_steps_do()
    {
        var random = new Shots(65);
        var simulator = new Simulator(s_scene, Flight.With(Integrator.Rk4));
        var path = new Trajectory();
        int complete = 0;
        for (int i = 0; i < 60; i++)
        {
            BallState state = Shot(simulator, random);
            simulator.LookAhead(in state, new LookAheadRequest(), path);
            complete += path.IsComplete ? 1 : 0;
            var log = new StepLog();
            double until = Array.Find(path.Events.Span.ToArray(), item => item.Kind == BallEventKind.Net).Time + 0.1;
            while (state.Time < until)
            {
                simulator.Step(ref state, 0.0005, log);
                Assert.Equal(0, (path.PositionAt(state.Time) - state.Position).Length, 2e-5);
            }
        }

        Assert.InRange(complete, 60, 60);
    }

    /// <summary>What a shot into a corner presses out of one net is held by the other.</summary>
    [Fact]
    public void No_shot_gets_out_where_two_nets_are_joined()
    {
        var random = new Shots(66);
        var simulator = new Simulator(s_scene, Flight.With(Integrator.Rk4));
        var log = new StepLog();
        int lay = 0;
        for (int i = 0; i < 300; i++)
        {
            // Into the edges of the back net, from before the goal and from within.
            double across = random.Chance(0.5) ? random.Uniform(3.3, 3.6) : random.Uniform(-3.6, -3.3);
            var at = new Vector3d(random.Chance(0.7) ? across : random.Uniform(-3, 3), random.Uniform(0.2, 2.3), -21);
            var from = new Vector3d(random.Uniform(-3, 3), random.Uniform(0.3, 2), random.Chance(0.5) ? -19 : -20.4);
            BallState state = simulator.Launch(from, random.Uniform(5, 60) * (at - from).Normalized(), 40 * new Vector3d(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1)));
            bool inside = from.Z < -20;
            while (state.Time < 20 && state.Motion != MotionState.Rest)
            {
                log.Clear();
                BallState before = state;
                simulator.Step(ref state, 0.01, log);
                inside |= before.Position.Z > -20 && state.Position.Z <= -20 && Math.Abs(state.Position.X) < 3.66 && state.Position.Y < 2.44;
                inside &= state.Position.Z < -20;
            }

            lay += inside ? 1 : 0;
            Assert.True(!inside || (Math.Abs(state.Position.X) < 3.9 && state.Position.Z > -22.3 && state.Position.Y < 2.6), $"shot {i}: {from} to {at}, ends at {state.Position}");
        }

        Assert.InRange(lay, 100, 300);
    }

    /// <summary>A net has a length and a width: beyond them nothing holds a ball.</summary>
    [Fact]
    public void A_ball_rolls_off_the_roof_of_a_goal()
    {
        var simulator = new Simulator(s_scene);
        BallState state = simulator.Launch(new Vector3d(3, 2.7, -20.4), new Vector3d(5, 0, 0), Vector3d.Zero);
        var log = new StepLog();
        bool met = false;
        for (int i = 0; i < 1000 && state.Motion != MotionState.Rest; i++)
        {
            log.Clear();
            simulator.Step(ref state, 1.0 / 60, log);
            met |= state.Nets != 0;
            bool beside = state.Position.X > 3.66 + 0.06 + 0.3;
            Assert.True(!beside || state.Nets == 0, $"{state.Time}: {state.Position}");
        }

        Assert.True(met);
        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.Equal(0.11, state.Position.Y, 1e-12);
    }

    /// <summary>And one that stays on it comes to rest there: told, kept in a snapshot, and woken by a kick, by a body and by another ball.</summary>
    [Fact]
    public void A_ball_comes_to_rest_on_the_roof_of_a_goal()
    {
        var bodies = new KinematicBodies();
        KinematicBody boot = bodies.Add("boot", new SphereShape(Vector3d.Zero, 0.1), SurfaceMaterial.Boot);
        boot.MoveTo(new Vector3d(0, 50, 0), Vector3d.Zero, 0);
        var simulator = new Simulator(s_scene with { Bodies = bodies });
        BallState state = simulator.Launch(new Vector3d(0.5, 2.9, -20.4), new Vector3d(0.3, 0, 0), Vector3d.Zero);
        var log = new StepLog();
        Assert.True(simulator.Run(ref state, 1.0 / 60, 60, StopAt.Rest, log));
        Assert.Equal(MotionState.Rest, state.Motion);
        Assert.Equal("roof net", simulator.NameOf((int)state.Carrier));
        Assert.Single(log.Events.Span.ToArray(), item => item.Kind == BallEventKind.Rest);
        simulator.Validate(in state);

        // It hangs where the net bears its weight, less what the air bears: k δ = m g'.
        double bears = s_scene.Ball.Mass * -Weight.UpwardAcceleration(s_scene);
        Assert.Equal((2.44 + 0.06 + 0.11) - (bears / 400), state.Position.Y, 2e-5);

        BallState rested = state;
        Vector3d place = state.Position;
        simulator.Step(ref state, 5, log);
        Assert.Equal(place, state.Position);
        var bytes = new byte[Snapshot.Size];
        Snapshot.Write(in state, bytes);
        BallState read = Snapshot.Read(bytes);
        Assert.Equal(Snapshot.Hash(in state), Snapshot.Hash(in read));

        BallState kicked = rested;
        simulator.Kick(ref kicked, new Vector3d(0, 5, 0), Vector3d.Zero);
        simulator.Step(ref kicked, 0.05, log);
        Assert.True(kicked.Position.Y > place.Y + 0.1);

        // From the side, along the ground's normal and from below.
        foreach (Vector3d way in new[] { new Vector3d(1, 0, 0), new Vector3d(0, -1, 0), new Vector3d(0, 1, 0) })
        {
            BallState hit = rested;
            boot.MoveTo(place - (0.25 * way), 3 * way, hit.Time);
            log.Clear();
            simulator.Step(ref hit, 0.03, log);
            Assert.Contains(log.Events.Span.ToArray(), item => item.Kind == BallEventKind.Impact && simulator.NameOf(item.ColliderIndex) == "boot");
            Assert.True(Vector3d.Dot(hit.Position - place, in way) > 0.01, $"{way}: {hit.Position - place}");
            Assert.InRange(hit.Position.Y, 2, 3);
            boot.MoveTo(new Vector3d(0, 50, 0), Vector3d.Zero, hit.Time);
        }

        boot.MoveTo(new Vector3d(0, 50, 0), Vector3d.Zero, rested.Time);
        var group = new BallGroup(simulator, 2);
        BallState[] two = [rested, simulator.Launch(place + new Vector3d(-1, 0.02, 0), new Vector3d(8, 0.5, 0), Vector3d.Zero)];
        two[1].Time = rested.Time;
        log.Clear();
        for (int i = 0; i < 20; i++)
        {
            group.Step(two, 0.01, log);
        }

        Assert.True(two[0].Position.X > place.X + 0.05, $"{two[0].Position}");
    }

    /// <summary>Deep in the net and rolling out as fast as that comes back, a ball grips and slips in turn: no step of it tells or takes more than others.</summary>
    [Fact]
    public void A_ball_that_the_net_lets_go_takes_no_endless_steps()
    {
        var simulator = new Simulator(s_scene);
        var log = new StepLog();
        for (int i = 0; i < 40; i++)
        {
            double speed = 0.715 + (0.0005 * i);
            BallState state = simulator.Launch(new Vector3d(-1.23, 0.11, -23.71), new Vector3d(0, 0, speed), new Vector3d(speed / 0.11, 0, 0));
            NetSheet back = simulator.World.Nets[0];
            state.Nets = 1;
            state.NetSides = back.Depth(state.Position, 1) > back.Depth(state.Position, -1) ? 1UL : 0;
            for (int k = 0; k < 300; k++)
            {
                log.Clear();
                simulator.Step(ref state, 1.0 / 60, log);
                Assert.Equal(0, log.StalledSteps);
                Assert.True(log.Events.Count <= 24 && log.Evaluations < 6000, $"{speed}, step {k}: {log.Events.Count} events, {log.Evaluations} evaluations");
            }

            Assert.Equal(0UL, state.Nets);
        }
    }

    private static BallState Shot(Simulator simulator, Shots random)
    {
        var from = new Vector3d(random.Uniform(-10, 10), 0.11, random.Uniform(-12, 0));
        Vector3d way = new Vector3d(random.Uniform(-3.3, 3.3), random.Uniform(0.3, 2.1), -20) - from;
        double speed = random.Uniform(14, 33);
        Vector3d velocity = (speed / way.Length * way) + new Vector3d(0, 0.5 * 9.81 * way.Length / speed, 0);
        return simulator.Launch(from, velocity, new Vector3d(random.Uniform(-30, 30), random.Uniform(-30, 30), random.Uniform(-30, 30)));
    }
}
