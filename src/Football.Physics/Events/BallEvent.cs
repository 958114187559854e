namespace Football.Physics;

/// <summary>Something that happened inside a step, at its exact time and place.</summary>
/// <remarks>
/// An impact carries the impulse's own velocity, before a ball that stays down has its vertical part set to zero; a rest carries
/// velocity and spin as they were when rest was declared.
/// </remarks>
public readonly struct BallEvent
{
    private readonly long _kind; // as wide as its neighbours: equal events are equal bytes

    internal BallEvent(BallEventKind kind, double time, in Vector3d position, in Vector3d velocityBefore, in Vector3d spinBefore, in Vector3d velocity, in Vector3d spin)
    {
        _kind = (long)kind;
        Time = time;
        Position = position;
        VelocityBefore = velocityBefore;
        SpinBefore = spinBefore;
        Velocity = velocity;
        Spin = spin;
    }

    /// <summary>What happened.</summary>
    public BallEventKind Kind => (BallEventKind)_kind;

    /// <summary>When, s since the launch.</summary>
    public double Time { get; }

    /// <summary>Where the centre was, m.</summary>
    public Vector3d Position { get; }

    /// <summary>Velocity just before, m/s; differs from <see cref="Velocity"/> at impacts only.</summary>
    public Vector3d VelocityBefore { get; }

    /// <summary>Spin just before, rad/s; differs from <see cref="Spin"/> at impacts, and by a vanishing slip at a roll.</summary>
    public Vector3d SpinBefore { get; }

    /// <summary>Velocity just after, m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>Spin just after, rad/s.</summary>
    public Vector3d Spin { get; }
}
