using System.Text.Json;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;
using FootballPhysics.Tests.Support;

namespace FootballPhysics.Tests.Reference;

/// <summary>A reference case of any scene, played by the library, and how far it is off: the worst over every event and the end.</summary>
internal sealed class WholeRun
{
    /// <summary>Balls that go in off the post and the bar: the solver of these cases did not watch the goal.</summary>
    private static readonly HashSet<string> s_goalsUnseen = ["among-post-001", "among-post-005"];

    /// <summary>What the events should have been and were; null where they are the same.</summary>
    private string? _wrongEvents;

    private WholeRun(string name) => Name = name;

    public string Name { get; }

    /// <summary>s.</summary>
    public double Time { get; private set; }

    /// <summary>Of place, velocity and spin: relative to max(1, |expected|).</summary>
    public double Position { get; private set; }

    public double Velocity { get; private set; }

    public double Spin { get; private set; }

    /// <summary>Half an angle, rad; 0 where the case says none.</summary>
    public double Orientation { get; private set; }

    /// <summary>Of the outputs of impacts, relative; infinite if grip and slip are confused.</summary>
    public double Output { get; private set; }

    /// <summary>How far the end moves by roundings of the launch, as the reference found.</summary>
    public double Sensitivity { get; private set; }

    /// <summary>What the case may be off: a micrometre, or ten thousand roundings of its launch.</summary>
    public double Bound => Math.Max(1e-6, 1e4 * Sensitivity);

    /// <summary>Plays all cases of a file: events are as they must be, times and places within so many bounds, the rest within some times that.</summary>
    public static void HoldAll(string file, Integrator integrator, double timeStep, double bounds)
    {
        string[] wrong = [.. ReferenceCase.Lines(file).Select(line => Play(line, integrator, timeStep)).Where(run => !run.Holds(bounds)).Select(run => run.ToString())];
        Assert.True(wrong.Length == 0, string.Join('\n', wrong));
    }

    private static WholeRun Play(JsonElement line, Integrator integrator, double timeStep)
    {
        var run = new WholeRun(line.GetProperty("name").GetString()!);
        JsonElement expected = line.GetProperty("expected");
        run.Sensitivity = ReferenceCase.Number(expected, "sensitivity");
        Outcome outcome = ScenarioRun.Play(Scenario.Read(new InputFields(line.GetProperty("scenario"))) with
        {
            Settings = new SolverSettings { Integrator = integrator },
            TimeStep = timeStep,
        });
        JsonElement[] events = [.. expected.GetProperty("events").EnumerateArray()];
        string wanted = string.Join(' ', events.Select(item => item.GetProperty("kind").GetString() + "@" + SurfaceOf(item)));
        BallEvent[] happenings = [.. outcome.Events.Where(item => item.Kind != BallEventKind.Goal || !s_goalsUnseen.Contains(run.Name))];
        string got = string.Join(' ', happenings.Select((item, i) =>
            Words.Of(item.Kind).ToLowerInvariant() + "@" + (i < events.Length && SurfaceOf(events[i]) is null ? null : item.ColliderIndex < 0 ? null : outcome.NameOf(item.ColliderIndex))));
        if (wanted != got)
        {
            run._wrongEvents = $"{run.Name}: expected {wanted}, got {got}";
            return run;
        }

        foreach ((JsonElement item, BallEvent happened) in events.Zip(happenings))
        {
            run.Compare(item, happened.Time, happened.Position, happened.Velocity, happened.Spin);
            if (item.TryGetProperty("peakForce", out _))
            {
                run.CompareOutputs(item, outcome.ImpactOf(happened));
            }
        }

        Moment end = outcome.Final;
        if (end.State == MotionState.Rest)
        {
            // A ball at rest stays there: how fast it was before, and when, its last event says.
            run.Position = Math.Max(run.Position, Differences.Relative(end.Position, ReferenceCase.Vector(expected.GetProperty("position"))));
        }
        else
        {
            run.Compare(expected, end.Time, end.Position, end.Velocity, end.Spin);
        }

        if (expected.TryGetProperty("orientation", out JsonElement orientation))
        {
            run.Orientation = Differences.Rotation(end.Orientation, ReferenceCase.Rotation(orientation));
        }

        return run;
    }

    private void Compare(JsonElement expected, double time, in Vector3d position, in Vector3d velocity, in Vector3d spin)
    {
        Time = Math.Max(Time, Math.Abs(time - ReferenceCase.Number(expected, "time")));
        Position = Math.Max(Position, Differences.Relative(in position, ReferenceCase.Vector(expected.GetProperty("position"))));
        Velocity = Math.Max(Velocity, Differences.Relative(in velocity, ReferenceCase.Vector(expected.GetProperty("velocity"))));
        Spin = Math.Max(Spin, Differences.Relative(in spin, ReferenceCase.Vector(expected.GetProperty("spin"))));
    }

    private void CompareOutputs(JsonElement expected, in Impact impact)
    {
        (string Name, double Value)[] outputs =
        [
            ("normalImpulse", impact.NormalImpulse), ("tangentialImpulse", impact.TangentialImpulse), ("slipBefore", impact.SlipBefore), ("slipAfter", impact.SlipAfter),
            ("contactTime", impact.ContactTime), ("compression", impact.Compression), ("peakForce", impact.PeakForce), ("energyLost", impact.EnergyLost),
        ];
        foreach ((string name, double value) in outputs)
        {
            double right = ReferenceCase.Number(expected, name);
            Output = Math.Max(Output, Math.Abs(value - right) / Math.Max(Math.Abs(right), 1e-3));
        }

        Output = impact.Grips == expected.GetProperty("grips").GetBoolean() ? Output : double.PositiveInfinity;
    }

    private static string? SurfaceOf(JsonElement item) => item.TryGetProperty("surface", out JsonElement surface) ? surface.GetString() : null;

    /// <summary>
    /// Within so many bounds. What comes of a place is a rate of some units a second and more: velocity and spin may be off four times that, and a ball
    /// that has turned some hundred radians by twenty-five times.
    /// </summary>
    private bool Holds(double bounds)
    {
        double most = bounds * Bound;
        return _wrongEvents is null && Time <= most && Position <= most && Velocity <= 4 * most && Spin <= 4 * most && Output <= 4 * most && Orientation <= 25 * most;
    }

    public override string ToString() => _wrongEvents ?? FormattableString.Invariant(
        $"{Name}: {Time:e1} s, {Position:e1} m, {Velocity:e1} m/s, {Spin:e1} rad/s, {Orientation:e1} rad, outputs {Output:e1}; bound {Bound:e1}");
}
