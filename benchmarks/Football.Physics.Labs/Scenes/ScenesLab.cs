using System.CommandLine;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Scenes;

/// <summary>football lab scenes: compares random seams, turning bodies, carriers, kerbs and slopes with independent references.</summary>
internal static class ScenesLab
{
    private const int ByDefault = 1000;

    /// <summary>The number of failures shown per group.</summary>
    private const int Shown = 3;

    private static readonly SceneKind[] s_kinds = [new Seams(), new Turns(), new Carriers(), new Kerbs(), new Slopes()];

    public static Command Create(Terminal terminal)
    {
        Option<long> count = Arguments.Whole("--count", "Scenes of each kind; ten times as many seams.", 1, 10_000_000, ByDefault);
        var only = new Option<string?>("--only") { HelpName = "KIND", Description = $"Run one kind: {string.Join(", ", s_kinds.Select(kind => kind.Name))}." };
        only.AcceptOnlyFromAmong([.. s_kinds.Select(kind => kind.Name)]);
        Option<long?> scene = Arguments.Whole("--scene", "One scene by its number, with --only.", 0, long.MaxValue);
        Option<long> jobs = Arguments.Jobs("Threads.");
        return LabOptions.Create(
            "scenes",
            "Random seams, turning bodies, moving floors, kerbs and slopes, compared with closed forms, exact rotations and a reference integration.",
            ["football lab scenes --only kerbs --count 20 --seed 7"],
            terminal,
            (parsed, seed, progress) =>
            {
                SceneKind[] kinds = [.. s_kinds.Where(kind => parsed.GetValue(only) is not { } name || kind.Name == name)];
                return parsed.GetValue(scene) is not { } index ? Run(seed, parsed.GetValue(count), kinds, (int)parsed.GetValue(jobs), progress)
                    : kinds.Length == 1 ? One(seed, index, kinds[0])
                    : throw new RefusedException("--scene requires --only KIND.");
            },
            count,
            only,
            scene,
            jobs);
    }

    private static LabReport One(long seed, long index, SceneKind kind)
    {
        SceneOutcome outcome = kind.Play(seed, index);
        var table = new LabTable(FormattableString.Invariant($"{kind.Name} {index}"), "group", "error", "limit", "detail", "verdict");
        table.Add(outcome.Group, outcome.Error, outcome.Limit, outcome.Detail, outcome.Holds ? "holds" : "FAILED");
        return new LabReport { Name = "scenes", Seed = seed, Failed = !outcome.Holds, Tables = { table } };
    }

    private static LabReport Run(long seed, long count, SceneKind[] kinds, int jobs, Progress progress)
    {
        var report = new LabReport { Name = "scenes", Seed = seed };
        var table = new LabTable("Random scenes, and how far off the library is", "kind", "of", "scenes", "wrong answers", "beyond the limit", "median error", "worst error", "at scene", "verdict");
        var failures = new LabTable("failures", "kind", "scene", "of", "detail");
        report.Tables.Add(table);
        long total = kinds.Sum(kind => count * kind.Share);
        long done = 0;
        var gate = new Lock();
        foreach (SceneKind kind in kinds)
        {
            var outcomes = new SceneOutcome[count * kind.Share];
            Parallel.For(0L, outcomes.Length, new ParallelOptions { MaxDegreeOfParallelism = jobs }, index =>
            {
                outcomes[index] = kind.Play(seed, index);
                lock (gate)
                {
                    progress.Report(++done, total, () => kind.Name);
                }
            });
            foreach (var group in outcomes.Select((outcome, index) => (Outcome: outcome, Index: index)).GroupBy(item => item.Outcome.Group).OrderBy(group => group.Key, StringComparer.Ordinal))
            {
                var worst = group.MaxBy(item => item.Outcome.Agrees ? item.Outcome.Error : -1);
                double[] errors = [.. group.Select(item => item.Outcome.Error).Order()];
                int failed = group.Count(item => !item.Outcome.Holds);
                table.Add(
                    kind.Name, group.Key, errors.Length, group.Count(item => !item.Outcome.Agrees), group.Count(item => item.Outcome.Agrees && !item.Outcome.Holds),
                    errors[errors.Length / 2], worst.Outcome.Error, worst.Index, failed == 0 ? "holds" : FormattableString.Invariant($"{failed} FAILED"));
                report.Failed |= failed > 0;
                foreach ((SceneOutcome outcome, int index) in group.Where(item => !item.Outcome.Holds).Take(Shown))
                {
                    failures.Add(kind.Name, index, group.Key, outcome.Detail);
                }
            }

            report.Notes.Add($"{kind.Name}: {kind.Claim}");
        }

        if (failures.Rows.Count > 0)
        {
            report.Tables.Add(failures);
        }

        return report;
    }
}
