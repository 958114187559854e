using System.Runtime.CompilerServices;

namespace Football.Physics;

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
