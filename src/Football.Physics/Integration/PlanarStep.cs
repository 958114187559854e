namespace Football.Physics;

/// <summary>Where a step on the flat ground ends, and the rates at its start.</summary>
internal struct PlanarStep
{
    /// <summary>The motion at the end.</summary>
    public PlanarMotion End;

    /// <summary>Rotation vector of the step, rad.</summary>
    public Vector3d Rotation;

    /// <summary>Rates at the start.</summary>
    public PlanarRates StartRates;
}
