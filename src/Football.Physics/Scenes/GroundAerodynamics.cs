namespace FootballPhysics;

/// <summary>The part of drag and Magnus force that acts while the ball is on the ground.</summary>
public enum GroundAerodynamics
{
    /// <summary>Their horizontal part acts; the vertical part is dropped (the thesis' listing).</summary>
    Horizontal = 0,

    /// <summary>They do not act at all (the thesis' text); spin decay still does.</summary>
    None = 1,

    /// <summary>
    /// All of the air's force acts: its part along the normal loads or lifts the ball, its part along the ground is shared with the spin of a ball
    /// that rolls, and so is the air's torque.
    /// </summary>
    Full = 2,
}
