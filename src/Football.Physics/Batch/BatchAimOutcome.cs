namespace Football.Physics;

/// <summary>What an iteration made of a kick.</summary>
internal enum BatchAimOutcome
{
    /// <summary>It misses, and has been corrected.</summary>
    Corrected = 0,

    /// <summary>It hits.</summary>
    Hits = 1,

    /// <summary>It does not converge.</summary>
    Fails = 2,
}
