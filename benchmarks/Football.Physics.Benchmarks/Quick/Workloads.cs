using Football.Physics.Yardsticks;

namespace Football.Physics.Benchmarks;

/// <summary>Makes the workloads of the quick tables.</summary>
internal static class Workloads
{
    private const double H = ShotSets.TimeStep;
    private const int Steps = ShotSets.Steps;

    /// <summary>Flights high up by the library, in a dependent chain of steps.</summary>
    public static Workload Flight(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots) =>
        Chain(scene, integrator, Shots.HighUp(shots));

    /// <summary>A dependent chain of steps by the library, from where the shots are.</summary>
    public static Workload Chain(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        Simulator simulator = Compile(scene, integrator);
        BallState[] states = Shots.Launch(simulator, shots);
        var log = new StepLog();
        return new Workload(() => Batches.Chain(simulator, states, Steps, H, log), states.Length * Steps);
    }

    public static Workload FlightWithOrientation(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        Simulator simulator = Compile(scene, integrator);
        BallState[] states = Shots.Launch(simulator, Shots.HighUp(shots));
        var log = new StepLog();
        return new Workload(() => Batches.ChainWithOrientation(simulator, states, Steps, H, log), states.Length * Steps);
    }

    public static Workload Independent(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        Simulator simulator = Compile(scene, integrator);
        BallState[] states = Shots.Launch(simulator, Shots.HighUp(shots));
        var scratch = new BallState[states.Length];
        var log = new StepLog();
        return new Workload(() => Batches.Interleaved(simulator, states, scratch, Steps, H, log), states.Length * Steps);
    }

    public static Workload Stopped(Integrator integrator)
    {
        Simulator simulator = Compile(Scene.Default, integrator);
        BallState[] states = Shots.Stopped(simulator);
        var log = new StepLog();
        return new Workload(() => Batches.Chain(simulator, states, Steps, H, log), states.Length * Steps);
    }

    /// <summary>Steps with one impact inside each.</summary>
    public static Workload Impacts(Integrator integrator)
    {
        Simulator simulator = Compile(Scene.Default, integrator);
        BallState[] states = Shots.Launch(simulator, ShotSets.AboutToBounce);
        var log = new StepLog(2 * states.Length);
        return new Workload(() => Batches.OneStepEach(simulator, states, H, log), states.Length);
    }

    /// <summary>Look-aheads of three seconds from the ground, bounces and all.</summary>
    public static Workload LookAhead(Integrator integrator, double h)
    {
        Simulator simulator = Compile(Scene.Default, integrator);
        BallState[] states = Shots.Launch(simulator, ShotSets.Mixed);
        var log = new StepLog();
        return new Workload(() => Batches.LookAhead(simulator, states, h, ShotSets.LookAhead, log), states.Length);
    }

    public static Workload Plain(PlainLawKind law, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var flight = PlainFlight.Create(law, integrator);
        PlainState[] states = Shots.Plain(Shots.HighUp(shots));
        return new Workload(() => Batches.Chain(flight, states, Steps, H), states.Length * Steps);
    }

    public static Workload PlainIndependent(PlainLawKind law, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var flight = PlainFlight.Create(law, integrator);
        PlainState[] states = Shots.Plain(Shots.HighUp(shots));
        var scratch = new PlainState[states.Length];
        return new Workload(() => Batches.Interleaved(flight, states, scratch, Steps, H), states.Length * Steps);
    }

    public static Workload Thesis(Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var ball = new ThesisBall(integrator);
        IReadOnlyList<Shot> high = Shots.HighUp(shots);
        return new Workload(() => Batches.Chain(ball, high, Steps, (float)H), high.Count * Steps);
    }

    public static Workload MathNet(Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var flight = new MathNetFlight(integrator);
        var states = Shots.HighUp(shots).Select(MathNetFlight.StateOf).ToArray();
        return new Workload(() => Batches.Chain(flight, states, Steps, H), states.Length * Steps);
    }

    public static Workload Engine(IReadOnlyList<Shot> shots)
    {
        var engine = new RigidBodyEngine();
        PlainState[] states = Shots.Plain(Shots.HighUp(shots));
        return new Workload(() => Batches.Chain(engine, states, Steps, 1.0 / RigidBodyEngine.FrameRate), states.Length * Steps);
    }

    private static Simulator Compile(Scene scene, Integrator integrator) => new(scene, new SolverSettings { Integrator = integrator });
}
