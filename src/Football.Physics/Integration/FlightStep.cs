namespace FootballPhysics.Integration;

/// <summary>The result of a flight step: changes over the step, and the rates at its start.</summary>
internal struct FlightStep
{
    /// <summary>The displacement relative to the air, ∫u dt, in m.</summary>
    public Vector3d Path;

    /// <summary>The velocity relative to the air at the end, in m/s.</summary>
    public Vector3d AirVelocity;

    /// <summary>The magnitude of the spin at the end, in rad/s; negative if the step would have reversed it.</summary>
    public double SpinRate;

    /// <summary>The angle of rotation about the axis, in rad.</summary>
    public double Turn;

    /// <summary>The orientation at the end, if the air needs it and the angle at the start is 0.</summary>
    public Quaterniond Orientation;

    /// <summary>The distance flown through the air, in m, if the air needs it; otherwise 0.</summary>
    public double AirDistance;

    /// <summary>The acceleration at the start, in m/s².</summary>
    public Vector3d StartAcceleration;

    /// <summary>The rate of change of the spin at the start, in rad/s².</summary>
    public double StartSpinAcceleration;
}
