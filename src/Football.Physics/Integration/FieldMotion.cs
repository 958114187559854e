using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>
/// A ball in flight along a constant axis of the spin, in air that depends on place or time. Scalars, so that a step keeps them in registers: a vector
/// that is read as a whole waits for the components that have just been written one by one.
/// </summary>
internal struct FieldMotion
{
    /// <summary>Position of the centre, m.</summary>
    public double X;
    public double Y;
    public double Z;

    /// <summary>Velocity, m/s.</summary>
    public double VX;
    public double VY;
    public double VZ;

    /// <summary>Spin about the axis, rad/s.</summary>
    public double SpinRate;

    /// <summary>Distance flown through the air, m, where the air asks for it.</summary>
    public double AirDistance;

    /// <summary>The motion of a ball in flight.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FieldMotion(in BallState s)
    {
        X = s.Position.X;
        Y = s.Position.Y;
        Z = s.Position.Z;
        VX = s.Flight.Velocity.X;
        VY = s.Flight.Velocity.Y;
        VZ = s.Flight.Velocity.Z;
        SpinRate = s.Flight.SpinRate;
        AirDistance = s.AirDistance;
    }

    /// <summary>Position of the centre, m.</summary>
    public readonly Vector3d Position => new(X, Y, Z);

    /// <summary>Velocity, m/s.</summary>
    public readonly Vector3d Velocity => new(VX, VY, VZ);

    /// <summary>The motion after h with a constant velocity and constant rates: a stage.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void After(double h, double vx, double vy, double vz, in FieldRates rates, out FieldMotion after)
    {
        after.X = X + (h * vx);
        after.Y = Y + (h * vy);
        after.Z = Z + (h * vz);
        after.VX = VX + (h * rates.AX);
        after.VY = VY + (h * rates.AY);
        after.VZ = VZ + (h * rates.AZ);
        after.SpinRate = SpinRate + (h * rates.SpinAcceleration);
        after.AirDistance = AirDistance + (h * rates.AirSpeed);
    }
}
