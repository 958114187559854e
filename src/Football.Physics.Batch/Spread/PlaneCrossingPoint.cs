namespace FootballPhysics.Batch;

/// <summary>The point and time at which a kick crosses a plane.</summary>
internal readonly struct PlaneCrossingPoint
{
    public PlaneCrossingPoint(double time, in Vector3d position)
    {
        Time = time;
        Position = position;
    }

    /// <summary>The time, in s; negative if the kick does not cross.</summary>
    public double Time { get; }

    /// <summary>The position, in m.</summary>
    public Vector3d Position { get; }
}
