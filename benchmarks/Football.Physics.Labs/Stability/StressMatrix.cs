using System.Collections.Concurrent;
using System.Diagnostics;

namespace FootballPhysics.Labs.Stability;

/// <summary>Plays many scenes on all processors and sorts their verdicts into cells.</summary>
internal sealed class StressMatrix(Func<long, StressScene> make)
{
    /// <summary>A scene that runs for longer than this, s, is worth a word.</summary>
    private const double Long = 10;

    private readonly ConcurrentDictionary<long, long> _running = new();
    private readonly Lock _lock = new();
    private readonly StressCell[,] _cells = Fresh();

    /// <summary>The cell of a kind and a method.</summary>
    public StressCell this[StressKind kind, Integrator integrator] => _cells[(int)kind, (int)integrator];

    /// <summary>All of them.</summary>
    public IEnumerable<StressCell> Cells => _cells.Cast<StressCell>();

    /// <summary>The scene that took longest: its number and its time, s.</summary>
    public (long Index, double Seconds) Slowest { get; private set; }

    /// <summary>Plays the scenes from 0 on.</summary>
    /// <param name="scenes">How many.</param>
    /// <param name="jobs">Threads.</param>
    /// <param name="onProgress">Told how many are done.</param>
    /// <param name="onStuck">Told of a scene that has run for long.</param>
    public void Play(long scenes, int jobs, Action<long> onProgress, Action<long> onStuck)
    {
        long done = 0;
        using var watch = new Timer(
            _ =>
            {
                foreach ((long index, long since) in _running)
                {
                    if (Stopwatch.GetElapsedTime(since).TotalSeconds > Long)
                    {
                        onStuck(index);
                    }
                }
            },
            null,
            TimeSpan.FromSeconds(Long),
            TimeSpan.FromSeconds(Long));
        Parallel.For(0L, scenes, new ParallelOptions { MaxDegreeOfParallelism = jobs }, index =>
        {
            StressScene scene = make(index);
            long start = Stopwatch.GetTimestamp();
            _running[index] = start;
            StressOutcome outcome = StressRun.Play(scene);
            _running.TryRemove(index, out _);
            double seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
            lock (_lock)
            {
                this[scene.Kind, scene.Integrator].Add(index, in outcome);
                Slowest = seconds > Slowest.Seconds ? (index, seconds) : Slowest;
                if (++done % 64 == 0)
                {
                    onProgress(done);
                }
            }
        });
    }

    private static StressCell[,] Fresh()
    {
        var cells = new StressCell[StressGenerator.Kinds.Count, StressGenerator.Integrators.Count];
        for (int i = 0; i < cells.GetLength(0); i++)
        {
            for (int j = 0; j < cells.GetLength(1); j++)
            {
                cells[i, j] = new StressCell();
            }
        }

        return cells;
    }
}
