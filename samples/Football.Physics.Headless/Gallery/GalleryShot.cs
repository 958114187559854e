using Football.Physics.Headless.Simulate;

namespace Football.Physics.Headless.Gallery;

/// <summary>A shot of the gallery, and what to draw around it.</summary>
internal sealed record GalleryShot
{
    /// <summary>Name of its file.</summary>
    public required string Id { get; init; }

    public required string Name { get; init; }

    /// <summary>What is to be seen.</summary>
    public required string About { get; init; }

    public required Scenario Scenario { get; init; }

    /// <summary>The same with something changed, drawn beside it; null for none.</summary>
    public Scenario? Comparison { get; init; }

    /// <summary>What was changed.</summary>
    public string ComparisonName { get; init; } = "";

    public IReadOnlyList<Landmark> Landmarks { get; init; } = [];

    /// <summary>Points that the ball was aimed at, marked in the drawings.</summary>
    public IReadOnlyList<Vector3d> Points { get; init; } = [];

    /// <summary>Where the drawings end, along the view, m; null draws all of the way.</summary>
    public double? DrawnTo { get; init; }

    /// <summary>Along the view to a vertical plane where the ball is looked at, m; null for none.</summary>
    public double? GoalLine { get; init; }
}
