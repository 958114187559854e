namespace FootballPhysics;

/// <summary>The kind of an event of the ball. At one instant an impact comes first, then what follows from it.</summary>
public enum BallEventKind
{
    /// <summary>The ball hit the ground, or another thing.</summary>
    Impact = 0,

    /// <summary>After an impact the ball stayed down, slipping.</summary>
    Slide = 1,

    /// <summary>The slip ended, or the ball stayed down without any: pure rolling.</summary>
    Roll = 2,

    /// <summary>The ball came to rest.</summary>
    Rest = 3,

    /// <summary>The ball met a net.</summary>
    Net = 4,

    /// <summary>
    /// All of the ball is over the line of a goal, which is as wide as its posts: the centre has come through the mouth, the plane of the posts' axes, between
    /// the posts and below the bar, has not gone back through it, and is now the radii of post and ball behind the line's middle, wherever on that plane.
    /// Once for each goal, until the ball is kicked or placed.
    /// </summary>
    Goal = 5,

    /// <summary>The ball left what carried it without an impact with it: over a crest, or lifted by a hit.</summary>
    ContactEnd = 6,

    /// <summary>
    /// Things that move leave the ball no room, and the thing is one of them: until the next such event, which has no thing, nothing bounces it, and what it
    /// hits is not told one by one. The ball is then <see cref="MotionState.Pinned"/>.
    /// </summary>
    Pinned = 7,

    /// <summary>The ball entered a <see cref="Zone"/>.</summary>
    EnterZone = 8,

    /// <summary>The ball left a <see cref="Zone"/>.</summary>
    ExitZone = 9,
}
