using BenchmarkDotNet.Attributes;
using MathNet.Numerics.LinearAlgebra;

namespace FootballPhysics.Benchmarks;

/// <summary>One step in flight with all forces, by the library and every yardstick; the plain one is the baseline.</summary>
[MemoryDiagnoser]
public class YardstickBenchmarks : IHasError
{
    private const int Operations = ShotSets.Count * ShotSets.Steps;
    private const double H = ShotSets.TimeStep;
    private readonly StepLog _log = new();
    private readonly Shot[] _high = [.. Shots.HighUp(ShotSets.Fast)];
    private readonly RigidBodyEngine _engine = new();
    private Simulator _simulator = new(Scene.Published);
    private BallState[] _shots = [];
    private PlainFlight _flight = PlainFlight.Create(PlainLawKind.Published, Integrator.Rk2);
    private PlainState[] _plainShots = [];
    private ThesisBall _thesis = new(Integrator.Rk2);
    private MathNetFlight _mathNet = new(Integrator.Rk2);
    private Vector<double>[] _mathNetShots = [];

    [Params(Integrator.Rk2, Integrator.Rk4)]
    public Integrator Integrator { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        _simulator = new Simulator(Scene.Published, new SolverSettings { Integrator = Integrator });
        _shots = Shots.Launch(_simulator, _high);
        _flight = PlainFlight.Create(PlainLawKind.Published, Integrator);
        _plainShots = Shots.Plain(_high);
        _thesis = new ThesisBall(Integrator);
        _mathNet = new MathNetFlight(Integrator);
        _mathNetShots = [.. _high.Select(MathNetFlight.StateOf)];
    }

    [Benchmark(Baseline = true, OperationsPerInvoke = Operations)]
    public double Plain() => Batches.Chain(_flight, _plainShots, ShotSets.Steps, H);

    [Benchmark(OperationsPerInvoke = Operations)]
    public double Library() => Batches.Chain(_simulator, _shots, ShotSets.Steps, H, _log);

    [Benchmark(OperationsPerInvoke = Operations)]
    public double Thesis() => Batches.Chain(_thesis, _high, ShotSets.Steps, (float)H);

    [Benchmark(OperationsPerInvoke = Operations)]
    public double MathNet() => Batches.Chain(_mathNet, _mathNetShots, ShotSets.Steps, H);

    [Benchmark(OperationsPerInvoke = Operations)]
    public double RigidBodyEngine() => Batches.Chain(_engine, _plainShots, ShotSets.Steps, 1.0 / Yardsticks.RigidBodyEngine.FrameRate);

    public double Error(string benchmark) => benchmark switch
    {
        nameof(Plain) => Errors.PlainLanding(Integrator, PlainLawKind.Published, H, ShotSets.Fast),
        nameof(Library) => Errors.Landing(Integrator, PlainLawKind.Published, H, ShotSets.Fast),
        nameof(Thesis) => Errors.ThesisLanding(Integrator, H, ShotSets.Fast),
        nameof(MathNet) => Errors.MathNetLanding(Integrator, H, ShotSets.Fast),
        _ => Errors.EngineLanding(1.0 / Yardsticks.RigidBodyEngine.FrameRate, ShotSets.Fast),
    };
}
