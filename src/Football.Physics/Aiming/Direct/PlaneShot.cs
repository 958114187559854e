namespace Football.Physics;

/// <summary>A kick that was flown to the target's plane, and its residual there.</summary>
internal struct PlaneShot
{
    public Kick Kick;

    /// <summary>Whether it got there.</summary>
    public readonly bool Crossed => Crossing.Crossed;

    /// <summary>When, s.</summary>
    public readonly double Time => Crossing.Time;

    /// <summary>Height above the target there, m.</summary>
    public double Up;

    /// <summary>Distance to the left of the target there, m.</summary>
    public double Left;

    /// <summary>Distance from the target there, m.</summary>
    public double Miss;

    /// <summary>The crossing.</summary>
    public PlaneCrossing Crossing;

    /// <summary>The lowest height on the way, m.</summary>
    public double Lowest;
}
