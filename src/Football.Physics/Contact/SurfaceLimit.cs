namespace Football.Physics;

/// <summary>What may end a piece of a slide or a roll: a number that falls to zero there.</summary>
internal enum SurfaceLimit
{
    /// <summary>The load: the ball leaves the surface.</summary>
    Load,

    /// <summary>What friction could still hold: a rolling ball begins to slip.</summary>
    Grip,

    /// <summary>The energy above that of rest.</summary>
    Rest,

    /// <summary>The spin about the normal, which drilling friction ends and never reverses.</summary>
    Spin,
}
