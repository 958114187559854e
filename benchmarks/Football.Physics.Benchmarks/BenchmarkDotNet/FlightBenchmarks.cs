using BenchmarkDotNet.Attributes;

namespace FootballPhysics.Benchmarks;

/// <summary>One step in flight, in a dependent chain: integrator × law × set, with the plain yardstick as baseline.</summary>
[MemoryDiagnoser]
public class FlightBenchmarks : IHasError
{
    private const int Operations = ShotSets.Count * ShotSets.Steps;
    private const double H = ShotSets.TimeStep;
    private readonly StepLog _log = new();
    private Simulator _simulator = new(Scene.Published);
    private BallState[] _shots = [];
    private PlainFlight _flight = PlainFlight.Create(PlainLawKind.Published, Integrator.Rk2);
    private PlainState[] _plainShots = [];

    [ParamsAllValues]
    public Integrator Integrator { get; set; }

    [ParamsAllValues]
    public PlainLawKind Law { get; set; }

    [ParamsAllValues]
    public FlightSet Set { get; set; }

    private IReadOnlyList<Shot> Source => Set == FlightSet.Fast ? ShotSets.Fast : ShotSets.Mixed;

    [GlobalSetup]
    public void Setup()
    {
        _simulator = new Simulator(PlainFlight.SceneOf(Law), new SolverSettings { Integrator = Integrator });
        _shots = Shots.Launch(_simulator, Shots.HighUp(Source));
        _flight = PlainFlight.Create(Law, Integrator);
        _plainShots = Shots.Plain(Shots.HighUp(Source));
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = Operations)]
    public double Plain() => Batches.Chain(_flight, _plainShots, ShotSets.Steps, H);

    [Benchmark(OperationsPerInvoke = Operations)]
    public double Library() => Batches.Chain(_simulator, _shots, ShotSets.Steps, H, _log);

    public double Error(string benchmark) => benchmark == nameof(Library)
        ? Errors.Landing(Integrator, Law, H, Source)
        : Errors.PlainLanding(Integrator, Law, H, Source);
}
