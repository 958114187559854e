using System.Globalization;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stability.Things;

/// <summary>Random scenes with obstacles, bodies, nets and slopes.</summary>
internal sealed class ThingsSet(long seed) : SceneSet
{
    public override string Name => "things";

    public override long ByDefault => 20_000;

    public override StressOutcome Play(long scene) => ThingsRun.Play(seed, scene);

    public override void Show(long scene, StressOutcome outcome, Terminal terminal, LabReport report)
    {
        var table = new LabTable(FormattableString.Invariant($"scene {scene}"), "kind", "frames", "impacts", "most pieces a frame", "verdict");
        table.Add(outcome.Kind, outcome.Tally.Frames, outcome.Tally.Impacts, outcome.Tally.MostSteps, outcome.Verdict);
        report.Tables.Add(table);
    }

    public override void Show(StressResults results, long count, LabReport report)
    {
        var table = new LabTable(
            string.Create(CultureInfo.InvariantCulture, $"{count} scenes with things: does every invariant hold?"),
            "scenes", "how many", "verdict", "frames", "impacts", "frames in nets", "most pieces a frame");
        foreach (string kind in Enum.GetNames<ThingsKind>())
        {
            Tally row = results.Of(kind);
            table.Add(kind, row.Scenes, row.Failed == 0 ? "holds" : row.Verdict, row.Frames, row.Impacts, row.InNets, row.MostSteps);
        }

        report.Tables.Add(table);
        if (results.Findings.Kinds > 0)
        {
            report.Tables.Add(results.Findings.Table("failures", "finding"));
        }

        report.Notes.Add("Checked after every frame: no overlap beyond 1e-9 m, nothing passed through on the way, no impact that gives energy in the frame of what was hit, "
            + "bounded work, the mirror image to the last bit (but on uneven ground), and the frame played again from a snapshot to the last bit, always in nets.");
    }
}
