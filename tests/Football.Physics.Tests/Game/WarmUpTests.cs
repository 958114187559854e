using System.Runtime;

namespace FootballPhysics.Tests.Game;

/// <summary>After warming up a game compiles nothing any more, and nothing else is different.</summary>
public sealed class WarmUpTests
{
    /// <summary>Methods that a first use may still compile: of this test, and of the runtime.</summary>
    private const int Few = 8;

    /// <summary>A scene whose combination of laws and method no other test has, so that nothing of it is compiled yet.</summary>
    private static readonly Scene s_rare = new()
    {
        Forces = new ForceSet { Drag = ForceLaw.Constant, Magnus = ForceLaw.Empirical, SpinDecay = ForceLaw.None, Coefficients = AerodynamicModel.Measured },
    };

    [Fact]
    public void A_first_flight_impact_slide_and_roll_compile_nothing()
    {
        var simulator = new Simulator(s_rare, new SolverSettings { Integrator = Integrator.SemiImplicitEuler });
        simulator.WarmUp();
        var ball = new Ball(simulator);
        ball.Kick(new Vector3d(1, 6, -18), new Vector3d(3, 25, 1));
        long before = JitInfo.GetCompiledMethodCount(currentThread: true);
        while (ball.Motion != MotionState.Rest)
        {
            ball.Step(0.01);
        }

        Assert.InRange(JitInfo.GetCompiledMethodCount(currentThread: true) - before, 0, Few);
    }

    [Theory]
    [InlineData("press")]
    [InlineData("press, mass")]
    [InlineData("press, wind")]
    [InlineData("press, corner, wind")]
    [InlineData("press, group")]
    [InlineData("press, gutter")]
    [InlineData("press, published, corner")]
    [InlineData("press, net")]
    public void A_first_press_push_and_shot_into_a_net_compile_nothing(string kind) => Assert.InRange(FirstPlay.Compiles(kind), 0, Few);

    [Fact]
    public void Answers_are_the_same_warm_and_cold()
    {
        var request = new AimRequest { From = new Vector3d(0, 0.11, 0), Target = new Vector3d(2, 1.5, -20), SideSpin = 20 };
        var cold = new Aimer(new Simulator(s_rare));
        var warm = new Aimer(new Simulator(s_rare));
        warm.WarmUp();
        Assert.Equal(cold.Find(request).Velocity, warm.Find(request).Velocity);

        var launches = new BatchLaunches(3);
        launches.Set(2, default, new Vector3d(1, 5, -20), new Vector3d(0, 10, 0));
        var one = new BatchFlights(3);
        var other = new BatchFlights(3);
        var batch = new BallBatch(Scene.Published);
        new BallBatch(Scene.Published).Fly(launches, one, 3);
        batch.WarmUp();
        batch.Fly(launches, other, 3);
        Assert.Equal(one.Position[2], other.Position[2]);
        var aimer = new BatchAimer(Scene.Published);
        aimer.WarmUp();
        Assert.Equal(0, aimer.ScalarFallbackCount);
    }
}
