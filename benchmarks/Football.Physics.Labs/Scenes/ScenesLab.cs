using System.CommandLine;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Scenes;

/// <summary>football lab scenes: compares random seams, turning bodies, carriers, kerbs and slopes with independent references.</summary>
internal static class ScenesLab
{
    /// <summary>The number of failures shown per group.</summary>
    private const int Shown = 3;

    private static readonly SceneKind[] s_kinds = [new Seams(), new Turns(), new Carriers(), new Kerbs(), new Slopes()];

    public static Command Create(Terminal terminal)
    {
        var lab = new Lab(
            "scenes",
            "Random seams, turning bodies, moving floors, kerbs and slopes, compared with closed forms, exact rotations and a reference integration.",
            ["football lab scenes --only kerbs --count 20 --seed 7"]);
        Option<long> count = lab.Whole("--count", "Scenes of each kind; ten times as many seams.", 1, 10_000_000, 1000);
        Option<string?> only = lab.Only("KIND", "Run one kind", s_kinds.Select(kind => kind.Name));
        Option<long?> scene = lab.Add(Arguments.Whole("--scene", "One scene by its number, with --only.", 0, long.MaxValue));
        Option<long> jobs = lab.Jobs("Threads.");
        return lab.Command(terminal, run =>
        {
            SceneKind[] kinds = [.. s_kinds.Where(kind => run.Get(only) is not { } name || kind.Name == name)];
            if (run.Get(scene) is { } index)
            {
                One(run, index, kinds.Length == 1 ? kinds[0] : throw new RefusedException("--scene requires --only KIND."));
                return;
            }

            Run(run, run.Get(count), kinds, run.Int(jobs));
        });
    }

    private static void One(LabRun run, long index, SceneKind kind)
    {
        SceneOutcome outcome = kind.Play(run.Seed, index);
        LabTable table = run.Table(FormattableString.Invariant($"{kind.Name} {index}"), "group", "error", "limit", "detail", "verdict");
        table.Add(outcome.Group, outcome.Error, outcome.Limit, outcome.Detail, outcome.Holds ? "holds" : "FAILED");
        run.Failed = !outcome.Holds;
    }

    private static void Run(LabRun run, long count, SceneKind[] kinds, int jobs)
    {
        LabTable table = run.Table("Random scenes, and how far off the library is", "kind", "of", "scenes", "wrong answers", "beyond the limit", "median error", "worst error", "at scene", "verdict");
        var failures = new LabTable("failures", "kind", "scene", "of", "detail");
        foreach (SceneKind kind in kinds)
        {
            SceneOutcome[] outcomes = run.Parallel(count * kind.Share, jobs, kind.Name, index => kind.Play(run.Seed, index));
            foreach (var group in outcomes.Select((outcome, index) => (Outcome: outcome, Index: index)).GroupBy(item => item.Outcome.Group).OrderBy(group => group.Key, StringComparer.Ordinal))
            {
                var worst = group.MaxBy(item => item.Outcome.Agrees ? item.Outcome.Error : -1);
                double[] errors = [.. group.Select(item => item.Outcome.Error).Order()];
                int failed = group.Count(item => !item.Outcome.Holds);
                table.Add(
                    kind.Name, group.Key, errors.Length, group.Count(item => !item.Outcome.Agrees), group.Count(item => item.Outcome.Agrees && !item.Outcome.Holds),
                    errors[errors.Length / 2], worst.Outcome.Error, worst.Index, failed == 0 ? "holds" : FormattableString.Invariant($"{failed} FAILED"));
                run.Failed |= failed > 0;
                failures.Rows.AddRange(group.Where(item => !item.Outcome.Holds).Take(Shown).Select(item => new object?[] { kind.Name, item.Index, group.Key, item.Outcome.Detail }));
            }

            run.Notes.Add($"{kind.Name}: {kind.Claim}");
        }

        if (failures.Rows.Count > 0)
        {
            run.Tables.Add(failures);
        }
    }
}
