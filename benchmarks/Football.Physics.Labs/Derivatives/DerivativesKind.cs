namespace FootballPhysics.Labs.Derivatives;

/// <summary>What the flights go through whose derivatives are compared.</summary>
internal enum DerivativesKind
{
    /// <summary>Air and level ground of the published profile.</summary>
    Published,

    /// <summary>Air and level ground of the measured profile.</summary>
    Measured,

    /// <summary>A goal with posts, bar and nets; the measured profile.</summary>
    Goal,

    /// <summary>A slope and things that stand and move on it; the published profile.</summary>
    Slope,

    /// <summary>Hills; the measured profile.</summary>
    Hills,
}
