namespace FootballPhysics;

/// <summary>Which measurements the empirical laws of drag, Magnus force and spin decay follow, and in which form.</summary>
public enum AerodynamicModel
{
    /// <summary>The thesis' fits as published: drag jumps at the critical speed and at spin parameter 0.05; the jump is located inside the step.</summary>
    Published = 0,

    /// <summary>The published coefficients with their two jumps smoothed; landing points move by about 1 cm.</summary>
    Regularized = 1,

    /// <summary>
    /// What wind tunnels and filmed flights say: drag by Reynolds number (<see cref="BallProperties.DragCurve"/>) and spin across the motion, lift that
    /// saturates, spin decay by speed times spin.
    /// </summary>
    Measured = 2,
}
