using Football.Physics.Headless.Json;
using Football.Physics.Headless.Schema;

namespace Football.Physics.Headless.Simulate;

/// <summary>One shot, checked: scene, launch, how to integrate it and when to stop.</summary>
internal sealed record Scenario
{
    /// <summary>Steps that a run may have: with more, the time would no longer advance. The library's own limit.</summary>
    private const double MostSteps = 1e12;

    /// <summary>Steps that a run may keep samples of; more would fill the memory.</summary>
    private const double MostSamples = 1e6;

    /// <summary>All fields of a scenario.</summary>
    public static FieldSet Fields { get; } = new(SceneFields.All, LaunchFields.All, SolverFields.All, StopFields.All);

    public Scene Scene { get; init; } = Scene.Default;

    public SolverSettings Settings { get; init; } = SolverSettings.Default;

    public double TimeStep { get; init; } = SolverFields.TimeStep.Default;

    public required Vector3d Position { get; init; }

    public required Vector3d Velocity { get; init; }

    public Vector3d Spin { get; init; }

    public Quaterniond Orientation { get; init; } = Quaterniond.Identity;

    public StopAt StopAt { get; init; } = StopFields.At.Default;

    public double Duration { get; init; } = StopFields.Time.Default;

    /// <summary>Whether to keep the path.</summary>
    public bool Samples { get; init; }

    /// <summary>Reads and checks a scenario.</summary>
    /// <exception cref="RefusedException">A field is not as it should be.</exception>
    public static Scenario Read(JsonValue root)
    {
        FieldValues values = Fields.Read(root);
        var scenario = new Scenario
        {
            Scene = SceneFields.Build(values),
            Settings = SolverFields.Build(values),
            TimeStep = values.Get(SolverFields.TimeStep),
            Position = values.Get(LaunchFields.Position),
            Velocity = values.Get(LaunchFields.Velocity),
            Spin = values.Get(LaunchFields.Spin),
            Orientation = values.Get(LaunchFields.Orientation),
            StopAt = values.Get(StopFields.At),
            Duration = values.Get(StopFields.Time),
            Samples = values.Get(StopFields.Samples),
        };
        double steps = scenario.Duration / scenario.TimeStep;
        if (!(steps <= MostSteps))
        {
            throw new RefusedException(
                SolverFields.TimeStep.Path,
                FormattableString.Invariant($"{scenario.TimeStep} with stop.time {scenario.Duration}"),
                FormattableString.Invariant($"above 0 s, and at least {1 / MostSteps} of stop.time"));
        }

        if (scenario.Samples && !(steps <= MostSamples))
        {
            throw new RefusedException(FormattableString.Invariant(
                $"samples is true with {steps:0} steps (stop.time / solver.timeStep); allowed: samples of at most {MostSamples:0} steps."));
        }

        return scenario;
    }
}
