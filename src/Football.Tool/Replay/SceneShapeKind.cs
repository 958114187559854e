namespace FootballPhysics.Tool.Replay;

/// <summary>What a shape of a picture is, which decides its colour.</summary>
internal enum SceneShapeKind
{
    /// <summary>Posts and bar.</summary>
    Frame,
    Net,
    Obstacle,

    /// <summary>A line on the ground.</summary>
    Marking,

    /// <summary>A line in the air, which is no thing: how far a keeper reaches, where kicks go.</summary>
    Guide,
}
