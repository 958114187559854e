namespace FootballPhysics;

/// <summary>The kind of an event. If several events happen at one instant, an impact is reported before its consequences.</summary>
public enum BallEventKind
{
    /// <summary>The ball hit the ground or an object.</summary>
    Impact = 0,

    /// <summary>The ball stayed on the surface after an impact, and slides.</summary>
    Slide = 1,

    /// <summary>The ball began to roll without slip.</summary>
    Roll = 2,

    /// <summary>The ball came to rest.</summary>
    Rest = 3,

    /// <summary>The ball hit a net.</summary>
    Net = 4,

    /// <summary>A goal: the entire ball passed the goal line.</summary>
    /// <remarks>
    /// The mouth is the part of the plane of the posts' axes between the posts and below the crossbar. The ball's centre passed through the mouth, and did not
    /// come back. The centre is now one post radius plus one ball radius behind the middle of the line. The event is reported once per goal until the ball is
    /// kicked or placed.
    /// </remarks>
    Goal = 5,

    /// <summary>The ball left the surface that supported it, without an impact: over a crest, or lifted by a hit.</summary>
    ContactEnd = 6,

    /// <summary>Moving objects pinned the ball; the event reports one of these objects. An event without an object reports that the ball is free
    /// again.</summary>
    /// <remarks>Between these two events the motion is <see cref="MotionState.Pinned"/>: the ball does not bounce, and its contacts are not reported.</remarks>
    Pinned = 7,

    /// <summary>The ball entered a <see cref="Zone"/>.</summary>
    EnterZone = 8,

    /// <summary>The ball left a <see cref="Zone"/>.</summary>
    ExitZone = 9,
}
