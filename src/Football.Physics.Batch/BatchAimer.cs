using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Finds many kicks in one scene at once: the batch version of <see cref="Aimer"/>.</summary>
/// <remarks>
/// Elevation and azimuth start from a closed form, and Newton iterations with SIMD flights refine them. An <see cref="Aimer"/> handles requests that do not
/// converge, are out of reach, graze the jump in the drag law, or might touch the ground. Their kicks are hits only if the measured miss is within the
/// tolerance.
/// <para>The true miss of a hit is within the tolerance, for tolerances down to 1 mm. Each result depends only on its own request: not on the others, the
/// number of threads or the SIMD width. On one thread, only the fallback allocates. Not thread-safe, but it can use several threads itself.</para>
/// </remarks>
public sealed class BatchAimer
{
    private readonly BatchAimWorker[] _workers;
    private readonly GroupRun _groups;
    private BatchAims? _aims;
    private BatchKicks? _kicks;

    /// <summary>Compiles a scene for aiming.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="threads">The number of threads; the results do not depend on it. 1 … 1024; default 1.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range.</exception>
    public BatchAimer(Scene? scene = null, int threads = 1)
        : this(scene ?? Scene.Default, threads, LaneFlight.BestLanes)
    {
    }

    internal BatchAimer(Scene scene, int threads, int lanes)
    {
        scene.Validate();
        Check.Within(nameof(threads), threads, 1, 1024);
        Scene = scene;
        _workers = new BatchAimWorker[threads];
        for (int i = 0; i < threads; i++)
        {
            _workers[i] = new BatchAimWorker(scene, lanes);
        }

        _groups = new GroupRun(_workers.Length, (worker, from, n) => _workers[worker].Find(_aims!, _kicks!, from, n));
    }

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    /// <summary>The number of requests in the last call that an <see cref="Aimer"/> handled.</summary>
    public int ScalarFallbackCount => _workers.Sum(worker => worker.FlownSingly);

    /// <summary>The number of SIMD flights in the last call.</summary>
    public long Flights => _workers.Sum(worker => worker.Flights);

    /// <summary>Finds the kicks for the first requests of an array.</summary>
    /// <param name="aims">The requests.</param>
    /// <param name="kicks">Receives the kick of each request at the same index.</param>
    /// <param name="count">The number of requests; 0 … the capacity of both.</param>
    /// <param name="progress">Receives the number of finished requests from time to time, on a worker thread; default none.</param>
    /// <param name="cancellation">Cancels the run between two groups of kicks; default never.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled. Some kicks may have been written.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range. Some kicks may have been written.</exception>
    public void Find(BatchAims aims, BatchKicks kicks, int count, IProgress<int>? progress = null, CancellationToken cancellation = default)
    {
        _aims = aims ?? throw new ArgumentNullException(nameof(aims));
        _kicks = kicks ?? throw new ArgumentNullException(nameof(kicks));
        Check.Within(nameof(count), count, 0, Math.Min(aims.Capacity, kicks.Capacity));
        Check.Within("aim.elevation.min", aims.MinimumElevationDegrees, -90, 90);
        Check.Within("aim.elevation.max", aims.MaximumElevationDegrees, aims.MinimumElevationDegrees, 90);
        Check.Positive("aim.tolerance", aims.Tolerance);
        foreach (BatchAimWorker worker in _workers)
        {
            worker.Begin(aims);
        }

        _groups.Run(count, progress, cancellation);
    }

    /// <summary>Finds a group of dummy kicks, so that the code is compiled before the first real run.</summary>
    /// <exception cref="InvalidOperationException">A custom force is not finite.</exception>
    public void WarmUp()
    {
        const int Count = 64;
        double contact = Scene.Ground.IsNone ? 0 : Scene.Ground.Height + Scene.Ball.Radius;
        var aims = new BatchAims(Count);
        for (int i = 0; i < Count; i++)
        {
            aims.Set(i, new Vector3d(0, contact, 0), new Vector3d(0.1 * i, contact + 1, -15), 18 + (0.1 * i), -5, 0.5 * i);
        }

        Find(aims, new BatchKicks(Count), Count);
    }
}
