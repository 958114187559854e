namespace FootballPhysics;

/// <summary>The event that ends a run before its time is up.</summary>
public enum StopAt
{
    /// <summary>Nothing: the run goes on until its time.</summary>
    Time = 0,

    /// <summary>The first impact with the ground, just after the impulse.</summary>
    Impact = 1,

    /// <summary>The ball coming to rest.</summary>
    Rest = 2,
}
