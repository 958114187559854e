using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A ball on the flat ground: place and velocity along x and z, and the whole spin. Scalars, so that a step keeps them in registers.</summary>
internal struct PlanarMotion
{
    public double X;
    public double Z;
    public double VX;
    public double VZ;
    public double WX;
    public double WY;
    public double WZ;

    /// <summary>The state of a ball on the ground.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public PlanarMotion(in BallState s)
    {
        X = s.Position.X;
        Z = s.Position.Z;
        VX = s.Flight.Velocity.X;
        VZ = s.Flight.Velocity.Z;
        double rate = s.Flight.SpinRate;
        WX = s.Flight.Axis.X * rate;
        WY = s.Flight.Axis.Y * rate;
        WZ = s.Flight.Axis.Z * rate;
    }

    /// <summary>Velocity, m/s.</summary>
    public readonly Vector3d Velocity => new(VX, 0, VZ);

    /// <summary>Spin, rad/s.</summary>
    public readonly Vector3d Spin => new(WX, WY, WZ);

    /// <summary>The square of the speed, m²/s².</summary>
    public readonly double SpeedSquared => (VX * VX) + (VZ * VZ);

    /// <summary>The square of the spin, rad²/s².</summary>
    public readonly double SpinSquared => (WX * WX) + (WY * WY) + (WZ * WZ);

    /// <summary>The motion after h with a constant velocity and constant rates: a stage.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly PlanarMotion After(double h, double vx, double vz, in PlanarRates rates)
    {
        PlanarMotion after;
        after.X = X + (h * vx);
        after.Z = Z + (h * vz);
        after.VX = VX + (h * rates.AX);
        after.VZ = VZ + (h * rates.AZ);
        after.WX = WX + (h * rates.BX);
        after.WY = WY + (h * rates.BY);
        after.WZ = WZ + (h * rates.BZ);
        return after;
    }

    /// <summary>A copy, field by field: a copy as a whole would wait for the fields that have just been written one by one.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void CopyTo(out PlanarMotion copy)
    {
        copy.X = X;
        copy.Z = Z;
        copy.VX = VX;
        copy.VZ = VZ;
        copy.WX = WX;
        copy.WY = WY;
        copy.WZ = WZ;
    }
}
