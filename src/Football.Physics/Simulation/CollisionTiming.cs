namespace Football.Physics;

/// <summary>How the instant of an impact is found inside a step.</summary>
public enum CollisionTiming
{
    /// <summary>The root of the step itself: closed form or one Newton correction.</summary>
    Exact = 0,

    /// <summary>The thesis' recursive search with re-integration (2.4.4), down to <see cref="SolverSettings.CollisionTolerance"/>.</summary>
    Bisection = 1,
}
