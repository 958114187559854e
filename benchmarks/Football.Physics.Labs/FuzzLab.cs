using System.CommandLine;
using System.Diagnostics;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Labs.Fuzz;

namespace FootballPhysics.Labs;

/// <summary>football lab fuzz: tries bytes and text that are changed according to their format.</summary>
internal static class FuzzLab
{
    private const long ByDefault = 1_000_000;
    private const long Most = 1_000_000_000_000;
    private const int LongestInput = 4000;

    public static Lab Create()
    {
        var lab = new Lab(
            "fuzz",
            "Randomly corrupted scenarios, kick logs, recordings and snapshots: each is rejected or gives a correct result.",
            ["football lab fuzz --count 100", "football lab fuzz --count 300 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Inputs of each kind.", 1, Most, ByDefault);
        Option<long> jobs = lab.Jobs("Threads; default: one per processor.");
        return lab.Plays(run => Run(run, run.Get(count), run.Int(jobs), FuzzTarget.All));
    }

    /// <summary>Tries inputs of several kinds.</summary>
    /// <param name="lab">The run that receives the tables.</param>
    /// <param name="count">The number of inputs of each kind.</param>
    /// <param name="jobs">The number of threads.</param>
    /// <param name="targets">The kinds.</param>
    internal static void Run(LabRun lab, long count, int jobs, IReadOnlyList<FuzzTarget> targets)
    {
        LabTable table = lab.Table(FormattableString.Invariant($"{count} inputs of each kind"), "kind", "refused", "right", "found", "slowest, ms", "its number", "verdict");
        var findings = new LabTable("what must not be", "kind", "finding", "times", "first", "its input");
        foreach (FuzzTarget target in targets)
        {
            var run = new FuzzRun(target, lab.Seed);
            lab.Parallel(0, count, jobs, target.Name, run.Try);
            table.Judge(run.Findings.Count == 0, [target.Name, .. run.Counts.Cells("refused", "right"), run.Findings.Values.Sum(found => found.Times), run.Slowest.Most, run.Slowest.At]);
            foreach ((string what, (long times, long first)) in run.Findings)
            {
                findings.Add(target.Name, what, times, first, Quote.Short(target.Text(run.Input(first)), LongestInput));
            }
        }

        if (findings.Rows.Count > 0)
        {
            lab.Tables.Add(findings);
        }

        using var process = Process.GetCurrentProcess();
        lab.Notes.Add(FormattableString.Invariant($"Peak memory: {process.PeakWorkingSet64 / 1048576.0:0} MiB."));
    }
}
