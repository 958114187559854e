using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Position, velocity and spin, and the distance flown: what a general step advances.</summary>
internal readonly struct Motion
{
    public readonly Vector3d Position;
    public readonly Vector3d Velocity;
    public readonly Vector3d Spin;

    /// <summary>Distance flown through the air, m, where the air of the scene asks for it.</summary>
    public readonly double AirDistance;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Motion(in Vector3d position, in Vector3d velocity, in Vector3d spin, double airDistance = 0)
    {
        Position = position;
        Velocity = velocity;
        Spin = spin;
        AirDistance = airDistance;
    }

    /// <summary>The motion after h with constant rates: a stage.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Motion After(double h, in Vector3d velocity, in MotionRates rates) =>
        new(Position + (h * velocity), Velocity + (h * rates.Acceleration), Spin + (h * rates.SpinAcceleration), AirDistance + (h * rates.AirSpeed));
}

/// <summary>Rates of change of velocity, spin and the distance flown.</summary>
internal readonly struct MotionRates
{
    public readonly Vector3d Acceleration;
    public readonly Vector3d SpinAcceleration;

    /// <summary>Speed relative to the air, m/s, where the air of the scene asks for it.</summary>
    public readonly double AirSpeed;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MotionRates(in Vector3d acceleration, in Vector3d spinAcceleration, double airSpeed = 0)
    {
        Acceleration = acceleration;
        SpinAcceleration = spinAcceleration;
        AirSpeed = airSpeed;
    }
}
