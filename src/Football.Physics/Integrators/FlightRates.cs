using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The right-hand side in flight, m v̇ = F_G + F_B + F_D + F_M and I ω̇ = T_D, along a constant axis.</summary>
internal static class FlightRates
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Of<TAir>(
        ref TAir air, in AirStep step, in FlightPoint from, double ux, double uy, double uz, double spin, out double ax, out double ay, out double az, out double spinRate)
        where TAir : struct, IAerodynamics
    {
        ax = 0;
        ay = from.Upward;
        az = 0;
        spinRate = 0;
        if (air.Drags || air.Lifts || air.SpinDecays)
        {
            air.Evaluate(in step, (ux * ux) + (uy * uy) + (uz * uz), spin, out double drag, out double lift, out double decay);
            if (air.Lifts)
            {
                // L (ω̂ × u)
                ax = lift * ((from.Axis.Y * uz) - (from.Axis.Z * uy));
                ay += lift * ((from.Axis.Z * ux) - (from.Axis.X * uz));
                az = lift * ((from.Axis.X * uy) - (from.Axis.Y * ux));
            }

            if (air.Drags)
            {
                // −D u
                ax -= drag * ux;
                ay -= drag * uy;
                az -= drag * uz;
            }

            if (air.SpinDecays)
            {
                // A ball without spin stays without.
                spinRate = spin != 0 ? -decay : 0;
            }
        }
    }

    /// <summary>The same at a point by itself.</summary>
    public static void Of<TAir>(ref TAir air, in FlightPoint from, in Vector3d u, double spin, out Vector3d acceleration, out double spinRate)
        where TAir : struct, IAerodynamics
    {
        air.Begin(spin, from.Branch, out AirStep step);
        Of(ref air, in step, in from, u.X, u.Y, u.Z, spin, out double ax, out double ay, out double az, out spinRate);
        acceleration = new Vector3d(ax, ay, az);
    }
}
