namespace Football.Physics;

/// <summary>Where a step of a <see cref="FieldMotion"/> ends, and the angle that the ball turned.</summary>
internal struct FieldStep
{
    /// <summary>The motion at the end.</summary>
    public FieldMotion End;

    /// <summary>Angle turned about the axis, rad.</summary>
    public double Turn;
}
