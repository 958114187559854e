namespace FootballPhysics.Laws;

/// <summary>The state of the ball at one instant: the input of a custom force.</summary>
public readonly struct ForceContext
{
    internal ForceContext(
        double time,
        in Vector3d position,
        in Vector3d velocity,
        in Vector3d airVelocity,
        in Vector3d spin,
        MotionState motion,
        double airDistance = 0,
        in Quaterniond orientation = default)
    {
        Time = time;
        Position = position;
        Velocity = velocity;
        AirVelocity = airVelocity;
        Spin = spin;
        Motion = motion;
        AirDistance = airDistance;
        Orientation = orientation;
    }

    /// <summary>The time since the launch, in s.</summary>
    public double Time { get; }

    /// <summary>The position of the ball's centre, in m.</summary>
    public Vector3d Position { get; }

    /// <summary>The velocity, in m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>The velocity relative to the air, u = v − W, in m/s. The aerodynamic laws use this velocity.</summary>
    public Vector3d AirVelocity { get; }

    /// <summary>The angular velocity, in rad/s.</summary>
    public Vector3d Spin { get; }

    /// <summary>The motion of the ball: in flight, sliding, rolling or at rest.</summary>
    public MotionState Motion { get; }

    /// <summary>The distance through the air since the kick, in m; 0 if no knuckle force acts.</summary>
    internal double AirDistance { get; }

    /// <summary>The orientation; set only if a knuckle force acts.</summary>
    internal Quaterniond Orientation { get; }

    /// <summary>Returns a copy with another velocity relative to the air.</summary>
    internal ForceContext In(in Vector3d airVelocity) => new(Time, Position, Velocity, in airVelocity, Spin, Motion, AirDistance, Orientation);
}
