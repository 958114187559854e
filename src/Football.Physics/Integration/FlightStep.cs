namespace FootballPhysics;

/// <summary>Where a step in flight ends, and the rates at its start.</summary>
internal struct FlightStep
{
    /// <summary>Way through the air, ∫u dt, m.</summary>
    public Vector3d Path;

    /// <summary>Velocity relative to the air at the end, m/s.</summary>
    public Vector3d AirVelocity;

    /// <summary>Size of the spin at the end, rad/s; negative where it would have been reversed.</summary>
    public double SpinRate;

    /// <summary>Angle turned about the axis, rad.</summary>
    public double Turn;

    /// <summary>Distance flown through the air, m, where the air asks for it; else 0.</summary>
    public double AirDistance;

    /// <summary>Acceleration at the start, m/s².</summary>
    public Vector3d StartAcceleration;

    /// <summary>Rate of change of the spin at the start, rad/s².</summary>
    public double StartSpinAcceleration;
}
