using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Rates of change of velocity and spin.</summary>
internal readonly struct MotionRates
{
    public readonly Vector3d Acceleration;
    public readonly Vector3d SpinAcceleration;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MotionRates(in Vector3d acceleration, in Vector3d spinAcceleration)
    {
        Acceleration = acceleration;
        SpinAcceleration = spinAcceleration;
    }
}
