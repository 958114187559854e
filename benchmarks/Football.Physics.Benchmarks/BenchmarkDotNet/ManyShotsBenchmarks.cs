using BenchmarkDotNet.Attributes;

namespace FootballPhysics.Benchmarks;

/// <summary>A batch of different shots: one after another (a dependent chain) and interleaved (independent steps).</summary>
[MemoryDiagnoser]
public class ManyShotsBenchmarks : IHasError
{
    private const int Operations = ShotSets.Count * ShotSets.Steps;
    private const double H = ShotSets.TimeStep;
    private readonly StepLog _log = new();
    private readonly BallState[] _scratch = new BallState[ShotSets.Count];
    private readonly PlainState[] _plainScratch = new PlainState[ShotSets.Count];
    private readonly PlainState[] _plainShots = Shots.Plain(Shots.HighUp(ShotSets.Mixed));
    private Simulator _simulator = new(Scene.Published);
    private BallState[] _shots = [];
    private PlainFlight _flight = PlainFlight.Create(PlainLawKind.Published, Integrator.Rk2);

    [Params(Integrator.Rk2, Integrator.Rk4)]
    public Integrator Integrator { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        _simulator = new Simulator(Scene.Published, new SolverSettings { Integrator = Integrator });
        _shots = Shots.Launch(_simulator, Shots.HighUp(ShotSets.Mixed));
        _flight = PlainFlight.Create(PlainLawKind.Published, Integrator);
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = Operations)]
    public double PlainChain() => Batches.Chain(_flight, _plainShots, ShotSets.Steps, H);

    [Benchmark(OperationsPerInvoke = Operations)]
    public double PlainIndependent() => Batches.Interleaved(_flight, _plainShots, _plainScratch, ShotSets.Steps, H);

    [Benchmark(OperationsPerInvoke = Operations)]
    public double LibraryChain() => Batches.Chain(_simulator, _shots, ShotSets.Steps, H, _log);

    [Benchmark(OperationsPerInvoke = Operations)]
    public double LibraryIndependent() => Batches.Interleaved(_simulator, _shots, _scratch, ShotSets.Steps, H, _log);

    public double Error(string benchmark) => benchmark is nameof(LibraryChain) or nameof(LibraryIndependent)
        ? Errors.Landing(Integrator, PlainLawKind.Published, H, ShotSets.Mixed)
        : Errors.PlainLanding(Integrator, PlainLawKind.Published, H, ShotSets.Mixed);
}
