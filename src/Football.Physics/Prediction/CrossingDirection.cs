namespace FootballPhysics.Prediction;

/// <summary>The direction in which a plane is crossed.</summary>
internal enum CrossingDirection
{
    /// <summary>Either direction.</summary>
    Any = 0,

    /// <summary>In the direction of the plane's normal.</summary>
    AlongNormal = 1,

    /// <summary>Opposite to the plane's normal.</summary>
    AgainstNormal = 2,
}
