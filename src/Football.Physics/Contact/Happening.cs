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

    /// <summary>It comes through the mouth of a goal.</summary>
    MouthEntered,

    /// <summary>It goes back through the mouth.</summary>
    MouthLeft,

    /// <summary>Having come through the mouth, all of it is over the line.</summary>
    GoalLine,
}
