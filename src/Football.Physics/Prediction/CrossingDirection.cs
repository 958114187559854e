namespace FootballPhysics.Prediction;

/// <summary>Which way a plane is crossed.</summary>
public enum CrossingDirection
{
    /// <summary>Either way.</summary>
    Any = 0,

    /// <summary>The way that its normal points.</summary>
    AlongNormal = 1,

    /// <summary>The other way.</summary>
    AgainstNormal = 2,
}
