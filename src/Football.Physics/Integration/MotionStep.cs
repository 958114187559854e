namespace Football.Physics;

/// <summary>Where a general step ends, and the rates at its start.</summary>
internal struct MotionStep
{
    /// <summary>The motion at the end.</summary>
    public Motion End;

    /// <summary>Rotation vector of the step, rad.</summary>
    public Vector3d Rotation;

    /// <summary>Rates at the start.</summary>
    public MotionRates StartRates;
}
