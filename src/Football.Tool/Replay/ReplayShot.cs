namespace FootballPhysics.Tool.Replay;

/// <summary>A ball of an animated picture.</summary>
/// <param name="Name">The name.</param>
/// <param name="Kick">A brief description of the kick.</param>
/// <param name="Track">The path.</param>
internal sealed record ReplayShot(string Name, string Kick, Track Track)
{
    /// <summary>True if the shot is for comparison only; it is then drawn dashed.</summary>
    public bool Compares { get; init; }

    /// <summary>The movements of the picture's nets by this shot.</summary>
    public IReadOnlyList<NetMove> Nets { get; init; } = [];
}
