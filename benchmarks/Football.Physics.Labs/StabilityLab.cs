using System.CommandLine;
using System.Globalization;
using FootballPhysics.Tool.Commands;
using FootballPhysics.Drawing;
using FootballPhysics.Labs.Hostile;
using FootballPhysics.Labs.Stability;
using FootballPhysics.Labs.Stability.Things;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Labs;

/// <summary>football lab stability: the stress matrix.</summary>
internal static class StabilityLab
{
    private const long ByDefault = 60_000;
    private const long Full = 1_040_000;
    private const long MostScenes = 1_000_000_000_000;

    public static Command Create(Terminal terminal)
    {
        Option<long> scenes = Arguments.Whole("--scenes", $"Number of scenes; {HostileLab.ByDefault} by default if hostile.", 1, MostScenes, ByDefault);
        var full = new Option<bool>("--full") { Description = $"Simulate {Full} scenes, or {HostileLab.Full} hostile ones." };
        Option<long> jobs = Arguments.Jobs("Threads; default: one per processor.");
        var scene = new Option<long?>("--scene") { HelpName = "I", Description = "Simulate one scene by its number and print it as a scenario." };
        var hostile = new Option<bool>("--hostile") { Description = "Scenes far outside football, with a generator and checks of their own." };
        var things = new Option<bool>("--things") { Description = "Scenes with obstacles, bodies, nets and slopes, with checks of their own." };
        Option<Profile> profile = new("--profile") { HelpName = "measured|published", Description = "Profile of laws and ground; hostile scenes have their own.", DefaultValueFactory = _ => Profile.Measured };
        return LabOptions.CreateDrawn(
            "stability",
            "Invariants (finite, bounded energy, no penetration) in random and adversarial scenes, with every integrator.",
            ["football lab stability --scenes 100", "football lab stability --scene 7", "football lab stability --profile published --scenes 60", "football lab stability --hostile --scenes 100", "football lab stability --things --scenes 100"],
            terminal,
            (parsed, seed, progress) =>
            {
                bool isHostile = parsed.GetValue(hostile);
                bool hasThings = parsed.GetValue(things);
                bool asked = parsed.GetResult(scenes) is { Implicit: false };
                long count = parsed.GetValue(full) ? (isHostile ? HostileLab.Full : Full) : isHostile && !asked ? HostileLab.ByDefault : parsed.GetValue(scenes);
                if (hasThings)
                {
                    if (parsed.GetValue(scene) is { } number)
                    {
                        return ThingsLab.One(seed, number);
                    }

                    count = parsed.GetValue(full) ? ThingsLab.Full : asked ? count : ThingsLab.ByDefault;
                    return ThingsLab.Run(terminal, seed, count, (int)parsed.GetValue(jobs), progress);
                }

                int threads = (int)parsed.GetValue(jobs);
                StressScene Make(long index) => parsed.GetValue(profile) == Profile.Measured
                    ? MeasuredStress.Of(StressGenerator.Make(seed, index), seed, index)
                    : StressGenerator.Make(seed, index);
                return (isHostile, parsed.GetValue(scene)) switch
                {
                    (true, { } one) => HostileLab.One(terminal, one),
                    (true, null) => HostileLab.Run(seed, count, threads, progress),
                    (false, { } one) => One(terminal, seed, one, Make),
                    (false, null) => Run(terminal, seed, count, threads, progress, Make),
                };
            },
            scenes,
            full,
            jobs,
            scene,
            hostile,
            things,
            profile);
    }

    private static LabReport One(Terminal terminal, long seed, long index, Func<long, StressScene> make)
    {
        StressScene scene = make(index);
        terminal.Person.WriteLine(scene.Text());
        StressOutcome outcome = StressRun.Play(scene);
        var report = new LabReport { Name = "stability", Seed = seed, Failed = outcome.Failure is not null };
        var table = new LabTable($"scene {index}", "kind", "method", "frames", "steps", "impacts", "verdict");
        table.Add(scene.Kind, scene.Integrator, outcome.Frames, outcome.Steps, outcome.Impacts, outcome.Failure is { } f ? $"{f.Check}: {f.Detail}" : "holds");
        report.Tables.Add(table);
        return report;
    }

    private static LabReport Run(Terminal terminal, long seed, long scenes, int jobs, Progress progress, Func<long, StressScene> make)
    {
        var matrix = new StressMatrix(make);
        matrix.Play(
            scenes,
            jobs,
            done => progress.Report(done, scenes, () => string.Create(CultureInfo.InvariantCulture, $"scenes, {matrix.Cells.Sum(cell => cell.Failed)} failed")),
            stuck => terminal.Error.WriteLine(string.Create(CultureInfo.InvariantCulture, $"scene {stuck} of seed {seed} has been running for more than 10 s")));
        var report = new LabReport { Name = "stability", Seed = seed, Failed = matrix.Cells.Any(cell => cell.Failed > 0) };
        var table = new LabTable(
            string.Create(CultureInfo.InvariantCulture, $"{scenes} scenes: does every invariant hold?"),
            ["scenes", .. StressGenerator.Integrators.Select(method => method.ToString()), "a cell", "steps a frame", "stalled", "impacts"]);
        foreach (StressKind kind in StressGenerator.Kinds)
        {
            StressCell[] row = [.. StressGenerator.Integrators.Select(method => matrix[kind, method])];
            table.Add(
                [kind.ToString(), .. row.Select(cell => cell.Verdict), row.Sum(cell => cell.Scenes) / row.Length,
                    (double)row.Sum(cell => cell.Steps) / Math.Max(1, row.Sum(cell => cell.Frames)), row.Sum(cell => cell.Stalled), row.Sum(cell => cell.Impacts)]);
        }

        report.Tables.Add(table);
        LabTable energy = new("most energy made in a frame, as a share of what the method's own error can be", ["scenes", .. StressGenerator.Integrators.Select(method => method.ToString())]);
        foreach (StressKind kind in StressGenerator.Kinds)
        {
            energy.Add([kind.ToString(), .. StressGenerator.Integrators.Select(method => (object?)matrix[kind, method].EnergyShare)]);
        }

        report.Tables.Add(energy);
        report.Tables.Add(Overshoot.Table());
        report.Picture = () => Figure.Stack("", [Overshoot.Draw()]);
        LabTable failures = new("failures", "scene", "kind", "method", "check", "detail");
        foreach (StressKind kind in StressGenerator.Kinds)
        {
            foreach (Integrator method in StressGenerator.Integrators)
            {
                foreach ((long index, StressFailure failure) in matrix[kind, method].Failures)
                {
                    failures.Add(index, kind, method, failure.Check, failure.Detail);
                }
            }
        }

        if (failures.Rows.Count > 0)
        {
            report.Tables.Add(failures);
        }

        report.Notes.Add(string.Create(CultureInfo.InvariantCulture, $"Slowest scene: {matrix.Slowest.Index}, {matrix.Slowest.Seconds:0.00} s. One scene again: football lab stability --seed {seed} --scene I"));
        return report;
    }
}
