using System.Collections.Concurrent;
using System.Diagnostics;

namespace FootballPhysics.Labs.Stability;

/// <summary>Simulates many scenes on all processors, and sums their outcomes.</summary>
internal sealed class StressResults
{
    /// <summary>A scene that takes longer than this, s, is reported.</summary>
    private const double Long = 10;

    private readonly Lock _lock = new();
    private readonly Dictionary<(string Kind, Integrator Method), Tally> _cells = [];

    public Findings Findings { get; } = new();

    /// <summary>Scenes that the library rejects, by field.</summary>
    public Findings Refusals { get; } = new();

    /// <summary>The longest time of a scene, s, and its number.</summary>
    public Peak<double, long> Slowest { get; } = new(0);

    public Tally Of(string kind, Integrator method) => _cells.GetValueOrDefault((kind, method));

    public Tally Of(string kind) => _cells.Where(cell => cell.Key.Kind == kind).Aggregate(default(Tally), (sum, cell) => sum + cell.Value);

    public Tally Total => _cells.Values.Aggregate(default(Tally), (sum, cell) => sum + cell);

    /// <summary>Adds a scene.</summary>
    public void Add(long scene, StressOutcome outcome, double seconds = 0)
    {
        lock (_lock)
        {
            _cells[(outcome.Kind, outcome.Method)] = Of(outcome.Kind, outcome.Method) + outcome.Tally;
            Slowest.See(seconds, scene);
            foreach (Finding found in outcome.Findings)
            {
                Findings.Add(outcome.Kind.Length > 0 ? $"{outcome.Kind}, {outcome.Method}: {found.Check}" : found.Check, scene, found);
            }

            if (outcome.Refusal is { } refusal)
            {
                Refusals.Add(refusal.Check, scene, refusal);
            }
        }
    }

    /// <summary>Simulates scenes of a set, from its first one on.</summary>
    public void Play(SceneSet set, long count, int jobs, LabRun run)
    {
        var running = new ConcurrentDictionary<long, long>();
        using var watch = new Timer(
            _ =>
            {
                foreach (long scene in running.Where(item => Stopwatch.GetElapsedTime(item.Value).TotalSeconds > Long).Select(item => item.Key))
                {
                    run.Terminal.Error.WriteLine(FormattableString.Invariant($"scene {scene} has been running for more than {Long:0} s"));
                }
            },
            null,
            TimeSpan.FromSeconds(Long),
            TimeSpan.FromSeconds(Long));
        run.Parallel(set.First, count, jobs, "scenes", scene =>
        {
            long start = running[scene] = Stopwatch.GetTimestamp();
            StressOutcome outcome = set.Play(scene);
            running.TryRemove(scene, out _);
            Add(scene, outcome, Stopwatch.GetElapsedTime(start).TotalSeconds);
        });
    }
}
