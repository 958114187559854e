namespace Football.Physics;

/// <summary>Something that happened inside a step, at its exact time and place.</summary>
/// <remarks>
/// An impact carries the impulse's own velocity, before a ball that stays down has its vertical part set to zero; a rest carries
/// velocity and spin as they were when rest was declared.
/// </remarks>
public readonly struct BallEvent
{
    private readonly int _kind;

    internal BallEvent(
        BallEventKind kind,
        int thing,
        in Vector3d normal,
        double time,
        in Vector3d position,
        in Vector3d velocityBefore,
        in Vector3d spinBefore,
        in Vector3d velocity,
        in Vector3d spin)
    {
        _kind = (int)kind;
        Thing = thing;
        Normal = normal;
        Time = time;
        Position = position;
        VelocityBefore = velocityBefore;
        SpinBefore = spinBefore;
        Velocity = velocity;
        Spin = spin;
    }

    /// <summary>What happened.</summary>
    public BallEventKind Kind => (BallEventKind)_kind;

    /// <summary>
    /// What was hit, met or passed, or carries the ball: its index among the things of the scene; −1 for none. 0 is the ground, then
    /// come the obstacles in their order, the posts and bars of the goals, all nets, the goals. the simulator gives its name.
    /// </summary>
    public int Thing { get; }

    /// <summary>Normal of the contact, from the thing to the ball, of length 1; of a net or a goal that of its plane, towards where the ball came from. Zero for a rest or a leave.</summary>
    public Vector3d Normal { get; }

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
