using BenchmarkDotNet.Attributes;

namespace FootballPhysics.Benchmarks;

/// <summary>A complete free kick from foot to rest at 60 Hz, compared with the same number of flight steps of the same scene: profile × integrator.</summary>
[MemoryDiagnoser]
public class KickBenchmarks
{
    private readonly StepLog _log = new();
    private Simulator _simulator = new();
    private BallState[] _flights = [];
    private BallState _kick;
    private int _steps;

    [Params(Integrator.Rk2, Integrator.Rk4)]
    public Integrator Integrator { get; set; }

    [ParamsAllValues]
    public Profile Profile { get; set; }

    [GlobalSetup]
    public void Setup()
    {
        _simulator = new Simulator(Profile == Profile.Published ? Scene.Published : Scene.Default, new SolverSettings { Integrator = Integrator });
        _kick = Shots.FreeKick(_simulator);
        Batches.ToRest(_simulator, in _kick, _log, out _steps);
        _flights = Shots.Launch(_simulator, [.. Shots.HighUp(ShotSets.Fast).Take(1)]);
    }

    [Benchmark(Baseline = true)]
    public double FlightSteps()
    {
        double sum = 0;
        for (int left = _steps; left > 0; left -= ShotSets.Steps)
        {
            sum += Batches.Chain(_simulator, _flights, Math.Min(left, ShotSets.Steps), ShotSets.TimeStep, _log);
        }

        return sum;
    }

    [Benchmark]
    public double Kick() => Batches.ToRest(_simulator, in _kick, _log, out _);
}
