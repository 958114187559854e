using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>Position, velocity and spin: what a general step advances.</summary>
internal readonly struct Motion
{
    public readonly Vector3d Position;
    public readonly Vector3d Velocity;
    public readonly Vector3d Spin;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Motion(in Vector3d position, in Vector3d velocity, in Vector3d spin)
    {
        Position = position;
        Velocity = velocity;
        Spin = spin;
    }

    /// <summary>The motion after h with constant rates: a stage.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Motion After(double h, in Vector3d velocity, in MotionRates rates) =>
        new(Position + (h * velocity), Velocity + (h * rates.Acceleration), Spin + (h * rates.SpinAcceleration));
}
