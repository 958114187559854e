using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Simulates thousands of independent balls in one scene, each from its launch to the first impact or a time limit.</summary>
/// <remarks>
/// Each result depends only on its own launch, not on the other launches, their order, the number of threads or the SIMD width. Create one per scene and
/// reuse it: a run on one thread does not allocate. Not thread-safe; set <see cref="BatchSettings.Threads"/> to use several threads.
/// <para>Scenes that SIMD lanes do not support are simulated ball by ball, in double precision. Lanes do not support custom forces, variable wind, knuckle
/// forces or moving objects. The ground must be level and uniform, and the laws must all be of one kind. The exceptions listed at
/// <see cref="BatchPrecision.Single"/>, and balls that may hit a goal or an obstacle, are also simulated ball by ball. <see cref="ScalarFallbackCount"/> is the
/// number of these balls.</para>
/// </remarks>
public sealed class BallBatch
{
    private readonly BatchWorker[] _workers;
    private readonly GroupRun _groups;
    private BatchLaunches? _launches;
    private BatchFlights? _flights;
    private double _duration;

    /// <summary>Compiles a scene for batches.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="settings">The settings; default <see cref="BatchSettings.Default"/>.</param>
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

    /// <summary>The settings.</summary>
    public BatchSettings Settings { get; }

    /// <summary>The length of a step, in s: the requested length, rounded to float.</summary>
    public double TimeStep => (float)Settings.TimeStep;

    /// <summary>Returns true if SIMD lanes support the scene; otherwise balls are simulated one by one.</summary>
    /// <remarks>Lanes support constant or fitted laws, a uniform wind and level ground, without custom forces.</remarks>
    /// <param name="scene">The scene.</param>
    public static bool SupportsSimd(Scene scene) => LaneFlight.Covers(scene);

    /// <summary>The number of balls in the last run that were simulated one by one, in double precision.</summary>
    /// <remarks>This number includes all balls if lanes do not support the scene or <see cref="BatchSettings.Precision"/>.</remarks>
    public int ScalarFallbackCount => _workers.Sum(worker => worker.FlownSingly);

    /// <summary>Simulates the first balls of an array of launches.</summary>
    /// <param name="launches">The launches.</param>
    /// <param name="flights">Receives the result of each launch at the same index.</param>
    /// <param name="count">The number of balls; 0 … the capacity of both.</param>
    /// <param name="duration">The longest flight, in s. Above 0, at most 600; default 30.</param>
    /// <param name="progress">Receives the number of finished balls from time to time, on a worker thread; default none.</param>
    /// <param name="cancellation">Cancels the run between two groups of balls; default never.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled. Some flights may have been written.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range. Some flights may have been
    /// written.</exception>
    /// <remarks>Exceptions from custom forces propagate unchanged, for any number of threads; some flights may already have been written.</remarks>
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

    /// <summary>Simulates a group of dummy balls, so that the code is compiled before the first real run.</summary>
    /// <exception cref="InvalidOperationException">A custom force is not finite.</exception>
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
