using BenchmarkDotNet.Attributes;

namespace FootballPhysics.Benchmarks;

/// <summary>One step with one impact inside it: profile × integrator × timing.</summary>
[MemoryDiagnoser]
public class ImpactBenchmarks : IHasError
{
    private readonly StepLog _log = new(2 * ShotSets.Count);
    private readonly Shot[] _thesisShots = [.. ShotSets.AboutToBounce];
    private Simulator _simulator = new();
    private BallState[] _shots = [];
    private ThesisBall _thesis = new(Integrator.Rk2);

    [ParamsAllValues]
    public Integrator Integrator { get; set; }

    [ParamsAllValues]
    public CollisionTiming Timing { get; set; }

    [ParamsAllValues]
    public Profile Profile { get; set; }

    private Scene Scene => Profile == Profile.Published ? Scene.Published : Scene.Default;

    private SolverSettings Settings => new() { Integrator = Integrator, CollisionTiming = Timing };

    [GlobalSetup]
    public void Setup()
    {
        _simulator = new Simulator(Scene, Settings);
        _shots = Shots.Launch(_simulator, ShotSets.AboutToBounce);
        _thesis = new ThesisBall(Integrator);
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = ShotSets.Count)]
    public double Thesis() => Batches.Chain(_thesis, _thesisShots, 1, (float)ShotSets.TimeStep);

    [Benchmark(OperationsPerInvoke = ShotSets.Count)]
    public double Library() => Batches.OneStepEach(_simulator, _shots, ShotSets.TimeStep, _log);

    public double Error(string benchmark) => benchmark == nameof(Library)
        ? Errors.After(Scene, Settings, ShotSets.TimeStep, ShotSets.TimeStep, ShotSets.AboutToBounce)
        : Errors.ThesisStep(Integrator, ShotSets.TimeStep, ShotSets.AboutToBounce);
}
