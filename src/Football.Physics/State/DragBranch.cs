namespace FootballPhysics.State;

/// <summary>The branch of the published drag law that a step uses.</summary>
internal enum DragBranch
{
    /// <summary>Not known yet; the flow at the ball decides.</summary>
    Unknown = 0,

    /// <summary>The law without spin.</summary>
    NoSpin = 1,

    /// <summary>The law with spin, above the critical speed and spin parameter.</summary>
    Spinning = 2,

    /// <summary>Sliding along |u| = v_c: both branches drive the flow back to it.</summary>
    AlongCriticalSpeed = 3,

    /// <summary>Sliding along Sp = 0.05: both branches drive the flow back to it.</summary>
    AlongCriticalSpin = 4,
}
