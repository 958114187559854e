namespace FootballPhysics.Tool.Replay;

/// <summary>A thing of a scene as pictures draw it: lines, which may be thick, and flat faces; where it is at time 0.</summary>
/// <param name="Name">What it is.</param>
/// <param name="Kind">What it is made of.</param>
internal sealed record SceneShape(string Name, SceneShapeKind Kind)
{
    /// <summary>Joined points; a single point with a radius is a ball, two are a rod with round ends.</summary>
    public IReadOnlyList<Vector3d[]> Lines { get; init; } = [];

    /// <summary>Radius of the lines, m; 0 draws them thin.</summary>
    public double Radius { get; init; }

    /// <summary>Convex polygons, counter-clockwise seen from outside.</summary>
    public IReadOnlyList<Vector3d[]> Faces { get; init; } = [];

    /// <summary>The four corners of a net, between which pages make its meshes; null for what is no net.</summary>
    public IReadOnlyList<Vector3d>? Corners { get; init; }

    /// <summary>Who it is: feet, shoulders, hands and the direction faced of each, which pictures draw in its place; null where it is nobody.</summary>
    public IReadOnlyList<Vector3d[]>? People { get; init; }

    /// <summary>Its velocity, m/s.</summary>
    public Vector3d Velocity { get; init; }

    /// <summary>All its points.</summary>
    public IEnumerable<Vector3d> Points => Lines.Concat(Faces).SelectMany(points => points);
}
