using Football.Physics.Tests.Support;

namespace Football.Physics.Tests.Things;

/// <summary>Shots into the net: in how many pieces, and where their paths run.</summary>
public sealed class NetTests
{
    /// <summary>Pieces that a shot may take in steps of 10 ms while it flies in a net.</summary>
    private const int MostPieces = 64;

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
            }

            shots += met ? 1 : 0;
            Assert.True(pieces <= MostPieces, $"shot {i}: {pieces} pieces");
        }

        Assert.True(shots > 150);
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

    private static BallState Shot(Simulator simulator, Shots random)
    {
        var from = new Vector3d(random.Uniform(-10, 10), 0.11, random.Uniform(-12, 0));
        Vector3d way = new Vector3d(random.Uniform(-3.3, 3.3), random.Uniform(0.3, 2.1), -20) - from;
        double speed = random.Uniform(14, 33);
        Vector3d velocity = (speed / way.Length * way) + new Vector3d(0, 0.5 * 9.81 * way.Length / speed, 0);
        return simulator.Launch(from, velocity, new Vector3d(random.Uniform(-30, 30), random.Uniform(-30, 30), random.Uniform(-30, 30)));
    }
}
