using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The right-hand side in flight, m v̇ = F_G + F_B + F_D + F_M and I ω̇ = T_D, along a constant axis.</summary>
internal static class FlightRates
{
    /// <summary>The rates at a step's start.</summary>
    /// <param name="air">The aerodynamic laws.</param>
    /// <param name="once">What they compute once for the step.</param>
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
    public static void AtStart<TAir>(
        ref TAir air,
        ref AirStep once,
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
        double drag = 0;
        double lift = 0;
        double decay = 0;
        if (air.Drags || air.Lifts || air.SpinDecays)
        {
            double acrossSquared = air.NeedsSpinAcross ? AcrossSquared(nx, ny, nz, ux, uy, uz) : 0;
            air.EvaluateStart(ref once, (ux * ux) + (uy * uy) + (uz * uz), spin, acrossSquared, out drag, out lift, out decay);
        }

        Combine(ref air, nx, ny, nz, upward, ux, uy, uz, spin, drag, lift, decay, out ax, out ay, out az, out spinRate);
    }

    /// <summary>Whether the laws are series about the step's start for its other stages, and which.</summary>
    /// <param name="air">The aerodynamic laws.</param>
    /// <param name="once">What they computed at the start.</param>
    /// <param name="ux">Air-relative velocity at the start, x.</param>
    /// <param name="uy">Air-relative velocity at the start, y.</param>
    /// <param name="uz">Air-relative velocity at the start, z.</param>
    /// <param name="ax">Acceleration there, x.</param>
    /// <param name="ay">Acceleration there, y.</param>
    /// <param name="az">Acceleration there, z.</param>
    /// <param name="spinRate">Rate of change of the spin there.</param>
    /// <param name="h">How far ahead the last stage is, s.</param>
    /// <param name="series">The series.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool Expand<TAir>(
        ref TAir air,
        in AirStep once,
        double ux,
        double uy,
        double uz,
        double ax,
        double ay,
        double az,
        double spinRate,
        double h,
        out AirSeries series)
        where TAir : struct, IAerodynamics
    {
        // |u + h a|² − |u|² = 2 h u·a + h² a²
        double along = Math.Abs((ux * ax) + (uy * ay) + (uz * az));
        double change = h * (along + along + (h * ((ax * ax) + (ay * ay) + (az * az))));
        return air.Expand(in once, change, h * Math.Abs(spinRate), out series);
    }

    /// <summary>The rates at another stage of a step.</summary>
    /// <param name="air">The aerodynamic laws.</param>
    /// <param name="once">What they computed once for the step.</param>
    /// <param name="near">Whether the laws are series.</param>
    /// <param name="series">The series, if they are.</param>
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
    public static void AtStage<TAir>(
        ref TAir air,
        in AirStep once,
        bool near,
        in AirSeries series,
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
        double drag = 0;
        double lift = 0;
        double decay = 0;
        if (air.Drags || air.Lifts || air.SpinDecays)
        {
            double speedSquared = (ux * ux) + (uy * uy) + (uz * uz);
            if (near)
            {
                air.EvaluateNear(in series, speedSquared, spin, out drag, out lift, out decay);
            }
            else
            {
                double acrossSquared = air.NeedsSpinAcross ? AcrossSquared(nx, ny, nz, ux, uy, uz) : 0;
                air.Evaluate(in once, speedSquared, spin, acrossSquared, out drag, out lift, out decay);
            }
        }

        Combine(ref air, nx, ny, nz, upward, ux, uy, uz, spin, drag, lift, decay, out ax, out ay, out az, out spinRate);
    }

    /// <summary>|ω̂ × u|².</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double AcrossSquared(double nx, double ny, double nz, double ux, double uy, double uz)
    {
        double x = (ny * uz) - (nz * uy);
        double y = (nz * ux) - (nx * uz);
        double z = (nx * uy) - (ny * ux);
        return (x * x) + (y * y) + (z * z);
    }

    /// <summary>a = L (ω̂ × u) − D u + g, ω̇ = −decay.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Combine<TAir>(
        ref TAir air,
        double nx,
        double ny,
        double nz,
        double upward,
        double ux,
        double uy,
        double uz,
        double spin,
        double drag,
        double lift,
        double decay,
        out double ax,
        out double ay,
        out double az,
        out double spinRate)
        where TAir : struct, IAerodynamics
    {
        ax = 0;
        ay = upward;
        az = 0;
        if (air.Lifts && air.Drags)
        {
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

        // A ball without spin stays without.
        spinRate = air.SpinDecays && spin != 0 ? -decay : 0;
    }

    /// <summary>The rates at a point by itself.</summary>
    public static void Of<TAir>(ref TAir air, in FlightPoint from, in Vector3d u, double spin, out Vector3d acceleration, out double spinRate)
        where TAir : struct, IAerodynamics
    {
        air.Begin(spin, from.Branch, out AirStep once);
        AtStart(ref air, ref once, from.Axis.X, from.Axis.Y, from.Axis.Z, from.Upward, u.X, u.Y, u.Z, spin, out double ax, out double ay, out double az, out spinRate);
        acceleration = new Vector3d(ax, ay, az);
    }
}
