using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Stability;

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
        Ground[] grounds = [Ground.DryTurf, Ground.WetTurf, Ground.Concrete, Ground.Snow, Ground.LongGrass];
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

    private static double Energy(Scene scene, in BallState state) =>
        (0.5 * scene.Ball.Mass * state.Velocity.LengthSquared) + (0.5 * scene.Ball.MomentOfInertia * state.Spin.LengthSquared)
        - (scene.Ball.Mass * Weight.UpwardAcceleration(scene) * state.Position.Y);
}
