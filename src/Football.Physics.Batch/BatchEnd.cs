namespace FootballPhysics.Batch;

/// <summary>How a flight of a batch ended.</summary>
public enum BatchEnd
{
    /// <summary>With an impact on the ground.</summary>
    Impact = 0,

    /// <summary>In the air, because its time was up.</summary>
    Time = 1,

    /// <summary>It never began: the ball lay on the ground, and its launch did not lift it.</summary>
    Ground = 2,
}
