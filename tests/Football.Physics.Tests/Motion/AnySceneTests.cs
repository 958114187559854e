using FootballPhysics.Scenes;
using FootballPhysics.Tests.Support;
using FsCheck.Fluent;
using FsCheck;

namespace FootballPhysics.Tests.Motion;

/// <summary>What holds in every scene that is allowed and for every kick: found by search, shrunk by FsCheck.</summary>
public sealed class AnySceneTests
{
    [Theory]
    [ProfileData]
    public void The_state_stays_finite_and_above_the_ground_and_events_stay_in_order(Profile profile) =>
        Search(profile, 400, world =>
        {
            var simulator = new Simulator(world.Scene, Flight.With(world.Integrator));
            BallState state = simulator.Launch(world.Position, world.Velocity, world.Spin);
            var limit = new PieceLimit(200_000);
            var log = new StepLog { Observer = limit };
            double last = 0;
            for (int i = 0; i < 40; i++)
            {
                double before = state.Time;
                log.Clear();
                simulator.Step(ref state, world.Step, log);
                if (limit.Reached)
                {
                    return $"step {i} does not end";
                }

                if (!(state.Position.IsFinite && state.Velocity.IsFinite && state.Spin.IsFinite && state.Orientation.IsFinite))
                {
                    return $"not finite: {state.Position} {state.Velocity} {state.Spin} {state.Orientation}";
                }

                if (Math.Abs(state.Orientation.LengthSquared - 1) > 1e-12)
                {
                    return $"orientation of size {state.Orientation.LengthSquared}";
                }

                if (Math.Abs(state.Time - before - world.Step) > 1e-12 * Math.Max(1, state.Time))
                {
                    return $"time went from {before} to {state.Time}";
                }

                if (state.Position.Y < simulator.ContactHeight - 1e-9)
                {
                    return $"below the ground by {simulator.ContactHeight - state.Position.Y}";
                }

                foreach (ref readonly BallEvent item in log.Events)
                {
                    if (item.Time < last || item.Time > state.Time || Math.Abs(item.Position.Y - simulator.ContactHeight) > 1e-9)
                    {
                        return $"{item.Kind} at {item.Time}, {item.Position} after {last}";
                    }

                    last = item.Time;
                }
            }

            return null;
        });

    /// <summary>Without wind and without forces of the game, nothing gives the ball energy.</summary>
    [Theory]
    [ProfileData]
    public void A_ball_never_gains_energy_in_still_air(Profile profile) =>
        Search(profile, 400, world =>
        {
            Scene scene = world.Scene with { Air = world.Scene.Air with { Wind = Vector3d.Zero } };
            var simulator = new Simulator(scene, Flight.With(Integrator.Rk4));
            BallState state = simulator.Launch(world.Position, world.Velocity, world.Spin);
            double weight = scene.Ball.Mass * -(Gravity.Acceleration(scene) + Buoyancy.Acceleration(scene));
            double Energy(in BallState s) =>
                (0.5 * ((scene.Ball.Mass * s.Velocity.LengthSquared) + (scene.Ball.MomentOfInertia * s.Spin.LengthSquared))) + (weight * s.Position.Y);
            double start = Energy(in state);
            double scale = Math.Abs(start) + (0.5 * scene.Ball.Mass * world.Velocity.LengthSquared) + Math.Abs(weight * state.Position.Y);
            var log = new StepLog();
            for (int i = 0; i < 40; i++)
            {
                simulator.Step(ref state, Math.Min(world.Step, 0.01), log);
                if (Energy(in state) > start + (1e-6 * scale))
                {
                    return $"energy {start} J to {Energy(in state)} J at {state.Time} s, {state.Motion}, {Flight.Kinds(log)}";
                }

                start = Math.Min(start, Energy(in state));
            }

            return null;
        });

    private static void Search(Profile profile, int tests, Func<World, string?> verdict) =>
        Prop.ForAll(
            ArbMap.Default.ArbFor<int>(),
            seed =>
            {
                var world = World.From(profile, seed);
                string? wrong = verdict(world);
                Assert.True(wrong is null, $"{wrong}\nin {world}");
            })
            .Check(Config.QuickThrowOnFailure.WithMaxTest(tests).WithEndSize(1 << 20).WithReplay(20, 31));

    /// <summary>A scene, a kick, a method and a step, all from one number.</summary>
    private sealed record World(Scene Scene, Integrator Integrator, double Step, Vector3d Position, Vector3d Velocity, Vector3d Spin)
    {
        public static World From(Profile profile, int seed)
        {
            var random = new Shots(seed);
            double Log(double low, double high) => Math.Exp(random.Uniform(Math.Log(low), Math.Log(high)));
            double Perhaps(double value) => random.Uniform(0, 1) < 0.2 ? 0 : value;
            T Any<T>()
                where T : struct, Enum => Enum.GetValues<T>()[(int)random.Uniform(0, Enum.GetValues<T>().Length)];
            double radius = Log(0.02, 0.5);
            double density = Perhaps(Log(0.1, 20));

            // Heavier than the air it displaces.
            double mass = Log(0.02, 10) + (1.2 * density * 4.2 * radius * radius * radius);
            ForceSet mixed = ForceSet.Published with
            {
                Buoyancy = random.Uniform(0, 1) < 0.5,
                Drag = Any<ForceLaw>(),
                Magnus = Any<ForceLaw>(),
                SpinDecay = Any<ForceLaw>(),
                Coefficients = Any<AerodynamicModel>(),
                DragCoefficient = Perhaps(Log(0.01, 3)),
                MagnusCoefficient = random.Uniform(-0.2, 0.2),
                SpinDecayCoefficient = Perhaps(Log(1e-6, 1e-2)),
            };
            ForceSet forces = profile == Profile.Published ? mixed : ForceSet.Measured with { Buoyancy = mixed.Buoyancy, KnuckleSeed = random.Uniform(0, 1) < 0.3 ? seed : null };
            var scene = profile.Scene() with
            {
                Ball = new BallProperties { Mass = mass, Radius = radius, InertiaFactor = random.Uniform(0.1, 1) },
                Air = new Air { Density = density, KinematicViscosity = Log(1e-6, 1e-3), Wind = Perhaps(Log(0.1, 60)) * random.Direction() },
                Gravity = Perhaps(Log(0.5, 40)),
                Forces = forces,
                Ground = profile.Ground() with
                {
                    Material = profile.Ground().Material with
                    {
                        NormalRestitution = random.Uniform(0, 1),
                        SpinRestitution = random.Uniform(0, 1),
                        SlidingFriction = Perhaps(Log(0.01, 5)),
                        RollingResistance = Perhaps(Log(0.001, 2)),
                        SpinDamping = Perhaps(Log(1e-5, 0.1)),
                        TangentialRestitution = random.Uniform(-1, 1),
                    },
                    Height = random.Uniform(-10, 10),
                    MinimumBounceSpeed = Log(0.001, 1),
                    RestEnergy = Log(1e-8, 0.1),
                    Aerodynamics = Any<GroundAerodynamics>(),
                },
            };
            double up = random.Uniform(0, 1) < 0.4 ? -5 : Log(0.01, 5);
            return new World(
                scene,
                Any<Integrator>(),
                Log(1e-4, 0.3),
                new Vector3d(0, scene.Ground.Height + scene.Ball.Radius + up, 0),
                Perhaps(Log(0.01, 80)) * random.Direction(),
                Perhaps(Log(0.01, 150)) * random.Direction());
        }
    }
}
