using BenchmarkDotNet.Attributes;

namespace FootballPhysics.Benchmarks;

/// <summary>One step on the ground: profile × integrator × motion, against a plain RK2 step in flight.</summary>
[MemoryDiagnoser]
public class GroundBenchmarks : IHasError
{
    private const int Operations = ShotSets.Count * ShotSets.Steps;
    private const double H = ShotSets.TimeStep;
    private readonly StepLog _log = new();
    private readonly PlainFlight _flight = PlainFlight.Create(PlainLawKind.Published, Integrator.Rk2);
    private readonly PlainState[] _plainShots = Shots.Plain(Shots.HighUp(ShotSets.Fast));
    private Simulator _simulator = new();
    private BallState[] _shots = [];

    [ParamsAllValues]
    public Integrator Integrator { get; set; }

    [ParamsAllValues]
    public Profile Profile { get; set; }

    [ParamsAllValues]
    public GroundMotion Motion { get; set; }

    private Scene Scene => Profile == Profile.Published ? Scene.Published : Scene.Default;

    [GlobalSetup]
    public void Setup()
    {
        _simulator = new Simulator(Scene, new SolverSettings { Integrator = Integrator });
        _shots = Motion switch
        {
            GroundMotion.Sliding => Shots.Launch(_simulator, ShotSets.Sliding),
            GroundMotion.Rolling => Shots.Launch(_simulator, ShotSets.Rolling),
            _ => Shots.Stopped(_simulator),
        };
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = Operations)]
    public double PlainFlightRk2() => Batches.Chain(_flight, _plainShots, ShotSets.Steps, H);

    [Benchmark(OperationsPerInvoke = Operations)]
    public double Library() => Batches.Chain(_simulator, _shots, ShotSets.Steps, H, _log);

    public double Error(string benchmark) => benchmark == nameof(Library) && Motion != GroundMotion.Stopped
        ? Errors.After(
            Scene,
            new SolverSettings { Integrator = Integrator },
            H,
            ShotSets.Steps * H,
            Motion == GroundMotion.Sliding ? ShotSets.Sliding : ShotSets.Rolling)
        : double.NaN;
}
