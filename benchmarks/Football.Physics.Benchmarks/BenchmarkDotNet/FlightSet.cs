namespace FootballPhysics.Benchmarks;

/// <summary>A set of shots in flight.</summary>
public enum FlightSet
{
    /// <summary>24 m/s, 20 to 30 rad/s.</summary>
    Fast = 0,

    /// <summary>12 to 27 m/s, 0 to 25 rad/s.</summary>
    Mixed = 1,
}
