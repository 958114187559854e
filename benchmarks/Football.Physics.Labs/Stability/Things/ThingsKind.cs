namespace FootballPhysics.Labs.Stability.Things;

/// <summary>The kinds of scenes with objects.</summary>
internal enum ThingsKind
{
    /// <summary>Standing spheres, capsules, boxes and walls.</summary>
    Obstacles,

    /// <summary>As above, some of them in steady motion.</summary>
    Moving,

    /// <summary>As above, some of them moved by the game, before every frame and to any position.</summary>
    Bodies,

    /// <summary>Goals and free nets.</summary>
    Nets,

    /// <summary>Objects on a tilted pitch.</summary>
    Slopes,

    /// <summary>Objects on uneven ground.</summary>
    Hills,
}
