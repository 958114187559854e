namespace Football.Physics;

/// <summary>How the end of a slide is found.</summary>
public enum RollingTransition
{
    /// <summary>Where the slip reaches zero, inside the step.</summary>
    Exact = 0,

    /// <summary>The thesis' heuristic (2.27, 2.28): at the end of the step in which the slip grew, or fell below 1 mm/s.</summary>
    Heuristic = 1,
}
