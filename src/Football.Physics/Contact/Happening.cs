namespace Football.Physics;

/// <summary>What a piece of motion meets in the world.</summary>
internal enum Happening
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>It touches a collider.</summary>
    Contact,

    /// <summary>It meets a net.</summary>
    NetMet,

    /// <summary>It leaves a net.</summary>
    NetLeft,

    /// <summary>It passes the plane of a goal inside its opening.</summary>
    GoalLine,
}
