namespace FootballPhysics;

/// <summary>The motion of the ball, which decides which forces act.</summary>
public enum MotionState
{
    /// <summary>In the air, between bounces included.</summary>
    Airborne = 0,

    /// <summary>On the ground, its contact point slipping.</summary>
    Sliding = 1,

    /// <summary>On the ground without slip.</summary>
    Rolling = 2,

    /// <summary>At rest until the next kick; costs nothing.</summary>
    Rest = 3,

    /// <summary>Between things of which some move, and which leave it no room: it is not bounced, and not faster than they are.</summary>
    Pinned = 4,
}
