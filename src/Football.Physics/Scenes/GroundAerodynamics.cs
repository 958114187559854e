namespace Football.Physics;

/// <summary>What is left of drag and Magnus force while the ball is on the ground.</summary>
public enum GroundAerodynamics
{
    /// <summary>Their horizontal part acts; the vertical part is dropped (the thesis' listing).</summary>
    Horizontal = 0,

    /// <summary>They do not act at all (the thesis' text); spin decay still does.</summary>
    None = 1,
}
