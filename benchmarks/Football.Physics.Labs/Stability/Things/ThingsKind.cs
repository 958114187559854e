namespace FootballPhysics.Labs.Stability.Things;

/// <summary>The kinds of scenes with things in them.</summary>
internal enum ThingsKind
{
    /// <summary>Spheres, capsules, boxes and walls that stand still.</summary>
    Obstacles,

    /// <summary>Some of them move steadily.</summary>
    Moving,

    /// <summary>Some of them the game moves, before every frame and wherever it likes.</summary>
    Bodies,

    /// <summary>Goals and free nets.</summary>
    Nets,

    /// <summary>On a tilted pitch.</summary>
    Slopes,

    /// <summary>On uneven ground.</summary>
    Hills,
}
