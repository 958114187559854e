namespace FootballPhysics.Native;

/// <summary>An event inside a step, at its exact time and position.</summary>
internal unsafe struct NativeEvent
{
    /// <summary>The kind, one of fp_event_kind.</summary>
    public int Kind;

    /// <summary>The index in the scene of the object that the ball hits, touches or passes, or that supports it; -1 if there is none. fp_name writes its name.</summary>
    public int Thing;

    /// <summary>The time, s since the launch.</summary>
    public double Time;

    /// <summary>The position of the ball's centre, m.</summary>
    public fixed double Position[3];

    /// <summary>Velocity just before, m/s.</summary>
    public fixed double VelocityBefore[3];

    /// <summary>Velocity just after, m/s.</summary>
    public fixed double Velocity[3];

    /// <summary>Spin just before, rad/s.</summary>
    public fixed double SpinBefore[3];

    /// <summary>Spin just after, rad/s.</summary>
    public fixed double Spin[3];

    /// <summary>The unit normal of the contact, from the object to the ball; zero without a contact.</summary>
    public fixed double Normal[3];
}
