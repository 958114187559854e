using FootballPhysics.Tool.Aim;
using FootballPhysics.Tool.Cameras;
using FootballPhysics.Scenarios.Input;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Sweep;

/// <summary>The common values of the rows: the scene, the fixed values of the launch or aim, the integration and the stop condition.</summary>
internal sealed record SweepScene
{
    /// <summary>The members of an input that do not belong to a scenario.</summary>
    private static readonly string[] s_ownMembers = ["ranges", "row"];

    private static readonly string[] s_kick = [.. DirectField.OfLaunch.Take(DirectField.KickNumbers).Select(field => field.Column)];

    public required Scene Scene { get; init; }

    public required SolverSettings Solver { get; init; }

    public required double TimeStep { get; init; }

    public BatchPrecision Precision { get; init; }

    public SweepStop StopAt { get; init; }

    /// <summary>The plane at which a flight ends; null for none.</summary>
    public Plane3d? Plane { get; init; }

    public double Duration { get; init; }

    /// <summary>The values of <see cref="DirectField.OfLaunch"/> or <see cref="DirectField.OfAim"/>.</summary>
    public required double[] Numbers { get; init; }

    /// <summary>True if a launch is given by velocity and spin; false if by speed and angles.</summary>
    public bool HasVectors { get; init; }

    /// <summary>The orientation at the launch; null if not given.</summary>
    public Quaterniond? Orientation { get; init; }

    /// <summary>The cameras that observe the samples.</summary>
    public IReadOnlyList<CameraView> Cameras { get; init; } = [];

    /// <summary>Keeper, spread and kicks of the chance of a goal; null if not requested. The kick is that of a row.</summary>
    public GoalChanceRequest? Chance { get; init; }

    /// <summary>The aim; null if the sweep simulates launches.</summary>
    public AimScenario? Aim { get; init; }

    public BatchSettings BatchSettings => new() { Integrator = Solver.Integrator, TimeStep = TimeStep, Precision = Precision, FindApex = true };

    /// <summary>Reads the common values. Call <see cref="InputFields.Check"/> afterwards.</summary>
    public static SweepScene Take(InputObject root)
    {
        foreach (string member in s_ownMembers)
        {
            root.Has(member);
        }

        return root.Has("aim") ? TakeAim(root) : TakeLaunch(root);
    }

    private static SweepScene TakeAim(InputObject root)
    {
        root.Exclude("launch", "aim");
        AimScenario aim = AimScenario.Take(root);
        AimRequest request = aim.Request;
        return new SweepScene
        {
            Scene = aim.Scene,
            Solver = aim.Settings,
            TimeStep = aim.TimeStep,
            Aim = aim,
            Numbers =
            [
                request.Speed, request.TopSpin, request.SideSpin,
                request.From.X, request.From.Y, request.From.Z, request.Target.X, request.Target.Y, request.Target.Z,
            ],
        };
    }

    private static SweepScene TakeLaunch(InputObject root)
    {
        Scene scene = SceneInput.Scene(root);
        InputObject launch = root.Object("launch");
        InputObject solver = root.Object("solver");
        InputObject stop = root.Object("stop");
        SolverSettings settings = SceneInput.Solver(root, out double timeStep);
        SweepStop at = stop.Choice("at", SweepStop.Impact);
        Vector3d position = launch.Vector("position", Vector3d.Zero);
        double[] kick = [.. DirectField.OfLaunch.Take(DirectField.KickNumbers).Select(field => launch.Within(field.Column, field.Range?.Low ?? 0, field.Allowed))];
        bool hasVectors = launch.Has("velocity") || launch.Has("spin");
        Vector3d velocity = hasVectors ? launch.Vector("velocity") : Vector3d.Zero;
        Vector3d spin = launch.Vector("spin", Vector3d.Zero);
        foreach (string name in s_kick)
        {
            launch.Exclude(name, "velocity");
            launch.Exclude(name, "spin");
        }

        double step = solver.Has("timeStep") ? timeStep : BatchSettings.Default.TimeStep;
        double duration = stop.Positive("time", Scenario.DefaultDuration);
        Scenario.CheckSteps(duration, step);
        Plane3d? plane = at == SweepStop.Plane || stop.Has("plane") ? PlaneOf(stop.Object("plane")) : null;
        return new SweepScene
        {
            Scene = scene,
            Solver = settings with { Integrator = solver.Choice("integrator", BatchSettings.Default.Integrator) },
            TimeStep = step,
            Precision = solver.Choice("precision", BatchSettings.Default.Precision),
            StopAt = at,
            Plane = at == SweepStop.Plane ? plane : null,
            Duration = duration,
            Numbers = [.. kick, position.X, position.Y, position.Z, velocity.X, velocity.Y, velocity.Z, spin.X, spin.Y, spin.Z],
            HasVectors = hasVectors,
            Cameras = CameraView.Take(root),
            Chance = root.Has("chance") ? GoalChanceInput.Request(root.Object("chance"), scene.Goals, position, velocity, spin, Scenario.OrientationOf(launch)) with { AlwaysSimulate = true } : null,
            Orientation = Scenario.OrientationOf(launch),
        };
    }

    private static Plane3d? PlaneOf(InputObject plane)
    {
        Vector3d point = plane.Vector("point");
        Vector3d normal = plane.Vector("normal");
        return plane.Make(() => new PlaneBox(new Plane3d(point, normal)))?.Plane;
    }

    /// <summary>A plane as a reference type.</summary>
    private sealed record PlaneBox(Plane3d Plane);
}
