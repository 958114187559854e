using FootballPhysics.Numerics;

namespace FootballPhysics.Batch;

/// <summary>Simulates thousands of independent balls in one scene to a plane, to rest or to a time, with their paths.</summary>
/// <remarks>
/// The balls are simulated one by one in double precision, on several threads. Each result depends only on its own launch. For flights to the first impact,
/// <see cref="BallBatch"/> is much faster. Not thread-safe, but it can use several threads itself.
/// </remarks>
public sealed class BatchSimulator
{
    private readonly Trajectory[] _paths;
    private readonly GroupRun _groups;
    private readonly GroupRun _alone;
    private BatchLaunches? _launches;
    private BatchResults? _plays;
    private LookAheadRequest? _request;

    /// <summary>Creates a batch simulator for a compiled scene.</summary>
    /// <param name="simulator">The compiled scene.</param>
    /// <param name="threads">The number of threads; the results do not depend on it. 1 … 1024; default 1. Only one is used if balls can move objects.</param>
    /// <exception cref="ArgumentNullException"><paramref name="simulator"/> is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException"><paramref name="threads"/> is out of range.</exception>
    public BatchSimulator(Simulator simulator, int threads = 1)
    {
        Simulator = simulator ?? throw new ArgumentNullException(nameof(simulator));
        Check.Within(nameof(threads), threads, 1, 1024);
        _paths = new Trajectory[threads];
        for (int i = 0; i < threads; i++)
        {
            _paths[i] = new Trajectory();
        }

        _groups = new GroupRun(threads, (thread, from, count) => Run(thread, from, count));
        _alone = new GroupRun(1, (thread, from, count) => Run(thread, from, count));
    }

    /// <summary>The scene.</summary>
    public Simulator Simulator { get; }

    /// <summary>Simulates the first balls of an array of launches.</summary>
    /// <param name="launches">The launches.</param>
    /// <param name="plays">Receives the result of each launch at the same index.</param>
    /// <param name="count">The number of balls; 0 … the capacity of both.</param>
    /// <param name="request">The duration, the step, and the conditions that end a run.</param>
    /// <param name="progress">Receives the number of finished balls from time to time, on a worker thread; default none.</param>
    /// <param name="cancellation">Cancels the run between two groups of balls; default never.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range. Some results may have been written.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled. Some results may have been written.</exception>
    public void Run(
        BatchLaunches launches, BatchResults plays, int count, LookAheadRequest request, IProgress<int>? progress = null, CancellationToken cancellation = default)
    {
        _launches = launches ?? throw new ArgumentNullException(nameof(launches));
        _plays = plays ?? throw new ArgumentNullException(nameof(plays));
        _request = request ?? throw new ArgumentNullException(nameof(request));
        Check.Within(nameof(count), count, 0, Math.Min(launches.Capacity, plays.Capacity));

        // Movable objects, engine colliders and bodies are shared state of the simulator, so use one thread.
        bool isShared = Simulator.World.GivesWay || Simulator.World.Engine is not null || request.MoveBodies is not null;
        (isShared ? _alone : _groups).Run(count, progress, cancellation);
    }

    private void Run(int thread, int from, int count)
    {
        for (int index = from; index < from + count; index++)
        {
            BallState ball = Simulator.Launch(_launches!.Position[index], _launches.Velocity[index], _launches.Spin[index]);
            Simulator.LookAhead(in ball, _request!, _paths[thread]);
            Write(index, _paths[thread]);
        }
    }

    private void Write(int index, Trajectory path)
    {
        BatchResults plays = _plays!;
        BallState end = path.Final;
        double time = end.Time;
        Vector3d position = end.Position;
        Vector3d velocity = end.Velocity;
        PathPoint crossing = default;
        bool crossed = _request!.UntilPlane is { } plane && path.TryGetCrossing(in plane, out crossing);
        if (crossed)
        {
            time = crossing.Time;
            position = crossing.Position;
            velocity = crossing.Velocity;
        }

        long bounces = 0;
        bool scored = false;
        for (int i = 0; i < path.Events.Count; i++)
        {
            ref readonly BallEvent happened = ref path.Events[i];
            if (happened.Time <= time)
            {
                bounces += happened.Kind == BallEventKind.Impact ? 1 : 0;
                scored |= happened.Kind == BallEventKind.Goal;
            }
        }

        // A complete path counts all its impacts, including dropped events.
        bounces = crossed ? bounces : path.Events.Impacts;
        plays.Crossed[index] = crossed;
        plays.Rests[index] = !crossed && end.Motion == MotionState.Rest;
        plays.Scored[index] = scored;
        plays.Bounces[index] = (int)bounces;
        plays.Time[index] = time;
        plays.Position[index] = position;
        plays.Velocity[index] = velocity;
        plays.Spin[index] = end.Spin;
        int samples = 0;
        for (double at = 0; samples < plays.Samples && at <= time; at = samples * plays.Interval)
        {
            plays.Places[(index * plays.Samples) + samples++] = path.PositionAt(at);
        }

        plays.SampleCount[index] = samples;
    }
}
