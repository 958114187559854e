namespace FootballPhysics.Batch;

/// <summary>Plays thousands of independent balls of one scene beyond their first impact: to a plane, to rest, or to a time, with their paths.</summary>
/// <remarks>
/// Ball by ball in double, on several threads. Each result depends on its own launch alone. For flights to the first impact <see cref="BallBatch"/> is much faster.
/// Not for several threads at once; its own threads are.
/// </remarks>
public sealed class BatchSimulator
{
    private readonly Trajectory[] _paths;
    private readonly GroupRun _groups;
    private readonly GroupRun _alone;
    private BatchLaunches? _launches;
    private BatchResults? _plays;
    private LookAheadRequest? _request;

    /// <summary>Prepares for balls of a compiled scene.</summary>
    /// <param name="simulator">The scene.</param>
    /// <param name="threads">How many threads; one where a ball may move what it meets. The results do not depend on it. 1 … 1024; default 1.</param>
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

    /// <summary>Plays the first balls of some launches.</summary>
    /// <param name="launches">The launches.</param>
    /// <param name="plays">Where the answers go, each at its launch's index.</param>
    /// <param name="count">How many balls; 0 … the capacity of both.</param>
    /// <param name="request">How far to play, in which steps, and what ends it.</param>
    /// <param name="progress">Told now and then how many are done, on the thread that did them; default nobody.</param>
    /// <param name="cancellation">Ends the run between two groups of balls; default never.</param>
    /// <exception cref="ArgumentNullException">An argument is null.</exception>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range; the message names field, value and range. Some answers may have been written.</exception>
    /// <exception cref="OperationCanceledException">The run was cancelled. Some answers may have been written.</exception>
    public void Run(
        BatchLaunches launches, BatchResults plays, int count, LookAheadRequest request, IProgress<int>? progress = null, CancellationToken cancellation = default)
    {
        _launches = launches ?? throw new ArgumentNullException(nameof(launches));
        _plays = plays ?? throw new ArgumentNullException(nameof(plays));
        _request = request ?? throw new ArgumentNullException(nameof(request));
        Check.Within(nameof(count), count, 0, Math.Min(launches.Capacity, plays.Capacity));

        // What an impact moves, what an engine says and where the game has its bodies belong to the simulator: one ball at a time.
        bool isShared = Simulator.World.GivesWay || Simulator.World.Engine is not null || request.MoveBodies is not null;
        (isShared ? _alone : _groups).Run(count, progress, cancellation);
    }

    private void Run(int thread, int from, int count)
    {
        for (int index = from; index < from + count; index++)
        {
            Trajectory path = _paths[thread];
            BallState ball = Simulator.Launch(_launches!.Position[index], _launches.Velocity[index], _launches.Spin[index]);
            Simulator.LookAhead(in ball, _request!, path);
            while (!path.IsComplete)
            {
                // Nothing but its memory ends a path early: what a force of the game's own throws comes through.
                path = new Trajectory(2 * path.Pieces.Length);
                _paths[thread] = path;
                Simulator.LookAhead(in ball, _request!, path);
            }

            Write(index, path);
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

        // To its end a path has as many as were counted, also those that its memory of events has no place for.
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
