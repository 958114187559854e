namespace Football.Physics;

/// <summary>What became of a search for a kick.</summary>
public enum AimStatus
{
    /// <summary>The kick passes the target within the tolerance, and the point on the way, where there is one, within its own.</summary>
    Hit = 0,

    /// <summary>No kick within the bounds does; the one returned comes closest, as far as the method can tell.</summary>
    OutOfReach = 1,

    /// <summary>The method ended at its bound, <see cref="AimRequest.MaximumIterations"/>, or a miss is too small for its own steps; the kick returned is the best it found.</summary>
    NotConverged = 2,

    /// <summary>The request has no direction: the target is where the ball is.</summary>
    Degenerate = 3,

    /// <summary>The kick passes the target within the tolerance, but not the point on the way: the spins allowed do not bend it enough.</summary>
    TargetOnly = 4,

    /// <summary>The kick returned would hit, but something of the scene is in its way: <see cref="AimResult.BlockedBy"/> says what.</summary>
    Blocked = 5,
}
