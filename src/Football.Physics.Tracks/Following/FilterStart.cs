namespace FootballPhysics.Tracks;

/// <summary>The constraint of a motion at its start.</summary>
internal enum FilterStart
{
    /// <summary>Position, velocity and spin are free.</summary>
    Free = 0,

    /// <summary>The ball touches the ground and has no vertical velocity.</summary>
    Sliding = 1,

    /// <summary>The ball rolls: its velocity determines its spin, except for the spin about the vertical axis.</summary>
    Rolling = 2,
}
