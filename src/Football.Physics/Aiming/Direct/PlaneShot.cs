namespace Football.Physics;

/// <summary>A kick that was flown to the target's plane, and its residual there.</summary>
internal struct PlaneShot
{
    public Kick Kick;

    /// <summary>Whether it got there.</summary>
    public bool Crossed;

    /// <summary>Height above the target there, m.</summary>
    public double Up;

    /// <summary>Distance to the left of the target there, m.</summary>
    public double Left;

    /// <summary>Distance from the target there, m.</summary>
    public double Miss;

    /// <summary>When, s.</summary>
    public double Time;

    /// <summary>Velocity relative to the target there, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>The lowest height on the way, m.</summary>
    public double Lowest;
}
