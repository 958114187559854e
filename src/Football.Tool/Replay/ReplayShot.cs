namespace FootballPhysics.Tool.Replay;

/// <summary>A ball of a moving picture.</summary>
/// <param name="Name">What it is called.</param>
/// <param name="Kick">The kick in a few words.</param>
/// <param name="Track">Its way.</param>
internal sealed record ReplayShot(string Name, string Kick, Track Track)
{
    /// <summary>Whether it is only there to compare with; then it is drawn dashed.</summary>
    public bool Compares { get; init; }

    /// <summary>How it moves the nets of the picture.</summary>
    public IReadOnlyList<NetMove> Nets { get; init; } = [];
}
