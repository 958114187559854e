namespace FootballPhysics.Tool.Replay;

/// <summary>An object of a scene for drawings, at time 0: lines, which may be thick, and flat faces.</summary>
/// <param name="Name">The name.</param>
/// <param name="Kind">The kind, which determines the colour.</param>
internal sealed record SceneShape(string Name, SceneShapeKind Kind)
{
    /// <summary>Polylines. A single point with a radius is a ball; two points with a radius are a capsule.</summary>
    public IReadOnlyList<Vector3d[]> Lines { get; init; } = [];

    /// <summary>The radius of the lines, in m; 0 for thin lines.</summary>
    public double Radius { get; init; }

    /// <summary>The convex polygons, counter-clockwise seen from outside.</summary>
    public IReadOnlyList<Vector3d[]> Faces { get; init; } = [];

    /// <summary>The four corners of a net, between which pages draw the meshes; null for other shapes.</summary>
    public IReadOnlyList<Vector3d>? Corners { get; init; }

    /// <summary>The people to draw instead of the shape, each with feet, shoulders, hands and facing direction; null for none.</summary>
    public IReadOnlyList<Vector3d[]>? People { get; init; }

    /// <summary>The velocity, in m/s.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>All points of the shape.</summary>
    public IEnumerable<Vector3d> Points => Lines.Concat(Faces).SelectMany(points => points);
}
