using FootballPhysics.Contacts;
using FootballPhysics.Scenes;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Things;

/// <summary>Any world, any step: nothing is passed through, nothing gains energy, every step ends, every state can be gone back to.</summary>
public sealed class WorldStabilityTests
{
    private const int Scenes = 40;

    public static TheoryData<Integrator, double> Methods() => new()
    {
        { Integrator.Rk4, 0.01 }, { Integrator.Rk4, 0.1 }, { Integrator.Rk2, 0.02 }, { Integrator.SemiImplicitEuler, 0.01 }, { Integrator.Euler, 0.01 },
    };

    [Theory]
    [ProfileData(Member = nameof(Methods))]
    public void No_ball_overlaps_anything_after_a_step(Profile profile, Integrator integrator, double dt)
    {
        for (int seed = 0; seed < Scenes; seed++)
        {
            var draw = new WorldDraw(seed, moves: false, profile);
            var simulator = new Simulator(draw.Scene, Flight.With(integrator));
            BallState state = simulator.Launch(draw.FreePlace(), draw.Velocity, draw.Spin);
            World world = new World(draw.Scene);
            var log = new StepLog();
            for (double t = 0; t < 4; t += dt)
            {
                log.Clear();
                simulator.Step(ref state, dt, log);
                Assert.True(state.Position.IsFinite && state.Velocity.IsFinite && state.Spin.IsFinite, $"scene {seed} at {t} s");
                Assert.True(log.Steps < 4000, $"scene {seed} at {t} s: {log.Steps} pieces in one step");
                foreach (Collider collider in world.Colliders)
                {
                    double gap = collider.At(state.Position, state.Time).Distance - Flight.Radius;
                    Assert.True(gap > -1e-9, $"scene {seed} at {t} s: {gap} m in {collider.Name}, {state.Motion}, v {state.Velocity}");
                }
            }
        }
    }

    [Theory]
    [ProfileData]
    public void Nothing_is_called_clear_that_a_step_of_semi_implicit_euler_reaches(Profile profile)
    {
        var table = new Obstacle { Shape = new BoxShape(new Vector3d(0, 0.5, 0), new Vector3d(1, 0.5, 1)) };
        var simulator = new Simulator(profile.Scene() with { Obstacles = [table] }, Flight.With(Integrator.SemiImplicitEuler));
        for (int mm = 0; mm < 40; mm++)
        {
            BallState state = simulator.Launch(new Vector3d(0, 1.001 + Flight.Radius + (0.001 * mm), 0), default, default);
            simulator.Step(ref state, 0.04, new StepLog());
            Assert.True(state.Position.Y > 1 + Flight.Radius - 1e-9, $"from {mm} mm it falls to {state.Position.Y}");
        }
    }

    [Theory]
    [ProfileData]
    public void Without_wind_and_moving_things_energy_never_grows(Profile profile)
    {
        for (int seed = 100; seed < 100 + Scenes; seed++)
        {
            var draw = new WorldDraw(seed, moves: false, profile);
            var simulator = new Simulator(draw.Scene, Flight.With(Integrator.Rk4));
            BallState state = simulator.Launch(draw.FreePlace(), draw.Velocity, draw.Spin);
            double before = Energy(draw.Scene, in state);
            var log = new StepLog();
            for (int i = 0; i < 400; i++)
            {
                log.Clear();
                BallState from = state;
                simulator.Step(ref state, 0.01, log);
                double after = Energy(draw.Scene, in state);

                // A ball that comes into a net from its side finds it stretched already.
                bool met = log.Events.Span.ToArray().Any(item => item.Kind == BallEventKind.Net);
                Assert.True(met || after <= before + (1e-7 * (1 + Math.Abs(before))), $"scene {seed} step {i}: {before} J, then {after} J, {from.Motion} to {state.Motion}, {string.Join(' ', log.Events.Span.ToArray().Select(item => $"{item.Kind}@{simulator.NameOf(item.ColliderIndex)}"))}");
                before = after;
            }
        }
    }

    [Theory]
    [ProfileData]
    public void Moving_things_are_not_passed_through_either(Profile profile)
    {
        for (int seed = 200; seed < 200 + Scenes; seed++)
        {
            var draw = new WorldDraw(seed, moves: true, profile);
            var simulator = new Simulator(draw.Scene, Flight.With(Integrator.Rk4));
            BallState state = simulator.Launch(draw.FreePlace(), draw.Velocity, draw.Spin);
            var log = new StepLog();
            for (int i = 0; i < 300; i++)
            {
                log.Clear();
                simulator.Step(ref state, 0.01, log);
                Assert.True(state.Position.IsFinite && state.Velocity.Length < 500, $"scene {seed} step {i}: {state.Velocity}");
                Assert.True(log.Steps < 4000, $"scene {seed} step {i}: {log.Steps} pieces");
            }
        }
    }

    [Theory]
    [ProfileData]
    public void A_copy_of_the_state_goes_on_to_the_last_bit_also_in_a_net(Profile profile)
    {
        int inNets = 0;
        for (int seed = 300; seed < 300 + Scenes; seed++)
        {
            var draw = new WorldDraw(seed, moves: false, profile);
            var simulator = new Simulator(draw.Scene, Flight.With(Integrator.Rk4));
            BallState state = simulator.Launch(draw.FreePlace(), draw.Velocity, draw.Spin);
            var log = new StepLog();
            byte[] bytes = new byte[Snapshot.Size];
            for (int i = 0; i < 150; i++)
            {
                Snapshot.Write(in state, bytes);
                inNets += state.Nets != 0 ? 1 : 0;
                BallState again = Snapshot.Read(bytes);
                simulator.Step(ref state, 0.01, log);
                simulator.Step(ref again, 0.01, new StepLog());
                Assert.Equal(Snapshot.Hash(in state), Snapshot.Hash(in again));
            }
        }

        Assert.True(inNets > 20, $"{inNets} steps in nets");
    }

    [Theory]
    [ProfileData]
    public void A_step_among_things_allocates_nothing(Profile profile)
    {
        var draw = new WorldDraw(5, moves: true, profile);
        var simulator = new Simulator(draw.Scene);
        var log = new StepLog(1024);
        Vector3d place = draw.FreePlace();
        Assert.Equal(0, Allocation.Of(() =>
        {
            BallState state = simulator.Launch(place, draw.Velocity, draw.Spin);
            log.Clear();
            for (int i = 0; i < 500; i++)
            {
                simulator.Step(ref state, 0.01, log);
            }
        }));
    }

    private static double Energy(Scene scene, in BallState state) =>
        (0.5 * scene.Ball.Mass * state.Velocity.LengthSquared) + (0.5 * scene.Ball.MomentOfInertia * state.Spin.LengthSquared)
        + (scene.Ball.Mass * -Weight.UpwardAcceleration(scene) * state.Position.Y) + NetEnergy(scene, in state);

    /// <summary>What a net gives back at most of what it holds, ½ k δ².</summary>
    private static double NetEnergy(Scene scene, in BallState state)
    {
        World world = new World(scene);
        double energy = 0;
        for (int i = 0; i < world.Nets.Length; i++)
        {
            if ((state.Nets >> i & 1) != 0)
            {
                double depth = Math.Max(0, world.Nets[i].Depth(state.Position, NetSheet.SideOf(state.NetSides, i)));
                energy += 0.5 * 400 * depth * depth;
            }
        }

        return energy;
    }

    [Theory]
    [ProfileData]
    public void A_ball_that_stands_on_a_slope_and_spins_does_not_creep(Profile profile)
    {
        var simulator = new Simulator(profile.Scene() with { Ground = profile.Ground() with { Normal = new Vector3d(0.02, 1, 0.01) } });
        BallState ball = simulator.Launch(new Vector3d(0, 0.12, 0), new Vector3d(0.1, 0, 0), new Vector3d(0, 60, 0));
        simulator.Run(ref ball, 0.01, 2, StopAt.Time, new StepLog());
        Assert.Equal((MotionState.Rolling, Vector3d.Zero), (ball.Motion, ball.Velocity));
        Vector3d place = ball.Position;
        simulator.Run(ref ball, 0.01, 1, StopAt.Time, new StepLog());
        Assert.Equal((MotionState.Rolling, place), (ball.Motion, ball.Position));
        Assert.InRange(ball.Spin.Length, 1, 60);
    }
}
