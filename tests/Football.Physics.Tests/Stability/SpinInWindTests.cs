using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Stability;

/// <summary>A ball that spins in place while the wind pushes it about as hard as rolling friction holds it: each step costs what its neighbours cost.</summary>
public sealed class SpinInWindTests
{
    private const int Scenes = 150;
    private const int Steps = 1500;
    private const double Tick = 1.0 / 60;

    /// <summary>Far above the greatest count here, and far below the 20 000 of a ball whose direction is followed piece by piece.</summary>
    private const long MostEvaluations = 500;

    [Fact]
    public void A_ball_that_spins_in_place_takes_few_evaluations()
    {
        for (int i = 0; i < Scenes; i++)
        {
            var random = new Shots(9_800 + i);
            SurfaceMaterial surface = SurfaceMaterial.Presets.Values.ElementAt(i % SurfaceMaterial.Presets.Count);
            BallProperties ball = BallProperties.Presets.Values.ElementAt(i % BallProperties.Presets.Count);
            double angle = random.Uniform(0, 2 * Math.PI);
            Vector3d wind = random.Uniform(0.3, 9) * new Vector3d(Math.Cos(angle), 0, Math.Sin(angle));
            var simulator = new Simulator(Scene.Default with { Ball = ball, Ground = Ground.Of(surface), Air = new Air { Wind = wind } });
            Vector3d velocity = (i % 2 == 0 ? 0 : random.Uniform(0, 2)) * new Vector3d(Math.Sin(angle), 0, Math.Cos(angle));
            BallState state = simulator.Launch(new Vector3d(0, ball.Radius, 0), velocity, new Vector3d(0, random.Uniform(-60, 60), 0));
            var log = new StepLog();
            for (int step = 0; step < Steps && state.Motion != MotionState.Rest; step++)
            {
                log.Clear();
                simulator.Step(ref state, Tick, log);
                Assert.True(log.Evaluations <= MostEvaluations, $"scene {i}, step {step}: {log.Evaluations} evaluations at {state.Velocity}");
            }
        }
    }

    /// <summary>The wind is just below the wind that moves the ball, so the push delays its stop most.</summary>
    [Theory]
    [InlineData(1e-3)]
    [InlineData(1e-6)]
    [InlineData(1e-9)]
    public void A_ball_that_friction_barely_holds_stops(double less)
    {
        double low = 0;
        double high = 40;
        while (high - low > 1e-12 * high)
        {
            double wind = 0.5 * (low + high);
            BallState still = Launch(wind, Vector3d.Zero, out Simulator there);
            there.Step(ref still, Tick, new StepLog());
            (low, high) = still.Velocity.Length > 0 ? (low, wind) : (wind, high);
        }

        BallState state = Launch((1 - less) * low, new Vector3d(0, 0, 1e-6), out Simulator simulator);
        var log = new StepLog();
        for (int step = 0; step < 300; step++)
        {
            log.Clear();
            simulator.Step(ref state, Tick, log);
            Assert.True(log.Evaluations <= MostEvaluations, $"step {step}: {log.Evaluations} evaluations");
        }

        Assert.Equal(Vector3d.Zero, state.Velocity);
        Assert.InRange(new Vector3d(state.Position.X, 0, state.Position.Z).Length, 0, 1e-7);
    }

    private static BallState Launch(double wind, Vector3d velocity, out Simulator simulator)
    {
        simulator = new Simulator(Scene.Default with { Air = new Air { Wind = new Vector3d(wind, 0, 0) } });
        return simulator.Launch(new Vector3d(0, Scene.Default.Ball.Radius, 0), velocity, new Vector3d(0, 16, 0));
    }
}
