namespace FootballPhysics.Labs.Derivatives;

/// <summary>The kinds of flights whose derivatives are compared.</summary>
internal enum DerivativesKind
{
    /// <summary>Air and level ground; the published profile.</summary>
    Published,

    /// <summary>Air and level ground; the measured profile.</summary>
    Measured,

    /// <summary>A goal with posts, bar and nets; the measured profile.</summary>
    Goal,

    /// <summary>A slope with standing and moving objects; the published profile.</summary>
    Slope,

    /// <summary>Hills; the measured profile.</summary>
    Hills,
}
