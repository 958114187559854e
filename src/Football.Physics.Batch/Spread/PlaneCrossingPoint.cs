namespace FootballPhysics.Batch;

/// <summary>The point and time at which a kick crosses a plane.</summary>
internal readonly struct PlaneCrossingPoint(double time, in Vector3d position)
{
    /// <summary>The time, in s; negative if the kick does not cross.</summary>
    public double Time { get; } = time;

    /// <summary>The position, in m.</summary>
    public Vector3d Position { get; } = position;
}
