using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The right-hand side in flight, m v̇ = F_G + F_B + F_D + F_M and I ω̇ = T_D, along a constant axis of the spin.</summary>
internal static class FlightRates
{
    /// <summary>The rates at a step's start.</summary>
    /// <param name="kernel">The air's factors.</param>
    /// <param name="once">What they keep for the step.</param>
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
    public static void AtStart<TKernel, TStep>(
        ref TKernel kernel,
        ref TStep once,
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
        where TKernel : struct, IFlightKernel<TStep>
        where TStep : struct
    {
        double drag = 0;
        double lift = 0;
        double decay = 0;
        if (kernel.Drags || kernel.Lifts || kernel.SpinDecays)
        {
            double acrossSquared = AcrossSquared(nx, ny, nz, ux, uy, uz);
            kernel.AtStart(ref once, (ux * ux) + (uy * uy) + (uz * uz), spin, acrossSquared, out drag, out lift, out decay);
        }

        Combine<TKernel, TStep>(ref kernel, nx, ny, nz, upward, ux, uy, uz, spin, drag, lift, decay, out ax, out ay, out az, out spinRate);
    }

    /// <summary>Tells the air's factors how far the later stages of a step go.</summary>
    /// <param name="kernel">The air's factors.</param>
    /// <param name="once">What they keep for the step.</param>
    /// <param name="ux">Air-relative velocity at the start, x.</param>
    /// <param name="uy">Air-relative velocity at the start, y.</param>
    /// <param name="uz">Air-relative velocity at the start, z.</param>
    /// <param name="ax">Acceleration there, x.</param>
    /// <param name="ay">Acceleration there, y.</param>
    /// <param name="az">Acceleration there, z.</param>
    /// <param name="spinRate">Rate of change of the spin there.</param>
    /// <param name="h">How far ahead the last stage is, s.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Expand<TKernel, TStep>(
        ref TKernel kernel, ref TStep once, double ux, double uy, double uz, double ax, double ay, double az, double spinRate, double h)
        where TKernel : struct, IFlightKernel<TStep>
        where TStep : struct
    {
        // |u + h a|² − |u|² = 2 h u·a + h² a²
        double along = Math.Abs((ux * ax) + (uy * ay) + (uz * az));
        double change = h * (along + along + (h * ((ax * ax) + (ay * ay) + (az * az))));
        kernel.Expand(ref once, change, h * Math.Abs(spinRate));
    }

    /// <summary>The rates at a later stage of a step.</summary>
    /// <inheritdoc cref="AtStart{TKernel, TStep}"/>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void AtStage<TKernel, TStep>(
        ref TKernel kernel,
        in TStep once,
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
        where TKernel : struct, IFlightKernel<TStep>
        where TStep : struct
    {
        double drag = 0;
        double lift = 0;
        double decay = 0;
        if (kernel.Drags || kernel.Lifts || kernel.SpinDecays)
        {
            double acrossSquared = AcrossSquared(nx, ny, nz, ux, uy, uz);
            kernel.AtStage(in once, (ux * ux) + (uy * uy) + (uz * uz), spin, acrossSquared, out drag, out lift, out decay);
        }

        Combine<TKernel, TStep>(ref kernel, nx, ny, nz, upward, ux, uy, uz, spin, drag, lift, decay, out ax, out ay, out az, out spinRate);
    }

    /// <summary>|ω̂ × u|²; where the air does not ask for it, no code remains of it.</summary>
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
    private static void Combine<TKernel, TStep>(
        ref TKernel kernel,
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
        where TKernel : struct, IFlightKernel<TStep>
        where TStep : struct
    {
        ax = 0;
        ay = upward;
        az = 0;
        if (kernel.Lifts && kernel.Drags)
        {
            ax = (lift * ((ny * uz) - (nz * uy))) - (drag * ux);
            ay = ((lift * ((nz * ux) - (nx * uz))) - (drag * uy)) + upward;
            az = (lift * ((nx * uy) - (ny * ux))) - (drag * uz);
        }
        else if (kernel.Lifts)
        {
            ax = lift * ((ny * uz) - (nz * uy));
            ay = (lift * ((nz * ux) - (nx * uz))) + upward;
            az = lift * ((nx * uy) - (ny * ux));
        }
        else if (kernel.Drags)
        {
            ax = -(drag * ux);
            ay = upward - (drag * uy);
            az = -(drag * uz);
        }

        // A ball without spin stays without.
        spinRate = kernel.SpinDecays && spin != 0 ? -decay : 0;
    }

    /// <summary>The rates at a point by itself.</summary>
    public static void Of<TKernel, TStep>(
        ref TKernel kernel, in FlightPoint from, in Vector3d u, double spin, out Vector3d acceleration, out double spinRate)
        where TKernel : struct, IFlightKernel<TStep>
        where TStep : struct
    {
        kernel.Begin(spin, from.Branch, out TStep once);
        AtStart(
            ref kernel, ref once, from.Axis.X, from.Axis.Y, from.Axis.Z, from.Upward, u.X, u.Y, u.Z, spin, out double ax, out double ay, out double az, out spinRate);
        acceleration = new Vector3d(ax, ay, az);
    }
}
