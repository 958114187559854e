using System.Collections.Concurrent;
using System.Diagnostics;
using FootballPhysics.Drawing;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Labs.Stability;

/// <summary>Scenes that are a function of their numbers, and the claims that hold in them.</summary>
internal abstract class SceneSet
{
    public abstract string Name { get; }

    /// <summary>The number of scenes of a run by default, and of a full run.</summary>
    public abstract long ByDefault { get; }

    public virtual long Full => 1_000_000;

    /// <summary>The number of the first scene.</summary>
    public virtual long First => 0;

    /// <summary>Simulates a scene and checks it.</summary>
    public abstract StressOutcome Play(long scene);

    /// <summary>Adds the tables of one scene.</summary>
    public abstract void Show(long scene, StressOutcome outcome, LabRun run);

    /// <summary>Adds the tables of many scenes.</summary>
    public abstract void Show(StressResults results, long count, LabRun run);

    /// <summary>Adds the table of the failures, if there are any.</summary>
    protected static void ShowFailures(StressResults results, LabRun run)
    {
        if (results.Findings.Kinds > 0)
        {
            run.Tables.Add(results.Findings.Table("failures", "finding"));
        }
    }

    /// <summary>Adds a note that names the slowest scene, and the options that run a scene again.</summary>
    protected static void ShowSlowest(StressResults results, LabRun run, string options) => run.Notes.Add(FormattableString.Invariant(
        $"Slowest scene: {results.Slowest.At}, {results.Slowest.Most:0.00} s. One scene again: football lab stability {options} --scene I"));
}

/// <summary>The stress matrix: kinds of scenes by integrators.</summary>
internal sealed class StressSet(long seed, Profile profile) : SceneSet
{
    public override string Name => "stability";

    public override long ByDefault => 60_000;

    public override long Full => 1_040_000;

    public override StressOutcome Play(long scene) => StressRun.Play(Make(scene));

    public override void Show(long scene, StressOutcome outcome, LabRun run)
    {
        run.Terminal.Person.WriteLine(Make(scene).Text());
        run.Table($"scene {scene}", "kind", "method", "frames", "steps", "impacts", "verdict")
            .Add(outcome.Kind, outcome.Method, outcome.Tally.Frames, outcome.Tally.Steps, outcome.Tally.Impacts, outcome.Verdict);
    }

    public override void Show(StressResults results, long count, LabRun run)
    {
        string[] methods = [.. StressGenerator.Integrators.Select(method => method.ToString())];
        LabTable table = run.Table(
            FormattableString.Invariant($"{count} scenes: does every invariant hold?"),
            ["scenes", .. methods, "a cell", "steps a frame", "stalled", "impacts"]);
        LabTable energy = run.Table("most energy made in a frame, as a share of what the method's own error can be", ["scenes", .. methods]);
        foreach (string kind in StressGenerator.Kinds.Select(kind => kind.ToString()))
        {
            Tally[] cells = [.. StressGenerator.Integrators.Select(method => results.Of(kind, method))];
            Tally row = results.Of(kind);
            table.Add([kind, .. cells.Select(cell => cell.Verdict), row.Scenes / cells.Length, (double)row.Steps / Math.Max(1, row.Frames), row.Stalled, row.Impacts]);
            energy.Add([kind, .. cells.Select(cell => (object?)cell.EnergyShare)]);
        }

        Overshoot.AddTable(run);
        run.Picture = () => Figure.Stack("", [Overshoot.Draw()]);
        ShowFailures(results, run);
        ShowSlowest(results, run, FormattableString.Invariant($"--seed {seed}"));
    }

    private StressScene Make(long scene)
    {
        StressScene made = StressGenerator.Make(seed, scene);
        return profile == Profile.Measured ? MeasuredStress.Of(made, seed, scene) : made;
    }
}

/// <summary>Scenes far outside football, and their findings. Scenes of seed 1 have the numbers from 1 on, those of seed 2 from 1 000 001 on.</summary>
internal sealed class HostileSet(long seed) : SceneSet
{
    public override string Name => "hostile";

    public override long ByDefault => 20_000;

    public override long First => ((seed - 1) * Full) + 1;

    public override StressOutcome Play(long scene) => StressRun.PlayHostile(HostileGenerator.Make((ulong)scene));

    public override void Show(long scene, StressOutcome outcome, LabRun run)
    {
        StressScene made = HostileGenerator.Make((ulong)scene);
        run.Terminal.Person.WriteLine(made.Text());
        if (made.HasOwnForces)
        {
            run.Terminal.Person.WriteLine($"Forces of its own: {string.Join(", ", made.Scene.Forces.CustomForces)}");
        }

        if (outcome.Refusal is null)
        {
            AddFrames(run, made);
        }

        var results = new StressResults();
        results.Add(scene, outcome);
        run.Tables.Add((outcome.Refusal is null ? results.Findings : results.Refusals).Table("findings", "finding"));
    }

    public override void Show(StressResults results, long count, LabRun run)
    {
        run.Tables.Add(results.Findings.Table(FormattableString.Invariant($"{count} hostile scenes: what was found"), "finding"));
        run.Tables.Add(results.Refusals.Table("scenes that are refused", "field"));
        Tally all = results.Total;
        run.Notes.Add(FormattableString.Invariant($"{all.Frames} frames, {all.Events} events, {all.Rests} rests, {all.StalledFrames} frames stalled."));
        ShowSlowest(results, run, "--hostile");
    }

    private static void AddFrames(LabRun run, StressScene scene)
    {
        LabTable table = run.Table("frames", "length, s", "time, s", "motion", "height, m", "velocity, m/s", "spin, rad/s", "energy, J", "pieces", "stalled", "events");
        var simulator = new Simulator(scene.Scene, scene.Settings);
        var energy = new EnergyCheck(scene, simulator);
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
    }
}

/// <summary>Simulates many scenes on all processors, and sums their outcomes.</summary>
internal sealed class StressResults
{
    /// <summary>A scene that takes longer than this, s, is reported.</summary>
    private const double Long = 10;

    private readonly Lock _lock = new();
    private readonly Dictionary<(string Kind, Integrator Method), Tally> _cells = [];

    public Findings Findings { get; } = new();

    /// <summary>Scenes that the library rejects, by field.</summary>
    public Findings Refusals { get; } = new();

    /// <summary>The longest time of a scene, s, and its number.</summary>
    public Peak<double, long> Slowest { get; } = new(0);

    public Tally Of(string kind, Integrator method) => _cells.GetValueOrDefault((kind, method));

    public Tally Of(string kind) => _cells.Where(cell => cell.Key.Kind == kind).Aggregate(default(Tally), (sum, cell) => sum + cell.Value);

    public Tally Total => _cells.Values.Aggregate(default(Tally), (sum, cell) => sum + cell);

    /// <summary>Adds a scene.</summary>
    public void Add(long scene, StressOutcome outcome, double seconds = 0)
    {
        lock (_lock)
        {
            _cells[(outcome.Kind, outcome.Method)] = Of(outcome.Kind, outcome.Method) + outcome.Tally;
            Slowest.See(seconds, scene);
            foreach (Finding found in outcome.Findings)
            {
                Findings.Add(outcome.Kind.Length > 0 ? $"{outcome.Kind}, {outcome.Method}: {found.Check}" : found.Check, scene, found);
            }

            if (outcome.Refusal is { } refusal)
            {
                Refusals.Add(refusal.Check, scene, refusal);
            }
        }
    }

    /// <summary>Simulates scenes of a set, from its first one on.</summary>
    public void Play(SceneSet set, long count, int jobs, LabRun run)
    {
        var running = new ConcurrentDictionary<long, long>();
        using var watch = new Timer(
            _ =>
            {
                foreach (long scene in running.Where(item => Stopwatch.GetElapsedTime(item.Value).TotalSeconds > Long).Select(item => item.Key))
                {
                    run.Terminal.Error.WriteLine(FormattableString.Invariant($"scene {scene} has been running for more than {Long:0} s"));
                }
            },
            null,
            TimeSpan.FromSeconds(Long),
            TimeSpan.FromSeconds(Long));
        run.Parallel(set.First, count, jobs, "scenes", scene =>
        {
            long start = running[scene] = Stopwatch.GetTimestamp();
            StressOutcome outcome = set.Play(scene);
            running.TryRemove(scene, out _);
            Add(scene, outcome, Stopwatch.GetElapsedTime(start).TotalSeconds);
        });
    }
}
