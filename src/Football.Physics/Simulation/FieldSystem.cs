using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A ball in flight in air whose wind depends on place or time, or with a knuckle force, along a constant axis of the spin.</summary>
internal struct FieldSystem : IFieldSystem
{
    /// <summary>The air.</summary>
    public FieldAir Air;

    /// <summary>Steady wind, m/s.</summary>
    public Vector3d Wind;

    /// <summary>Upward acceleration by gravity and buoyancy, m/s².</summary>
    public double Upward;

    /// <summary>Unit axis of the spin.</summary>
    public Vector3d Axis;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Rates(double time, in FieldMotion at, out FieldRates rates)
    {
        Vector3d wind = Air.WindAt(time, at.Position);
        double ux = at.VX - Wind.X - wind.X;
        double uy = at.VY - Wind.Y - wind.Y;
        double uz = at.VZ - Wind.Z - wind.Z;
        double cx = (Axis.Y * uz) - (Axis.Z * uy);
        double cy = (Axis.Z * ux) - (Axis.X * uz);
        double cz = (Axis.X * uy) - (Axis.Y * ux);
        Air.AtPoint((ux * ux) + (uy * uy) + (uz * uz), at.SpinRate, (cx * cx) + (cy * cy) + (cz * cz), out double drag, out double lift, out double decay);
        Vector3d side = Air.Side(new Vector3d(ux, uy, uz), at.SpinRate * Axis, at.AirDistance, out rates.AirSpeed);

        // v̇ = L (n × u) − D u + g + F_K/m,  ω̇ = −decay
        rates.AX = (lift * cx) - (drag * ux) + side.X;
        rates.AY = (lift * cy) - (drag * uy) + side.Y + Upward;
        rates.AZ = (lift * cz) - (drag * uz) + side.Z;
        rates.SpinAcceleration = -decay;
    }
}
