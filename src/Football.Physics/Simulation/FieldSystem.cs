using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>A ball in flight in air whose wind depends on place or time, or with a knuckle force, along a constant axis of the spin.</summary>
internal struct FieldSystem : IFieldSystem
{
    /// <summary>The air, the steady wind, gravity and buoyancy.</summary>
    public Surroundings Around;

    /// <summary>Unit axis of the spin.</summary>
    public Vector3d Axis;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly void Rates(double time, in FieldMotion at, out FieldRates rates)
    {
        ref SceneAir air = ref Around.Air;
        Vector3d wind = air.WindAt(time, at.Position);
        double ux = at.VX - Around.Wind.X - wind.X;
        double uy = at.VY - Around.Wind.Y - wind.Y;
        double uz = at.VZ - Around.Wind.Z - wind.Z;
        double cx = (Axis.Y * uz) - (Axis.Z * uy);
        double cy = (Axis.Z * ux) - (Axis.X * uz);
        double cz = (Axis.X * uy) - (Axis.Y * ux);
        double speedSquared = (ux * ux) + (uy * uy) + (uz * uz);
        double acrossSquared = (cx * cx) + (cy * cy) + (cz * cz);
        air.Factors(speedSquared, at.SpinRate, acrossSquared, DragBranch.Unknown, out double drag, out double lift, out double decay);
        Vector3d side = air.Side(new Vector3d(ux, uy, uz), at.SpinRate * Axis, at.AirDistance, out rates.AirSpeed);

        // v̇ = L (n × u) − D u + g + F_K/m,  ω̇ = −decay
        rates.AX = (lift * cx) - (drag * ux) + side.X;
        rates.AY = (lift * cy) - (drag * uy) + side.Y + Around.Upward;
        rates.AZ = (lift * cz) - (drag * uz) + side.Z;
        rates.SpinAcceleration = -decay;
    }
}
