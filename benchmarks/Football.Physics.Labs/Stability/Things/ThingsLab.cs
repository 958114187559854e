using System.Collections.Concurrent;
using System.Diagnostics;
using System.Globalization;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stability.Things;

/// <summary>football lab stability --things: random scenes with obstacles, bodies, nets and slopes.</summary>
internal static class ThingsLab
{
    public const long ByDefault = 20_000;
    public const long Full = 1_000_000;

    /// <summary>A scene that runs for longer than this, s, is worth a word.</summary>
    private const double Long = 10;

    /// <summary>Failures that are shown of a kind.</summary>
    private const int Shown = 5;

    /// <summary>Plays one scene.</summary>
    public static LabReport One(long seed, long index)
    {
        ThingsRun run = ThingsRun.Play(seed, index);
        var report = new LabReport { Name = "things", Seed = seed, Failed = run.Failure is not null };
        var table = new LabTable(FormattableString.Invariant($"scene {index}"), "kind", "frames", "impacts", "most pieces a frame", "verdict");
        table.Add(run.Kind, run.Frames, run.Impacts, run.Pieces, run.Failure is { } f ? $"{f.Check}: {f.Detail}" : "holds");
        report.Tables.Add(table);
        return report;
    }

    /// <summary>Plays scenes from 0 on.</summary>
    public static LabReport Run(Terminal terminal, long seed, long count, int jobs, Progress progress)
    {
        var running = new ConcurrentDictionary<long, long>();
        using var watch = new Timer(
            _ =>
            {
                foreach (long index in running.Where(item => Stopwatch.GetElapsedTime(item.Value).TotalSeconds > Long).Select(item => item.Key))
                {
                    terminal.Error.WriteLine(string.Create(CultureInfo.InvariantCulture, $"scene {index} of seed {seed} has been running for more than {Long:0} s"));
                }
            },
            null,
            TimeSpan.FromSeconds(Long),
            TimeSpan.FromSeconds(Long));
        int kinds = Enum.GetValues<ThingsKind>().Length;
        var totals = new long[kinds, 6];
        var failures = new List<(long Index, ThingsKind Kind, StressFailure Failure)>();
        long done = 0;
        var gate = new Lock();
        Parallel.For(0L, count, new ParallelOptions { MaxDegreeOfParallelism = jobs }, index =>
        {
            running[index] = Stopwatch.GetTimestamp();
            ThingsRun run = ThingsRun.Play(seed, index);
            running.TryRemove(index, out _);
            lock (gate)
            {
                int row = (int)run.Kind;
                totals[row, 0]++;
                totals[row, 1] += run.Failure is null ? 0 : 1;
                totals[row, 2] += run.Frames;
                totals[row, 3] += run.Impacts;
                totals[row, 4] += run.InNets;
                totals[row, 5] = Math.Max(totals[row, 5], run.Pieces);
                if (run.Failure is { } failure)
                {
                    failures.Add((index, run.Kind, failure));
                }

                if (++done % 64 == 0)
                {
                    progress.Report(done, count, () => string.Create(CultureInfo.InvariantCulture, $"scenes, {failures.Count} failed"));
                }
            }
        });
        var report = new LabReport { Name = "things", Seed = seed, Failed = failures.Count > 0 };
        var table = new LabTable(
            string.Create(CultureInfo.InvariantCulture, $"{count} scenes with things: does every invariant hold?"),
            "scenes", "how many", "verdict", "frames", "impacts", "frames in nets", "most pieces a frame");
        for (int row = 0; row < kinds; row++)
        {
            table.Add(
                (ThingsKind)row, totals[row, 0], totals[row, 1] == 0 ? "holds" : string.Create(CultureInfo.InvariantCulture, $"{totals[row, 1]} FAILED"),
                totals[row, 2], totals[row, 3], totals[row, 4], totals[row, 5]);
        }

        report.Tables.Add(table);
        if (failures.Count > 0)
        {
            var failed = new LabTable("failures", "scene", "kind", "check", "times", "detail");
            foreach (var group in failures.GroupBy(item => (item.Kind, item.Failure.Check)))
            {
                foreach ((long index, ThingsKind kind, StressFailure failure) in group.OrderBy(item => item.Index).Take(Shown))
                {
                    failed.Add(index, kind, failure.Check, group.Count(), failure.Detail);
                }
            }

            report.Tables.Add(failed);
        }

        report.Notes.Add("Checked after every frame: no overlap beyond 1e-9 m, nothing passed through on the way, no impact that gives energy in the frame of what was hit, "
            + "bounded work, the mirror image to the last bit (but on uneven ground), and the frame played again from a snapshot to the last bit, always in nets.");
        return report;
    }
}
