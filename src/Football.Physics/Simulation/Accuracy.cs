namespace FootballPhysics;

/// <summary>The accuracy of a flight from the kick to the impact, relative to the exact solution of its laws.</summary>
/// <remarks>
/// The settings that <see cref="SolverSettings.For"/> and <c>BatchSettings.For</c> choose meet this accuracy for footballers' shots. These are shots of a
/// football at up to 40 m/s and 80 rad/s, in any wind, with any of the published laws. Balls with a quarter of the mass, which curve more, and custom forces
/// are not covered.
/// </remarks>
public enum Accuracy
{
    /// <summary>1 mm.</summary>
    Millimeter = 0,

    /// <summary>0.1 mm.</summary>
    TenthOfMillimeter = 1,

    /// <summary>1 µm.</summary>
    Micrometer = 2,
}
