using System.Runtime.ExceptionServices;

namespace FootballPhysics.Batch;

/// <summary>Hands groups of balls to threads, in order, until none are left.</summary>
/// <remarks>
/// What a group throws ends the run, and comes out as it was thrown. Of several it is the first group's: every group before one that has
/// begun has begun too, so it does not depend on the number of threads.
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

    /// <summary>Makes a run that can be made again.</summary>
    /// <param name="threads">How many threads.</param>
    /// <param name="work">Does a group: by which thread, from which ball, and how many.</param>
    public GroupRun(int threads, Action<int, int, int> work)
    {
        _threads = threads;
        _work = work;
        _take = Take;
    }

    /// <summary>Does so many balls.</summary>
    /// <param name="count">How many.</param>
    /// <param name="progress">Told after every group how many are done; one call at a time.</param>
    /// <param name="cancellation">Ends the run between two groups.</param>
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
