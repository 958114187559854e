namespace Football.Physics;

/// <summary>Where a step in flight starts.</summary>
internal struct FlightPoint
{
    /// <summary>Velocity relative to the air, u = v − W, m/s.</summary>
    public Vector3d AirVelocity;

    /// <summary>Size of the spin, rad/s.</summary>
    public double SpinRate;

    /// <summary>Unit axis of the spin.</summary>
    public Vector3d Axis;

    /// <summary>Upward acceleration by gravity and buoyancy, m/s².</summary>
    public double Upward;

    /// <summary>Branch of the drag law that the step is locked to.</summary>
    public DragBranch Branch;
}
