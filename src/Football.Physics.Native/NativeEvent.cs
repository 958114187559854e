namespace FootballPhysics.Native;

/// <summary>Something that happened inside a step, at its exact time and place.</summary>
internal unsafe struct NativeEvent
{
    /// <summary>The kind, one of fp_event_kind.</summary>
    public int Kind;

    /// <summary>What was hit, met or passed, or carries the ball: its index among the things of the scene, whose name fp_name tells; -1 for none.</summary>
    public int Thing;

    /// <summary>When, s since the launch.</summary>
    public double Time;

    /// <summary>Where the centre was, m.</summary>
    public fixed double Position[3];

    /// <summary>Velocity just before, m/s.</summary>
    public fixed double VelocityBefore[3];

    /// <summary>Velocity just after, m/s.</summary>
    public fixed double Velocity[3];

    /// <summary>Spin just before, rad/s.</summary>
    public fixed double SpinBefore[3];

    /// <summary>Spin just after, rad/s.</summary>
    public fixed double Spin[3];

    /// <summary>Normal of the contact, from the thing to the ball, of length 1; zero where there is none.</summary>
    public fixed double Normal[3];
}
