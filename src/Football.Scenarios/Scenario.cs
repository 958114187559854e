using System.Globalization;
using FootballPhysics.Scenarios.Input;

namespace FootballPhysics.Scenarios;

/// <summary>One shot: scene, launch, integration and stop condition.</summary>
public sealed record Scenario
{
    /// <summary>The default step, in s.</summary>
    public const double DefaultTimeStep = 0.01;

    /// <summary>The default end of a run, in s.</summary>
    public const double DefaultDuration = 20;

    /// <summary>The maximum number of steps of which a run keeps samples; it limits the memory.</summary>
    private const double MostSamples = 1e6;

    /// <summary>The maximum number of steps of all balls. Files can come from other people; the limit keeps runs from taking days.</summary>
    private const double MostSteps = 1e9;

    public Scene Scene { get; init; } = Scene.Default;

    public SolverSettings Settings { get; init; } = SolverSettings.Default;

    public double TimeStep { get; init; } = DefaultTimeStep;

    /// <summary>
    /// The launches of several balls; empty for a single ball. With several balls, the scenario's own position, velocity and spin are not used.
    /// </summary>
    public IReadOnlyList<BallLaunch> Balls { get; init; } = [];

    /// <summary>The material of contacts between balls.</summary>
    public SurfaceMaterial BallContact { get; init; } = SurfaceMaterial.Ball;

    public required Vector3d Position { get; init; }

    public required Vector3d Velocity { get; init; }

    public Vector3d Spin { get; init; }

    /// <summary>The orientation at the launch; null for that of a launch without one.</summary>
    public Quaterniond? Orientation { get; init; }

    public StopAt StopAt { get; init; } = StopAt.Impact;

    public double Duration { get; init; } = DefaultDuration;

    /// <summary>Called with the ball before every step, to move bodies of the scene; null for no call. It must reset itself if the time goes back.</summary>
    public Action<BallState>? BeforeStep { get; init; }

    /// <summary>True to keep the path.</summary>
    public bool Samples { get; init; }

    /// <summary>True to compute the derivatives of the final state with respect to the launch.</summary>
    public bool Derivatives { get; init; }

    /// <summary>True if the number of steps is small enough to keep the path.</summary>
    public bool CanKeepPath => Math.Max(1, Balls.Count) * (Duration / TimeStep) <= MostSamples;

    /// <summary>Reads a scenario. The library checks the numbers during the simulation.</summary>
    /// <exception cref="RefusedException">A field is unknown, missing or of the wrong type.</exception>
    public static Scenario Read(InputFields fields)
    {
        Scenario scenario = Take(fields.Root);
        fields.Check();
        if (scenario.Samples && !scenario.CanKeepPath)
        {
            throw new RefusedException(FormattableString.Invariant(
                $"samples is true with {Math.Max(1, scenario.Balls.Count) * (scenario.Duration / scenario.TimeStep):0} steps (stop.time / solver.timeStep × balls); allowed: at most {MostSamples:0} steps with samples."));
        }

        CheckSteps(scenario.Duration, scenario.TimeStep, scenario.Balls.Count);
        return scenario;
    }

    /// <summary>Rejects a run with too many steps.</summary>
    /// <param name="duration">The maximum time to simulate, in s.</param>
    /// <param name="timeStep">The length of a step, in s.</param>
    /// <param name="balls">The number of balls.</param>
    /// <exception cref="RefusedException">There are too many steps.</exception>
    public static void CheckSteps(double duration, double timeStep, int balls = 1)
    {
        // The library rejects even more steps, and names the field that is out of range.
        double steps = Math.Max(1, balls) * (duration / timeStep);
        if (steps is > MostSteps and <= 1e12)
        {
            throw new RefusedException(
                "stop.time / solver.timeStep × balls", string.Create(CultureInfo.InvariantCulture, $"{steps:0} steps"), string.Create(CultureInfo.InvariantCulture, $"at most {MostSteps:0} steps"));
        }
    }

    /// <summary>Reads the members of a scenario from an input that may have others. Call <see cref="InputFields.Check"/> afterwards.</summary>
    public static Scenario Take(InputObject root)
    {
        Scene scene = SceneInput.Scene(root) with { Bodies = WorldInput.Bodies(root) };
        bool several = root.Has("balls");
        IReadOnlyList<BallLaunch> balls = several ? BallLaunch.All(root, scene.Ball) : [];
        InputObject launch = root.Object("launch");
        SolverSettings settings = SceneInput.Solver(root, out double timeStep);
        if (several)
        {
            root.Demand("derivatives", !root.Flag("derivatives", false), "false where there are several balls");
        }

        (StopAt stopAt, double duration, bool samples) = SceneInput.Stop(root);
        return new Scenario
        {
            Scene = scene,
            Settings = settings,
            TimeStep = timeStep,
            Balls = balls,
            BallContact = WorldInput.Material(root.Object("ballContact"), SurfaceMaterial.Ball),
            Position = several ? Vector3d.Zero : launch.Vector("position"),
            Velocity = several ? Vector3d.Zero : launch.Vector("velocity"),
            Spin = several ? Vector3d.Zero : launch.Vector("spin", Vector3d.Zero),
            Orientation = several ? null : OrientationOf(launch),
            StopAt = stopAt,
            Duration = duration,
            Samples = samples,
            Derivatives = root.Flag("derivatives", false),
        };
    }

    /// <summary>Returns the orientation of the ball at its launch; null if it is missing.</summary>
    public static Quaterniond? OrientationOf(InputObject launch)
    {
        double[] parts = launch.Numbers("orientation", "[x, y, z, w]", [0, 0, 0, 1]);
        if (!launch.Has("orientation"))
        {
            return null;
        }

        // Scale first: the square of a very large or very small number would be infinite or zero.
        double largest = parts.Max(Math.Abs);
        double scale = largest > 0 ? largest : 1;
        return new Quaterniond(parts[0] / scale, parts[1] / scale, parts[2] / scale, parts[3] / scale);
    }
}
