namespace FootballPhysics.Batch;

/// <summary>Where and when a kick crosses a plane.</summary>
internal readonly struct PlaneCrossingPoint
{
    public PlaneCrossingPoint(double time, in Vector3d position)
    {
        Time = time;
        Position = position;
    }

    /// <summary>When, s; negative where it does not.</summary>
    public double Time { get; }

    /// <summary>Where, m.</summary>
    public Vector3d Position { get; }
}
