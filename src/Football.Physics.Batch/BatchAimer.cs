namespace FootballPhysics.Batch;

/// <summary>Finds many kicks of one scene at once: the same question as <see cref="Aimer"/> answers.</summary>
/// <remarks>
/// Elevation and azimuth start in closed form and are improved with flights of many kicks at once; what does not converge, is out of reach,
/// grazes the drag law's jump or would touch the ground on its way is handed to an <see cref="Aimer"/>, and called a hit only where its miss,
/// measured, is one. The true miss of a hit is within the tolerance, down to 1 mm. Each answer depends on its own request alone: not on the
/// others, the number of threads or the width of the processor's registers. On one thread nothing is allocated but for what is handed on.
/// Not for several threads at once; its own threads are.
/// </remarks>
public sealed class BatchAimer
{
    private readonly BatchAimWorker[] _workers;
    private readonly GroupRun _groups;
    private BatchAims? _aims;
    private BatchKicks? _kicks;

    /// <summary>Compiles a scene.</summary>
    /// <param name="scene">The scene; default <see cref="Scene.Default"/>.</param>
    /// <param name="threads">How many threads. The answers do not depend on it. 1 … 1024; default 1.</param>
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

    /// <summary>How many of the last requests were handed to the single aimer.</summary>
    public int ScalarFallbackCount
    {
        get
        {
            int sum = 0;
            foreach (BatchAimWorker worker in _workers)
            {
                sum += worker.FlownSingly;
            }

            return sum;
        }
    }

    /// <summary>Flights of the last requests that were flown together.</summary>
    public long Flights
    {
        get
        {
            long sum = 0;
            foreach (BatchAimWorker worker in _workers)
            {
                sum += worker.Flights;
            }

            return sum;
        }
    }

    /// <summary>Finds the kicks for the first of some requests.</summary>
    /// <param name="aims">The requests.</param>
    /// <param name="kicks">Where the kicks go, each at its request's index.</param>
    /// <param name="count">How many; 0 … the capacity of both.</param>
    /// <param name="progress">Told now and then how many are done, on the thread that did them; default nobody.</param>
    /// <param name="cancellation">Ends the run between two groups of kicks; default never.</param>
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

    /// <summary>Finds a group of kicks that nobody plays, so that no frame of a game has to compile the code of a search.</summary>
    /// <exception cref="InvalidOperationException">A force of the game's own is not finite.</exception>
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
