using FootballPhysics.Tool.Replay;
using FootballPhysics.Scenarios;

namespace FootballPhysics.Tool.Gallery;

/// <summary>A shot of the gallery, and the objects drawn around it.</summary>
internal sealed record GalleryShot
{
    /// <summary>Name of its file.</summary>
    public required string Id { get; init; }

    public required string Name { get; init; }

    /// <summary>The caption.</summary>
    public required string About { get; init; }

    public required Scenario Scenario { get; init; }

    /// <summary>The scene in C#, without goals and obstacles.</summary>
    public string SceneCode { get; init; } = "new Scene()";

    /// <summary>The goalkeeper who dives in it; null if there is none.</summary>
    public KeeperDive? Keeper { get; init; }

    /// <summary>A program that plays the shot as it is drawn.</summary>
    public string Code => ShotCode.Program(Scenario, SceneCode, Keeper);

    /// <summary>The scene as fields of a scenario, path=value, without goals and obstacles; empty for the default.</summary>
    public IReadOnlyList<string> SceneFields { get; init; } = [];

    /// <summary>A command that plays the shot as it is drawn; null with a goalkeeper, whom a scenario file cannot describe.</summary>
    public string? Command => Keeper is null ? ShotCode.Command(Scenario, SceneFields, Id) : null;

    /// <summary>The same with something changed, drawn beside it; null for none.</summary>
    public Scenario? Comparison { get; init; }

    /// <summary>The description of the comparison.</summary>
    public string ComparisonName { get; init; } = "";

    /// <summary>Lines on the ground, beside those of the scene's goals.</summary>
    public IReadOnlyList<SceneShape> Markings { get; init; } = [];

    /// <summary>Lines in the plane of the goal: what a keeper covers, where kicks go.</summary>
    public IReadOnlyList<SceneShape> OnGoal { get; init; } = [];

    /// <summary>Points that the ball was aimed at, marked in the drawings.</summary>
    public IReadOnlyList<Vector3d> Points { get; init; } = [];

    /// <summary>Where the drawings end, along the view, m; null draws all of the way.</summary>
    public double? DrawnTo { get; init; }
}
