namespace FootballPhysics;

/// <summary>The part of drag and Magnus force that acts while the ball is on the ground.</summary>
public enum GroundAerodynamics
{
    /// <summary>Only the horizontal part acts, as in the code listing of the thesis.</summary>
    Horizontal = 0,

    /// <summary>Neither force acts, as in the text of the thesis. Spin decay still acts.</summary>
    None = 1,

    /// <summary>The full forces and torques of the air act.</summary>
    /// <remarks>The normal component loads or lifts the ball. On a rolling ball, the component along the ground and the torque change velocity and spin
    /// together.</remarks>
    Full = 2,
}
