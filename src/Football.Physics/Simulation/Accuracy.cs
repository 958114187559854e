namespace FootballPhysics;

/// <summary>How close to the exact solution of its laws a flight is to be, from the kick to the impact.</summary>
/// <remarks>
/// What <see cref="SolverSettings.For"/>, and <c>BatchSettings.For</c>, pick for it holds for footballers' shots: up to 40 m/s and 80 rad/s with
/// a football, in any wind and with any of the published laws. A ball of a quarter of the mass bends more, and a game's own force may be anything.
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
