namespace FootballPhysics.Laws;

/// <summary>The input of a force: the ball at one instant.</summary>
public readonly struct ForceContext
{
    internal ForceContext(
        double time,
        in Vector3d position,
        in Vector3d velocity,
        in Vector3d airVelocity,
        in Vector3d spin,
        MotionState motion,
        double airDistance = 0)
    {
        Time = time;
        Position = position;
        Velocity = velocity;
        AirVelocity = airVelocity;
        Spin = spin;
        Motion = motion;
        AirDistance = airDistance;
    }

    /// <summary>Time since the launch, s.</summary>
    public double Time { get; }

    /// <summary>Position of the centre, m.</summary>
    public Vector3d Position { get; }

    /// <summary>Velocity, m/s.</summary>
    public Vector3d Velocity { get; }

    /// <summary>Velocity relative to the air, u = v − W, m/s: what aerodynamic laws see.</summary>
    public Vector3d AirVelocity { get; }

    /// <summary>Angular velocity, rad/s.</summary>
    public Vector3d Spin { get; }

    /// <summary>The motion of the ball: in the air, sliding, rolling or at rest.</summary>
    public MotionState Motion { get; }

    /// <summary>Distance flown through the air since the kick, m, where a knuckle force acts; else 0.</summary>
    internal double AirDistance { get; }

    /// <summary>A copy with another velocity relative to the air.</summary>
    internal ForceContext In(in Vector3d airVelocity) => new(Time, Position, Velocity, in airVelocity, Spin, Motion, AirDistance);
}
