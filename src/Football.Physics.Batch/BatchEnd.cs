namespace FootballPhysics.Batch;

/// <summary>The way in which a flight of a batch ended.</summary>
public enum BatchEnd
{
    /// <summary>The flight ended with an impact on the ground.</summary>
    Impact = 0,

    /// <summary>The ball was still in flight when the time ran out.</summary>
    Time = 1,

    /// <summary>The flight never began: the ball lay on the ground, and its launch did not lift it.</summary>
    Ground = 2,
}
