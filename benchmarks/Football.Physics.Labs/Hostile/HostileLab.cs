using System.Globalization;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Hostile;

/// <summary>football lab stability --hostile: scenes from far outside football, and what was found in them.</summary>
internal static class HostileLab
{
    public const long ByDefault = 20_000;
    public const long Full = 1_000_000;

    /// <summary>Plays scenes whose numbers follow from the seed: those of one are not those of another.</summary>
    /// <param name="seed">Seed; from 1 on. Scenes of seed 1 have the numbers from 1 on, those of seed 2 from 1 000 001 on.</param>
    /// <param name="count">How many.</param>
    /// <param name="jobs">Threads.</param>
    /// <param name="progress">Told how many are done.</param>
    public static LabReport Run(long seed, long count, int jobs, Progress progress)
    {
        long first = ((seed - 1) * Full) + 1;
        var run = new HostileRun();
        long done = 0;
        Parallel.For(0L, count, new ParallelOptions { MaxDegreeOfParallelism = jobs }, i =>
        {
            run.Play((ulong)(first + i));
            long now = Interlocked.Increment(ref done);
            if (now % 64 == 0)
            {
                lock (progress)
                {
                    progress.Report(now, count, () => string.Create(CultureInfo.InvariantCulture, $"scenes, {run.Findings.Kinds} kinds of findings"));
                }
            }
        });
        var report = new LabReport { Name = "hostile", Seed = seed, Failed = run.Findings.Findings.Count > 0 };
        LabTable findings = new(
            string.Create(CultureInfo.InvariantCulture, $"{count} hostile scenes: what was found"),
            "finding", "times", "worst", "scene", "detail", "tamest, decades", "its scene", "its detail");
        Add(findings, run.Findings.Findings);
        LabTable refusals = new("scenes that are refused", "field", "times", "worst", "scene", "detail", "tamest, decades", "its scene", "its detail");
        Add(refusals, run.Findings.Refusals);
        report.Tables.Add(findings);
        report.Tables.Add(refusals);
        report.Notes.Add(string.Create(CultureInfo.InvariantCulture, $"{run.Frames} frames, {run.Events} events, {run.Rests} rests, {run.Stalled} frames stalled."));
        report.Notes.Add(string.Create(CultureInfo.InvariantCulture, $"Slowest frame: {run.Slowest.Milliseconds:0.0} ms in scene {run.Slowest.Scene}. One scene again: football lab stability --hostile --scene I"));
        return report;
    }

    /// <summary>Plays one scene frame by frame.</summary>
    public static LabReport One(Terminal terminal, long number)
    {
        HostileScene scene = HostileGenerator.Make((ulong)number);
        terminal.Person.WriteLine(scene.Text());
        var run = new HostileRun();
        run.Play((ulong)number);
        var report = new LabReport { Name = "hostile", Seed = 0, Failed = run.Findings.Findings.Count > 0 };
        if (run.Findings.Refusals.Count == 0)
        {
            report.Tables.Add(Frames(scene));
        }

        LabTable findings = new("findings", "finding", "times", "worst", "scene", "detail", "tamest, decades", "its scene", "its detail");
        Add(findings, run.Findings.Findings);
        Add(findings, run.Findings.Refusals);
        report.Tables.Add(findings);
        return report;
    }

    private static void Add(LabTable table, IReadOnlyDictionary<string, HostileFinding> findings)
    {
        foreach ((string kind, HostileFinding finding) in findings)
        {
            table.Add(
                kind, finding.Count, finding.Worst.Size, (long)finding.Worst.Scene, finding.Worst.Detail,
                finding.Tamest.Absurdity, (long)finding.Tamest.Scene, finding.Tamest.Detail);
        }
    }

    private static LabTable Frames(HostileScene scene)
    {
        var table = new LabTable("frames", "length, s", "time, s", "motion", "height, m", "velocity, m/s", "spin, rad/s", "energy, J", "pieces", "stalled", "events");
        var simulator = new Simulator(scene.Scene, scene.Settings);
        BallState state = simulator.Launch(scene.Position, scene.Velocity, scene.Spin);
        var log = new StepLog();
        foreach (double length in scene.Frames)
        {
            log.Clear();
            simulator.Step(ref state, length, log);
            table.Add(
                length, state.Time, state.Motion, state.Position.Y - simulator.ContactHeight, state.Velocity, state.Spin,
                scene.Energy(in state, simulator.ContactHeight), log.Steps, log.StalledSteps, log.Events.Count);
        }

        return table;
    }
}
