namespace FootballPhysics.Tool.Replay;

/// <summary>The icosahedron from which the panels of a drawn ball are cut.</summary>
internal static class Icosahedron
{
    /// <summary>The ratio of the golden section.</summary>
    private static readonly double s_golden = (1 + Math.Sqrt(5)) / 2;

    /// <summary>The twelve corners. Edges have the length 2.</summary>
    public static Vector3d[] Corners { get; } =
        [.. new[] { -1.0, 1.0 }.SelectMany(a => new[] { -s_golden, s_golden }.SelectMany(b => new[] { new Vector3d(0, a, b), new Vector3d(a, b, 0), new Vector3d(b, 0, a) }))];
}
