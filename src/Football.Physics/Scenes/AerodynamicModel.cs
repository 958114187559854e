namespace FootballPhysics;

/// <summary>The set of measurements and formulas behind the empirical laws of drag, Magnus force and spin decay.</summary>
public enum AerodynamicModel
{
    /// <summary>The fits of the thesis as published, with jumps in the drag.</summary>
    /// <remarks>Drag jumps at the critical speed and at spin parameter 0.05. The integrator locates each jump within the step.</remarks>
    Published = 0,

    /// <summary>The published coefficients with their two jumps smoothed; landing points move by about 1 cm.</summary>
    Regularized = 1,

    /// <summary>Laws fitted to wind-tunnel measurements and filmed flights.</summary>
    /// <remarks>
    /// Drag depends on the Reynolds number (<see cref="BallProperties.DragCurve"/>) and the spin perpendicular to the motion. Lift saturates.
    /// Spin decays in proportion to speed times spin.
    /// </remarks>
    Measured = 2,
}
