namespace FootballPhysics.Batch;

/// <summary>Flies thousands of independent balls of one scene, from the launch to the first impact or a time.</summary>
/// <remarks>
/// Each result depends on its own launch alone: not on the others, their order, the number of threads or the width of the processor's
/// registers. Made once and used again, a run on one thread allocates nothing. Not for several threads at once; <see cref="BatchSettings.Threads"/> is.
/// Scenes with forces of a game's own, with wind by place and time or a knuckle force, with things that move, ground that is not level or not the same
/// everywhere, or with constant and fitted laws mixed, and what <see cref="BatchPrecision.Single"/> excepts, are flown ball by ball, in double. So is every
/// ball that may meet a goal or an obstacle on its way; <see cref="ScalarFallbackCount"/> counts them.
/// </remarks>
public sealed class BallBatch
{
    private readonly BatchWorker[] _workers;
    private readonly GroupRun _groups;
    private BatchLaunches? _launches;
    private BatchFlights? _flights;
    private double _duration;

    /// <summary>Compiles a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="settings">How to fly the balls; default <see cref="BatchSettings.Default"/>.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BallBatch(Scene? scene = null, BatchSettings? settings = null)
        : this(scene ?? Scene.Default, settings ?? BatchSettings.Default, LaneFlight.BestLanes)
    {
    }

    internal BallBatch(Scene scene, BatchSettings settings, int lanes)
    {
        scene.Validate();
        settings.Validate();
        Scene = scene;
        Settings = settings;
        _workers = new BatchWorker[settings.Threads];
        for (int i = 0; i < _workers.Length; i++)
        {
            _workers[i] = new BatchWorker(scene, settings, lanes);
        }

        _groups = new GroupRun(_workers.Length, (worker, from, n) => _workers[worker].Fly(_launches!, _flights!, from, n, _duration));
    }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>How the balls are flown.</summary>
    public BatchSettings Settings { get; }

    /// <summary>Length of a step, s: the float next to the one asked for.</summary>
    public double TimeStep => (float)Settings.TimeStep;

    /// <summary>True when the balls of a scene fly side by side in a batch: laws that lanes have, wind that is the same everywhere, no forces of a game's own. Others fly one by one.</summary>
    /// <param name="scene">The scene.</param>
    public static bool SupportsSimd(Scene scene) => LaneFlight.Covers(scene);

    /// <summary>How many of the last balls were flown alone, in double: all where the scene or <see cref="BatchSettings.Precision"/> is not for lanes.</summary>
    public int ScalarFallbackCount
    {
        get
        {
            int sum = 0;
            foreach (BatchWorker worker in _workers)
            {
                sum += worker.FlownSingly;
            }

            return sum;
        }
    }

    /// <summary>Flies the first balls of some launches.</summary>
    /// <param name="launches">The launches.</param>
    /// <param name="flights">Where the flights' ends go, each at its launch's index.</param>
    /// <param name="count">How many balls; 0 … the capacity of both.</param>
    /// <param name="duration">How long a flight may last, s. Above 0, at most 600; default 30.</param>
    /// <param name="progress">Told now and then how many are done, on the thread that did them; default nobody.</param>
    /// <param name="cancellation">Ends the run between two groups of balls; default never.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled. Some flights may have been written.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range. Some flights may have been written.</exception>
    /// <remarks>What a force of the game's own throws comes through as it was thrown, whatever the number of threads; some flights may have been written.</remarks>
    public void Fly(BatchLaunches launches, BatchFlights flights, int count, double duration = 30, IProgress<int>? progress = null, CancellationToken cancellation = default)
    {
        _launches = launches ?? throw new ArgumentNullException(nameof(launches));
        _flights = flights ?? throw new ArgumentNullException(nameof(flights));
        Check.Within(nameof(count), count, 0, Math.Min(launches.Capacity, flights.Capacity));
        Check.Within(nameof(duration), duration, 0, 600, exclusiveLow: true);
        _duration = duration;
        foreach (BatchWorker worker in _workers)
        {
            worker.Begin();
        }

        _groups.Run(count, progress, cancellation);
    }

    /// <summary>Flies a group of balls that nobody sees, so that no frame of a game has to compile the code of a flight.</summary>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite.</exception>
    public void WarmUp()
    {
        const int Count = 64;
        double contact = Scene.Ground.IsNone ? 0 : Scene.Ground.Height + Scene.Ball.Radius;
        var launches = new BatchLaunches(Count);
        for (int i = 0; i < Count; i++)
        {
            launches.Position[i] = new Vector3d(0, contact, 0);
            launches.Velocity[i] = new Vector3d(0, 3 + (0.1 * i), -12 - (0.2 * i));
            launches.Spin[i] = new Vector3d(0, 0.5 * i, 0);
        }

        Fly(launches, new BatchFlights(Count), Count);
    }
}
