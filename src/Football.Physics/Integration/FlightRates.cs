using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The right-hand side in flight, m v̇ = F_G + F_B + F_D + F_M and I ω̇ = T_D, along a constant axis of the spin.</summary>
internal static class FlightRates
{
    /// <summary>The rates at one instant, a = L (ω̂ × u) − D u + g, |ω|˙ = −decay.</summary>
    /// <param name="air">The laws of the air.</param>
    /// <param name="branch">The branch of the drag law that the step is locked to.</param>
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
    public static void At<TAir>(
        ref TAir air,
        DragBranch branch,
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
        where TAir : struct, IFlightLaws
    {
        // Where the law does not ask for the part across the spin, no code remains of its square.
        double cx = (ny * uz) - (nz * uy);
        double cy = (nz * ux) - (nx * uz);
        double cz = (nx * uy) - (ny * ux);
        air.Factors(
            (ux * ux) + (uy * uy) + (uz * uz), spin, (cx * cx) + (cy * cy) + (cz * cz), branch, out double drag, out double lift, out double decay);
        ax = (lift * cx) - (drag * ux);
        ay = ((lift * cy) - (drag * uy)) + upward;
        az = (lift * cz) - (drag * uz);

        // A ball without spin stays without.
        spinRate = spin != 0 ? -decay : 0;
    }

    /// <summary>The rates at a point by itself.</summary>
    public static void Of<TAir>(ref TAir air, in FlightPoint from, in Vector3d u, double spin, out Vector3d acceleration, out double spinRate)
        where TAir : struct, IFlightLaws
    {
        At(
            ref air, from.Branch, from.Axis.X, from.Axis.Y, from.Axis.Z, from.Upward, u.X, u.Y, u.Z, spin, out double ax, out double ay, out double az, out spinRate);
        acceleration = new Vector3d(ax, ay, az);
    }
}
