using System.Globalization;
using FootballPhysics.Drawing;
using FootballPhysics.Scenarios;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stability;

/// <summary>The stress matrix: kinds of scenes by integrators.</summary>
internal sealed class StressSet(long seed, Profile profile) : SceneSet
{
    public override string Name => "stability";

    public override long ByDefault => 60_000;

    public override long Full => 1_040_000;

    public override StressOutcome Play(long scene) => StressRun.Play(Make(scene));

    public override void Show(long scene, StressOutcome outcome, Terminal terminal, LabReport report)
    {
        terminal.Person.WriteLine(Make(scene).Text());
        var table = new LabTable($"scene {scene}", "kind", "method", "frames", "steps", "impacts", "verdict");
        table.Add(outcome.Kind, outcome.Method, outcome.Tally.Frames, outcome.Tally.Steps, outcome.Tally.Impacts, outcome.Verdict);
        report.Tables.Add(table);
    }

    public override void Show(StressResults results, long count, LabReport report)
    {
        string[] methods = [.. StressGenerator.Integrators.Select(method => method.ToString())];
        var table = new LabTable(
            string.Create(CultureInfo.InvariantCulture, $"{count} scenes: does every invariant hold?"),
            ["scenes", .. methods, "a cell", "steps a frame", "stalled", "impacts"]);
        var energy = new LabTable("most energy made in a frame, as a share of what the method's own error can be", ["scenes", .. methods]);
        foreach (string kind in StressGenerator.Kinds.Select(kind => kind.ToString()))
        {
            Tally[] cells = [.. StressGenerator.Integrators.Select(method => results.Of(kind, method))];
            Tally row = results.Of(kind);
            table.Add([kind, .. cells.Select(cell => cell.Verdict), row.Scenes / cells.Length, (double)row.Steps / Math.Max(1, row.Frames), row.Stalled, row.Impacts]);
            energy.Add([kind, .. cells.Select(cell => (object?)cell.EnergyShare)]);
        }

        report.Tables.AddRange([table, energy, Overshoot.Table()]);
        report.Picture = () => Figure.Stack("", [Overshoot.Draw()]);
        if (results.Findings.Kinds > 0)
        {
            report.Tables.Add(results.Findings.Table("failures", "finding"));
        }

        report.Notes.Add(string.Create(CultureInfo.InvariantCulture, $"Slowest scene: {results.Slowest.Scene}, {results.Slowest.Seconds:0.00} s. One scene again: football lab stability --seed {seed} --scene I"));
    }

    private StressScene Make(long scene)
    {
        StressScene made = StressGenerator.Make(seed, scene);
        return profile == Profile.Measured ? MeasuredStress.Of(made, seed, scene) : made;
    }
}
