namespace FootballPhysics.Tests.Api;

/// <summary>A state that was never launched is refused by one sentence, wherever it is passed.</summary>
public sealed class NeverLaunchedTests
{
    private static readonly LookAheadRequest s_request = new();

    [Fact]
    public void A_simulator_refuses_it()
    {
        var simulator = new Simulator();
        Refused(state => simulator.Step(ref state, 0.01, new StepLog()));
        Refused(state => simulator.Step(ref state, 0, new StepLog()));
        Refused(state => simulator.Kick(ref state, new Vector3d(1, 1, 1), default));
        Refused(state => simulator.Run(ref state, 0.01, 1, StopAt.Rest, new StepLog()));
        Refused(state => simulator.Validate(in state));
    }

    [Fact]
    public void A_group_refuses_it_for_any_ball()
    {
        var one = new BallGroup(new Simulator(), 1);
        var two = new BallGroup(new Simulator(), 2);
        BallState launched = two.SimulatorOf(0).Launch(new Vector3d(0, 1, 0), default, default);
        Refused(state => one.Step([state], 0.01, new StepLog()));
        Refused(state => one.Run([state], 0.01, 1, StopAt.Rest, new StepLog()));
        Refused(state => two.Step([launched, state], 0.01, new StepLog()));
        Refused(state => two.Step([state, launched], 0.01, new StepLog()));
        Refused(state => two.Run([launched, state], 0.01, 1, StopAt.Rest, new StepLog()));
        Refused(state => two.LookAhead([launched, state], s_request, [new Trajectory(), new Trajectory()]));
        var run = new LookAheadRun(two);
        Refused(state => run.Start([launched, state], s_request));
        Refused(state => run.Follows(1, in state));
    }

    [Fact]
    public void Predictions_and_touches_refuse_it()
    {
        var simulator = new Simulator();
        Refused(state => simulator.LookAhead(in state, s_request, new Trajectory()));
        var run = new LookAheadRun(simulator);
        Refused(state => run.Start(in state, s_request));
        Refused(state => run.Follows(in state));
        Refused(state => new TrajectoryCache(simulator, s_request).Update(in state));
        var touches = new Touches();
        Refused(state => touches.Trap(in state, new TrapRequest()));
        Refused(state => new LaunchDerivatives(simulator).Run(ref state, 0.01, 1, StopAt.Time));
    }

    [Fact]
    public void A_runner_and_a_rollback_refuse_it()
    {
        var runner = new FixedStepRunner();
        var rollback = new Rollback(runner);
        runner.Step();
        Refused(state => runner.Restore(0, in state));
        Refused(state => runner.RestoreAll(0, [state]));
        Refused(state => rollback.ApplyServerState(1, in state));
        Refused(state => new Ball().State = state);
    }

    [Fact]
    public void Bytes_of_it_are_not_written()
    {
        var runner = new FixedStepRunner();
        Refused(state => Snapshot.Write(in state, new byte[Snapshot.Size]));
        Refused(state => runner.TryWriteQuantized(in state, new byte[Snapshot.QuantizedSize]));
    }

    [Fact]
    public void The_scene_of_an_engine_refuses_it()
    {
        var stage = new BallScene();
        stage.Compile();
        Refused(state => stage.PredictionState(in state));
        Refused(state => stage.BeforeStep(in state));
        Refused(state => stage.AfterStep(in state));
        Refused(state => new NetBulges(new Simulator()).Follow(in state));
    }

    private static void Refused(Action<BallState> use)
    {
        ArgumentException refusal = Assert.Throws<ArgumentException>(() => use(default));
        Assert.StartsWith("The state was never launched. Create it with Simulator.Launch or copy it from a Ball.", refusal.Message, StringComparison.Ordinal);
    }
}
