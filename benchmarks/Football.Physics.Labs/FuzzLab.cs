using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Labs.Fuzz;

namespace FootballPhysics.Labs;

/// <summary>football lab fuzz: tries bytes and text that are changed according to their format.</summary>
internal static class FuzzLab
{
    private const long ByDefault = 1_000_000;
    private const long Most = 1_000_000_000_000;
    private const int LongestInput = 4000;

    public static Command Create(Terminal terminal)
    {
        Option<long> count = Arguments.Whole("--count", "Inputs of each kind.", 1, Most, ByDefault);
        Option<long> jobs = Arguments.Jobs("Threads; default: one per processor.");
        return LabOptions.Create(
            "fuzz",
            "Randomly corrupted scenarios, kick logs, recordings and snapshots: each is rejected or gives a correct result.",
            ["football lab fuzz --count 100", "football lab fuzz --count 300 --seed 7"],
            terminal,
            (parsed, seed, progress) => Run("fuzz", seed, parsed.GetValue(count), (int)parsed.GetValue(jobs), FuzzTarget.All, progress),
            count,
            jobs);
    }

    /// <summary>Tries inputs of several kinds.</summary>
    /// <param name="name">Name of the experiment.</param>
    /// <param name="seed">The seed.</param>
    /// <param name="count">The number of inputs of each kind.</param>
    /// <param name="jobs">The number of threads.</param>
    /// <param name="targets">The kinds.</param>
    /// <param name="progress">Receives the progress.</param>
    internal static LabReport Run(string name, long seed, long count, int jobs, IReadOnlyList<FuzzTarget> targets, Progress progress)
    {
        var table = new LabTable(
            string.Create(CultureInfo.InvariantCulture, $"{count} inputs of each kind"), "kind", "refused", "right", "found", "slowest, ms", "its number", "verdict");
        var findings = new LabTable("what must not be", "kind", "finding", "times", "first", "its input");
        var report = new LabReport { Name = name, Seed = seed, Tables = { table } };
        foreach (FuzzTarget target in targets)
        {
            var run = new FuzzRun(target, seed);
            long done = 0;
            Parallel.For(0L, count, new ParallelOptions { MaxDegreeOfParallelism = jobs }, i =>
            {
                run.Try(i);
                long now = Interlocked.Increment(ref done);
                if (now % 256 == 0)
                {
                    lock (progress)
                    {
                        progress.Report(now, count, () => target.Name);
                    }
                }
            });
            table.Add(target.Name, run.Refused, run.Right, run.Findings.Values.Sum(found => found.Times), run.Slowest, run.SlowestInput, Verdict.Of(run.Findings.Count == 0));
            foreach ((string what, (long times, long first)) in run.Findings)
            {
                findings.Add(target.Name, what, times, first, Quote.Short(target.Text(run.Input(first)), LongestInput));
            }
        }

        if (findings.Rows.Count > 0)
        {
            report.Tables.Add(findings);
            report.Failed = true;
        }

        using var process = Process.GetCurrentProcess();
        report.Notes.Add(string.Create(CultureInfo.InvariantCulture, $"Peak memory: {process.PeakWorkingSet64 / 1048576.0:0} MiB."));
        return report;
    }
}
