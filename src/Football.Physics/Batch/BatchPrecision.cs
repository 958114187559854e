namespace Football.Physics;

/// <summary>With which numbers the balls of a batch are flown.</summary>
public enum BatchPrecision
{
    /// <summary>
    /// Floats with compensated sums, several balls at once in wide registers: within 1e-5 m of the single ball at the landing in 1 to 4 s flights
    /// (typically 1e-6 m), where the ball does not slide along a jump of the published drag law.
    /// </summary>
    Single = 0,

    /// <summary>The single ball itself, one by one: its bits.</summary>
    Double = 1,
}
