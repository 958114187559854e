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
        Vector3d u = at.Velocity - Wind;
        Air.AlongAxis(time, in at.Position, ref u, in Axis, at.SpinRate, at.AirDistance, out double drag, out double lift, out double decay, out Vector3d side, out rates.AirSpeed);

        // v̇ = L (n × u) − D u + g + F_K/m,  ω̇ = −decay
        rates.Acceleration = new Vector3d(
            (lift * ((Axis.Y * u.Z) - (Axis.Z * u.Y))) - (drag * u.X) + side.X,
            (lift * ((Axis.Z * u.X) - (Axis.X * u.Z))) - (drag * u.Y) + side.Y + Upward,
            (lift * ((Axis.X * u.Y) - (Axis.Y * u.X))) - (drag * u.Z) + side.Z);
        rates.SpinAcceleration = -decay;
    }
}
