namespace FootballPhysics;

/// <summary>The motion of the ball, which selects the forces that act.</summary>
public enum MotionState
{
    /// <summary>The ball is in the air, including between bounces.</summary>
    Airborne = 0,

    /// <summary>The ball is on the ground, and its contact point slips.</summary>
    Sliding = 1,

    /// <summary>The ball is on the ground and rolls without slip.</summary>
    Rolling = 2,

    /// <summary>The ball is at rest until the next kick. A step then costs almost nothing.</summary>
    Rest = 3,

    /// <summary>The ball is caught between moving objects that leave it no room.</summary>
    /// <remarks>The ball does not bounce, and does not move faster than the objects.</remarks>
    Pinned = 4,
}
