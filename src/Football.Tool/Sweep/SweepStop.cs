namespace FootballPhysics.Tool.Sweep;

/// <summary>The event that ends a flight before its time.</summary>
internal enum SweepStop
{
    /// <summary>The first impact.</summary>
    Impact,

    /// <summary>A plane.</summary>
    Plane,

    /// <summary>The ball coming to rest.</summary>
    Rest,

    /// <summary>Nothing.</summary>
    Time,
}
