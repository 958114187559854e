using Football.Physics.Headless.Lab.Stability;
using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Stability;

/// <summary>Stress scenes and energy by the measured laws.</summary>
public sealed class MeasuredStabilityTests
{
    private const long Seed = 2025;
    private const int Scenes = 1040;

    [Fact]
    public void Every_invariant_holds_in_stress_scenes()
    {
        for (long index = 0; index < Scenes; index++)
        {
            StressScene scene = MeasuredStress.Of(StressGenerator.Make(Seed, index), Seed, index);
            StressOutcome outcome = StressRun.Play(scene);
            Assert.True(outcome.Failure is null, $"scene {index} of seed {Seed}: {outcome.Failure}\n{scene.Text()}");
        }
    }

    /// <summary>½ m v² + ½ I ω² + (m g − F_B) y, in flight, in impacts, sliding and rolling.</summary>
    [Theory]
    [InlineData(0.01)]
    [InlineData(0.04)]
    public void In_still_air_no_step_gains_energy(double timeStep)
    {
        var random = new Shots(41);
        Ground[] grounds = [Ground.DryTurf, Ground.WateredTurf, Ground.Concrete, Ground.Snow, Ground.LongGrass];
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
