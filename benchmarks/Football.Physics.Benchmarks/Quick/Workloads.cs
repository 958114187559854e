namespace FootballPhysics.Benchmarks;

/// <summary>Makes the workloads of the quick tables.</summary>
internal static class Workloads
{
    private const double H = ShotSets.TimeStep;
    private const int Steps = ShotSets.Steps;

    /// <summary>The number of shots per call: few, so that a round is shorter than a time slice and seldom interrupted. The next call takes the next shots.</summary>
    private const int Part = ShotSets.Count / 4;

    /// <summary>Simulates flights high up by the library, in a dependent chain of steps.</summary>
    public static Workload Flight(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots) =>
        Chain(scene, integrator, Shots.HighUp(shots));

    /// <summary>Runs a dependent chain of steps by the library, from the positions of the shots.</summary>
    public static Workload Chain(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        Simulator simulator = Compile(scene, integrator);
        BallState[] states = Shots.Launch(simulator, shots);
        var log = new StepLog();
        return OfParts(part => Batches.Chain(simulator, states.AsSpan(part, Part), Steps, H, log), Part * Steps);
    }

    public static Workload FlightWithOrientation(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        Simulator simulator = Compile(scene, integrator);
        BallState[] states = Shots.Launch(simulator, Shots.HighUp(shots));
        var log = new StepLog();
        return OfParts(part => Batches.ChainWithOrientation(simulator, states.AsSpan(part, Part), Steps, H, log), Part * Steps);
    }

    public static Workload Independent(Scene scene, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        Simulator simulator = Compile(scene, integrator);
        BallState[] states = Shots.Launch(simulator, Shots.HighUp(shots));
        var scratch = new BallState[Part];
        var log = new StepLog();
        return OfParts(part => Batches.Interleaved(simulator, states.AsSpan(part, Part), scratch, Steps, H, log), Part * Steps);
    }

    public static Workload Stopped(Integrator integrator)
    {
        Simulator simulator = Compile(Scene.Published, integrator);
        BallState[] states = Shots.Stopped(simulator);
        var log = new StepLog();
        return OfParts(part => Batches.Chain(simulator, states.AsSpan(part, Part), Steps, H, log), Part * Steps);
    }

    /// <summary>Runs steps with one impact inside each.</summary>
    public static Workload Impacts(Scene scene, Integrator integrator)
    {
        Simulator simulator = Compile(scene, integrator);
        BallState[] states = Shots.Launch(simulator, ShotSets.AboutToBounce);
        var log = new StepLog(2 * states.Length, Math.Max(32, 2 * states.Length));
        return OfParts(part => Batches.OneStepEach(simulator, states.AsSpan(part, Part), H, log), Part);
    }

    /// <summary>Computes look-aheads of three seconds from the ground, including bounces.</summary>
    public static Workload LookAhead(Scene scene, Integrator integrator, double h)
    {
        Simulator simulator = Compile(scene, integrator);
        BallState[] states = Shots.Launch(simulator, ShotSets.Mixed);
        var log = new StepLog();
        return OfParts(part => Batches.LookAhead(simulator, states.AsSpan(part, Part), h, ShotSets.LookAhead, log), Part);
    }

    public static Workload Plain(PlainLawKind law, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var flight = PlainFlight.Create(law, integrator);
        PlainState[] states = Shots.Plain(Shots.HighUp(shots));
        return OfParts(part => Batches.Chain(flight, states.AsSpan(part, Part), Steps, H), Part * Steps);
    }

    public static Workload PlainIndependent(PlainLawKind law, Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var flight = PlainFlight.Create(law, integrator);
        PlainState[] states = Shots.Plain(Shots.HighUp(shots));
        var scratch = new PlainState[Part];
        return OfParts(part => Batches.Interleaved(flight, states.AsSpan(part, Part), scratch, Steps, H), Part * Steps);
    }

    public static Workload Thesis(Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var ball = new ThesisBall(integrator);
        Shot[] high = [.. Shots.HighUp(shots)];
        return OfParts(part => Batches.Chain(ball, high.AsSpan(part, Part), Steps, (float)H), Part * Steps);
    }

    public static Workload MathNet(Integrator integrator, IReadOnlyList<Shot> shots)
    {
        var flight = new MathNetFlight(integrator);
        var states = Shots.HighUp(shots).Select(MathNetFlight.StateOf).ToArray();
        return OfParts(part => Batches.Chain(flight, states.AsSpan(part, Part), Steps, H), Part * Steps);
    }

    public static Workload Engine(IReadOnlyList<Shot> shots)
    {
        var engine = new RigidBodyEngine();
        PlainState[] states = Shots.Plain(Shots.HighUp(shots));
        return OfParts(part => Batches.Chain(engine, states.AsSpan(part, Part), Steps, 1.0 / RigidBodyEngine.FrameRate), Part * Steps);
    }

    /// <summary>Simulates a kick from foot to rest at 60 Hz.</summary>
    public static Workload Kick(Scene scene, Integrator integrator)
    {
        Simulator simulator = Compile(scene, integrator);
        BallState kick = Shots.FreeKick(simulator);
        var log = new StepLog();
        Batches.ToRest(simulator, in kick, log, out int steps);
        return new Workload(() => Batches.ToRest(simulator, in kick, log, out _), steps);
    }

    private static Workload OfParts(Func<int, double> run, int operations)
    {
        int part = 0;
        return new Workload(
            () =>
            {
                part = (part + Part) % ShotSets.Count;
                return run(part);
            },
            operations);
    }

    private static Simulator Compile(Scene scene, Integrator integrator) => new(scene, new SolverSettings { Integrator = integrator });
}
