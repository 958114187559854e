namespace FootballPhysics;

/// <summary>The branch of the published drag law that a step is locked to.</summary>
internal enum DragBranch
{
    /// <summary>Not known yet: to be read from the flow.</summary>
    Unknown = 0,

    /// <summary>The law without spin.</summary>
    NoSpin = 1,

    /// <summary>The law with spin: above the critical speed and spin parameter.</summary>
    Spinning = 2,

    /// <summary>Sliding along |u| = v_c: both branches push the ball back onto it.</summary>
    AlongCriticalSpeed = 3,

    /// <summary>Sliding along Sp = 0.05: both branches push the ball back onto it.</summary>
    AlongCriticalSpin = 4,
}
