using BenchmarkDotNet.Attributes;

namespace FootballPhysics.Benchmarks;

/// <summary>The position of a shot after three seconds, including bounces, with every event exact; compared with a plain RK2 step.</summary>
[MemoryDiagnoser]
public class LookAheadBenchmarks : IHasError
{
    private readonly StepLog _log = new();
    private readonly PlainFlight _flight = PlainFlight.Create(PlainLawKind.Published, Integrator.Rk2);
    private readonly PlainState[] _plainShots = Shots.Plain(Shots.HighUp(ShotSets.Fast));
    private Simulator _simulator = new();
    private BallState[] _shots = [];

    [Params(Integrator.Rk2, Integrator.Rk4)]
    public Integrator Integrator { get; set; }

    /// <summary>The time step, ms.</summary>
    [Params(10, 40, 80)]
    public int Milliseconds { get; set; }

    [ParamsAllValues]
    public Profile Profile { get; set; }

    private Scene Scene => Profile == Profile.Published ? Scene.Published : Scene.Default;

    [GlobalSetup]
    public void Setup()
    {
        _simulator = new Simulator(Scene, new SolverSettings { Integrator = Integrator });
        _shots = Shots.Launch(_simulator, ShotSets.Mixed);
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = ShotSets.Count * ShotSets.Steps)]
    public double PlainRk2Step() => Batches.Chain(_flight, _plainShots, ShotSets.Steps, ShotSets.TimeStep);

    [Benchmark(OperationsPerInvoke = ShotSets.Count)]
    public double Library() => Batches.LookAhead(_simulator, _shots, 1e-3 * Milliseconds, ShotSets.LookAhead, _log);

    public double Error(string benchmark) =>
        benchmark == nameof(Library) ? Errors.LookAhead(Scene, Integrator, 1e-3 * Milliseconds, ShotSets.Mixed) : double.NaN;
}
