using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The right-hand side in flight, m v̇ = F_G + F_B + F_D + F_M and I ω̇ = T_D, along a constant axis.</summary>
internal static class FlightRates
{
    /// <summary>The rates at a stage of a step.</summary>
    /// <param name="air">The aerodynamic laws.</param>
    /// <param name="once">What they computed once for the step.</param>
    /// <param name="nx">Axis of the spin, x.</param>
    /// <param name="ny">Axis of the spin, y.</param>
    /// <param name="nz">Axis of the spin, z.</param>
    /// <param name="upward">Upward acceleration by gravity and buoyancy.</param>
    /// <param name="ux">Air-relative velocity, x.</param>
    /// <param name="uy">Air-relative velocity, y.</param>
    /// <param name="uz">Air-relative velocity, z.</param>
    /// <param name="spin">Size of the spin.</param>
    /// <param name="ax">Acceleration, x.</param>
    /// <param name="ay">Acceleration, y.</param>
    /// <param name="az">Acceleration, z.</param>
    /// <param name="spinRate">Rate of change of the spin.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Of<TAir>(
        ref TAir air,
        in AirStep once,
        double nx,
        double ny,
        double nz,
        double upward,
        double ux,
        double uy,
        double uz,
        double spin,
        out double ax,
        out double ay,
        out double az,
        out double spinRate)
        where TAir : struct, IAerodynamics
    {
        ax = 0;
        ay = upward;
        az = 0;
        spinRate = 0;
        if (air.Drags || air.Lifts || air.SpinDecays)
        {
            air.Evaluate(in once, (ux * ux) + (uy * uy) + (uz * uz), spin, out double drag, out double lift, out double decay);
            if (air.Lifts && air.Drags)
            {
                // L (ω̂ × u) − D u + g
                ax = (lift * ((ny * uz) - (nz * uy))) - (drag * ux);
                ay = ((lift * ((nz * ux) - (nx * uz))) - (drag * uy)) + upward;
                az = (lift * ((nx * uy) - (ny * ux))) - (drag * uz);
            }
            else if (air.Lifts)
            {
                ax = lift * ((ny * uz) - (nz * uy));
                ay = (lift * ((nz * ux) - (nx * uz))) + upward;
                az = lift * ((nx * uy) - (ny * ux));
            }
            else if (air.Drags)
            {
                ax = -(drag * ux);
                ay = upward - (drag * uy);
                az = -(drag * uz);
            }

            if (air.SpinDecays)
            {
                // A ball without spin stays without.
                spinRate = spin != 0 ? -decay : 0;
            }
        }
    }

    /// <summary>The rates at a point by itself.</summary>
    public static void Of<TAir>(ref TAir air, in FlightPoint from, in Vector3d u, double spin, out Vector3d acceleration, out double spinRate)
        where TAir : struct, IAerodynamics
    {
        air.Begin(spin, from.Branch, out AirStep once);
        Of(ref air, in once, from.Axis.X, from.Axis.Y, from.Axis.Z, from.Upward, u.X, u.Y, u.Z, spin, out double ax, out double ay, out double az, out spinRate);
        acceleration = new Vector3d(ax, ay, az);
    }
}
