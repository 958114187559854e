using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A ball in flight along a constant axis of the spin, in air that depends on place or time.</summary>
internal struct FieldMotion
{
    /// <summary>Position of the centre, m.</summary>
    public Vector3d Position;

    /// <summary>Velocity, m/s.</summary>
    public Vector3d Velocity;

    /// <summary>Spin about the axis, rad/s.</summary>
    public double SpinRate;

    /// <summary>Distance flown through the air, m, where the air asks for it.</summary>
    public double AirDistance;

    /// <summary>The motion after h with a constant velocity and constant rates: a stage.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void After(double h, in Vector3d velocity, in FieldRates rates, out FieldMotion after)
    {
        after.Position = new Vector3d(Position.X + (h * velocity.X), Position.Y + (h * velocity.Y), Position.Z + (h * velocity.Z));
        after.Velocity = new Vector3d(
            Velocity.X + (h * rates.Acceleration.X), Velocity.Y + (h * rates.Acceleration.Y), Velocity.Z + (h * rates.Acceleration.Z));
        after.SpinRate = SpinRate + (h * rates.SpinAcceleration);
        after.AirDistance = AirDistance + (h * rates.AirSpeed);
    }
}
