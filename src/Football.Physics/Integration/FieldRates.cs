namespace Football.Physics;

/// <summary>Rates of change of a <see cref="FieldMotion"/>.</summary>
internal struct FieldRates
{
    /// <summary>m/s².</summary>
    public Vector3d Acceleration;

    /// <summary>rad/s².</summary>
    public double SpinAcceleration;

    /// <summary>Speed relative to the air, m/s, where the air asks for the distance flown; else 0.</summary>
    public double AirSpeed;
}
