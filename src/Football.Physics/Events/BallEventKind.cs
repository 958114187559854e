namespace Football.Physics;

/// <summary>What happened to the ball. At one instant events come in this order.</summary>
public enum BallEventKind
{
    /// <summary>The ball hit the ground.</summary>
    Impact = 0,

    /// <summary>After an impact the ball stayed down, slipping.</summary>
    Slide = 1,

    /// <summary>The slip ended, or the ball stayed down without any: pure rolling.</summary>
    Roll = 2,

    /// <summary>The ball came to rest.</summary>
    Rest = 3,
}
