namespace FootballPhysics.Tool.Replay;

/// <summary>The kind of a shape, which determines its colour.</summary>
internal enum SceneShapeKind
{
    /// <summary>A post or a crossbar.</summary>
    Frame,
    Net,
    Obstacle,

    /// <summary>A line on the ground.</summary>
    Marking,

    /// <summary>A line in the air that is not an object: the reach of a keeper, the scatter of kicks.</summary>
    Guide,
}
