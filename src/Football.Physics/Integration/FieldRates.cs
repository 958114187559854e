namespace Football.Physics;

/// <summary>Rates of change of a <see cref="FieldMotion"/>.</summary>
internal struct FieldRates
{
    /// <summary>Acceleration, m/s².</summary>
    public double AX;
    public double AY;
    public double AZ;

    /// <summary>rad/s².</summary>
    public double SpinAcceleration;

    /// <summary>Speed relative to the air, m/s, where the air asks for the distance flown; else 0.</summary>
    public double AirSpeed;

    /// <summary>Acceleration, m/s².</summary>
    public readonly Vector3d Acceleration => new(AX, AY, AZ);
}
