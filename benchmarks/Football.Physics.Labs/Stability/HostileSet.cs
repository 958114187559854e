using System.Globalization;
using FootballPhysics.Tool.Commands;

namespace FootballPhysics.Labs.Stability;

/// <summary>Scenes far outside football, and their findings. Scenes of seed 1 have the numbers from 1 on, those of seed 2 from 1 000 001 on.</summary>
internal sealed class HostileSet(long seed) : SceneSet
{
    public override string Name => "hostile";

    public override long ByDefault => 20_000;

    public override long First => ((seed - 1) * Full) + 1;

    public override StressOutcome Play(long scene) => StressRun.PlayHostile(HostileGenerator.Make((ulong)scene));

    public override void Show(long scene, StressOutcome outcome, Terminal terminal, LabReport report)
    {
        StressScene made = HostileGenerator.Make((ulong)scene);
        terminal.Person.WriteLine(made.Text());
        if (made.HasOwnForces)
        {
            terminal.Person.WriteLine($"Forces of its own: {string.Join(", ", made.Scene.Forces.CustomForces)}");
        }

        if (outcome.Refusal is null)
        {
            report.Tables.Add(Frames(made));
        }

        var results = new StressResults();
        results.Add(scene, outcome);
        report.Tables.Add((outcome.Refusal is null ? results.Findings : results.Refusals).Table("findings", "finding"));
    }

    public override void Show(StressResults results, long count, LabReport report)
    {
        report.Tables.Add(results.Findings.Table(string.Create(CultureInfo.InvariantCulture, $"{count} hostile scenes: what was found"), "finding"));
        report.Tables.Add(results.Refusals.Table("scenes that are refused", "field"));
        Tally all = results.Total;
        report.Notes.Add(string.Create(CultureInfo.InvariantCulture, $"{all.Frames} frames, {all.Events} events, {all.Rests} rests, {all.StalledFrames} frames stalled."));
        report.Notes.Add(string.Create(CultureInfo.InvariantCulture, $"Slowest scene: {results.Slowest.Scene}, {results.Slowest.Seconds:0.00} s. One scene again: football lab stability --hostile --scene I"));
    }

    private static LabTable Frames(StressScene scene)
    {
        var table = new LabTable("frames", "length, s", "time, s", "motion", "height, m", "velocity, m/s", "spin, rad/s", "energy, J", "pieces", "stalled", "events");
        var simulator = new Simulator(scene.Scene, scene.Settings);
        var energy = new EnergyCheck(scene.Scene, scene.Settings, scene.Upward, simulator);
        BallState state = simulator.Launch(scene.Position, scene.Velocity, scene.Spin);
        var log = new StepLog();
        foreach (double length in scene.Frames)
        {
            log.Clear();
            simulator.Step(ref state, length, log);
            table.Add(
                length, state.Time, state.Motion, state.Position.Y - simulator.ContactHeight, state.Velocity, state.Spin,
                energy.Total(in state), log.Steps, log.StalledSteps, log.Events.Count);
        }

        return table;
    }
}
