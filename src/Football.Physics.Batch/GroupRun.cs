using System.Runtime.ExceptionServices;

namespace FootballPhysics.Batch;

/// <summary>Distributes groups of balls to threads, in order.</summary>
/// <remarks>
/// An exception in a group ends the run and is rethrown unchanged. If several groups throw, the first group's exception counts. Every group before a started one has
/// started too, so the result does not depend on the number of threads.
/// </remarks>
internal sealed class GroupRun
{
    private readonly int _threads;
    private readonly Action<int, int, int> _work;
    private readonly Action<int> _take;
    private readonly object _lock = new();
    private int _count;
    private int _next;
    private int _failedAt;
    private int _done;
    private ExceptionDispatchInfo? _failure;
    private IProgress<int>? _progress;
    private CancellationToken _cancellation;

    /// <summary>Creates a run that can be repeated.</summary>
    /// <param name="threads">The number of threads.</param>
    /// <param name="work">Processes a group: index of the thread, first ball, number of balls.</param>
    public GroupRun(int threads, Action<int, int, int> work)
    {
        _threads = threads;
        _work = work;
        _take = Take;
    }

    /// <summary>Processes a number of balls.</summary>
    /// <param name="count">The number of balls.</param>
    /// <param name="progress">Receives the number of finished balls after every group; one call at a time.</param>
    /// <param name="cancellation">Cancels the run between two groups.</param>
    /// <exception cref="OperationCanceledException">The run was cancelled.</exception>
    public void Run(int count, IProgress<int>? progress = null, CancellationToken cancellation = default)
    {
        _progress = progress;
        _cancellation = cancellation;
        _done = 0;
        _count = count;
        _next = 0;
        _failedAt = int.MaxValue;
        _failure = null;
        if (_threads == 1 || count <= LaneGroup.Size)
        {
            Take(0);
        }
        else
        {
            Parallel.For(0, _threads, new ParallelOptions { MaxDegreeOfParallelism = _threads }, _take);
        }

        _failure?.Throw();
    }

    private void Take(int thread)
    {
        while (true)
        {
            long from = (Interlocked.Increment(ref _next) - 1L) * LaneGroup.Size;
            if (from >= _count || from > Volatile.Read(ref _failedAt))
            {
                return;
            }

            int balls = Math.Min(LaneGroup.Size, _count - (int)from);
            try
            {
                _cancellation.ThrowIfCancellationRequested();
                _work(thread, (int)from, balls);
                Report(balls);
            }
            catch (Exception e)
            {
                Fail((int)from, e);
            }
        }
    }

    private void Report(int balls)
    {
        if (_progress is not null)
        {
            lock (_lock)
            {
                _done += balls;
                _progress.Report(_done);
            }
        }
    }

    private void Fail(int from, Exception e)
    {
        lock (_lock)
        {
            if (from < _failedAt)
            {
                _failedAt = from;
                _failure = ExceptionDispatchInfo.Capture(e);
            }
        }
    }
}
