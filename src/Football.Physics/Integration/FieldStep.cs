namespace Football.Physics;

/// <summary>Where a step of a <see cref="FieldMotion"/> ends, the angle that the ball turned, and the acceleration at its start.</summary>
internal struct FieldStep
{
    /// <summary>The motion at the end.</summary>
    public FieldMotion End;

    /// <summary>Angle turned about the axis, rad.</summary>
    public double Turn;

    /// <summary>Acceleration at the start, m/s².</summary>
    public Vector3d StartAcceleration;
}
