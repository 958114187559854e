namespace FootballPhysics;

/// <summary>The event that ends a run early.</summary>
public enum StopAt
{
    /// <summary>None: the run continues to its end time.</summary>
    Time = 0,

    /// <summary>The first impact, just after its impulse.</summary>
    Impact = 1,

    /// <summary>The moment at which the ball comes to rest.</summary>
    Rest = 2,
}
