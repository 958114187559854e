using FootballPhysics.Tool.Replay;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>A shot of the gallery, and the objects drawn around it.</summary>
internal sealed record GalleryShot
{
    /// <summary>The name of the shot's files.</summary>
    public required string Id { get; init; }

    public required string Name { get; init; }

    /// <summary>The caption.</summary>
    public required string About { get; init; }

    public required Scenario Scenario { get; init; }

    /// <summary>The scene in C#, without goals and obstacles.</summary>
    public string SceneCode { get; init; } = "new Scene()";

    /// <summary>The goalkeeper who dives in the shot; null if there is none.</summary>
    public KeeperDive? Keeper { get; init; }

    /// <summary>A program that simulates the shot as drawn.</summary>
    public string Code => ShotCode.Program(Scenario, SceneCode, Keeper);

    /// <summary>The scene as fields of a scenario, path=value, without goals and obstacles; empty for the default.</summary>
    public IReadOnlyList<string> SceneFields { get; init; } = [];

    /// <summary>A command that simulates the shot as drawn; null for a shot with a goalkeeper, which a scenario file cannot describe.</summary>
    public string? Command => Keeper is null ? ShotCode.Command(Scenario, SceneFields, Id) : null;

    /// <summary>A variant of the shot that is drawn for comparison; null for none.</summary>
    public Scenario? Comparison { get; init; }

    /// <summary>The description of the comparison.</summary>
    public string ComparisonName { get; init; } = "";

    /// <summary>Lines on the ground, in addition to those of the scene's goals.</summary>
    public IReadOnlyList<SceneShape> Markings { get; init; } = [];

    /// <summary>Lines in the plane of the goal: the reach of a keeper, the scatter of kicks.</summary>
    public IReadOnlyList<SceneShape> OnGoal { get; init; } = [];

    /// <summary>The target points of the kick, marked in the drawings.</summary>
    public IReadOnlyList<Vector3d> Points { get; init; } = [];

    /// <summary>The end of the drawings along the view, in m; null to draw the complete path.</summary>
    public double? DrawnTo { get; init; }
}
