using FootballPhysics.Scenes;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Stability;

/// <summary>Energy by the measured laws.</summary>
public sealed class MeasuredStabilityTests
{
    /// <summary>½ m v² + ½ I ω² + (m g − F_B) y, in flight, in impacts, sliding and rolling.</summary>
    [Theory]
    [InlineData(0.01)]
    [InlineData(0.04)]
    public void In_still_air_no_step_gains_energy(double timeStep)
    {
        var random = new Shots(41);
        Ground[] grounds = [Ground.Of(SurfaceMaterial.DryTurf), Ground.Of(SurfaceMaterial.WetTurf), Ground.Of(SurfaceMaterial.Concrete), Ground.Of(SurfaceMaterial.Snow), Ground.Of(SurfaceMaterial.LongGrass)];
        for (int i = 0; i < 100; i++)
        {
            var simulator = new Simulator(Scene.Measured with { Ground = grounds[i % grounds.Length] });
            BallState state = simulator.Launch(new Vector3d(0, 0.11, 0), random.Velocity(2, 35, 0, 60), random.Uniform(0, 80) * random.Direction());
            var log = new StepLog();
            double most = Energy(simulator.Scene, in state);
            for (int step = 0; step < 300; step++)
            {
                simulator.Step(ref state, timeStep, log);
                double now = Energy(simulator.Scene, in state);
                Assert.True(now <= most * (1 + 1e-9), $"shot {i}, {state.Time} s, {state.Motion}: {most} J to {now} J");
                most = now;
            }
        }
    }

    /// <summary>
    /// Friction makes a ball that spins without travel fast within a step, where the lift is another one than it was at the start: that once made 2e18 J.
    /// </summary>
    [Theory]
    [ProfileData(Integrator.Rk4)]
    [ProfileData(Integrator.Rk2)]
    public void A_ball_that_friction_makes_fast_within_a_step_gains_no_energy(Profile profile, Integrator integrator)
    {
        Scene scene = Profiles.Scene(profile);
        scene = scene with
        {
            Ball = scene.Ball with { Mass = 37.69911184307752, Radius = 5, InertiaFactor = 0.4 },
            Air = new Air { Density = 0.72, KinematicViscosity = 1.5e-5 },
            Gravity = 300,
            Forces = scene.Forces with { Buoyancy = false },
            Ground = scene.Ground with
            {
                Material = scene.Ground.Material with
                {
                    SlidingFriction = 10,
                    SpinDamping = 0.0035641015257594864,
                    RollingResistance = 0.05,
                },
                Aerodynamics = GroundAerodynamics.Horizontal,
            },
        };
        var simulator = new Simulator(scene, new SolverSettings { Integrator = integrator });
        BallState state = simulator.Launch(new Vector3d(0, 5, 0), new Vector3d(-4e-4, 0, 1e-4), new Vector3d(-1547.1233669910719, 9765.41487657772, -1497.6920830480215));
        var log = new StepLog();
        double most = Energy(scene, in state);
        for (int step = 0; step < 60; step++)
        {
            simulator.Step(ref state, 1.0 / 60.0, log);
            double now = Energy(scene, in state);
            Assert.True(now <= most * (1 + 1e-9), $"{state.Time} s, {state.Motion}: {most} J to {now} J");
            most = now;
        }
    }

    private static double Energy(Scene scene, in BallState state) =>
        (0.5 * scene.Ball.Mass * state.Velocity.LengthSquared) + (0.5 * scene.Ball.MomentOfInertia * state.Spin.LengthSquared)
        - (scene.Ball.Mass * Weight.UpwardAcceleration(scene) * state.Position.Y);
}
