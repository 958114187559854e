using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The air for a spin vector: what any motion but plain flight asks.</summary>
internal static class AirRates
{
    /// <summary>Below this, rad/s, there is no spin: a reciprocal of it would overflow.</summary>
    public const double NoSpin = 1e-100;

    /// <summary>The factors of a = L (ω × u) − D u, ω̇ = −decay ω, by the laws of drag, lift and spin decay.</summary>
    /// <param name="air">The air.</param>
    /// <param name="ux">Velocity relative to the air, x, m/s.</param>
    /// <param name="uy">The same, y.</param>
    /// <param name="uz">The same, z.</param>
    /// <param name="wx">Spin, x, rad/s.</param>
    /// <param name="wy">The same, y.</param>
    /// <param name="wz">The same, z.</param>
    /// <param name="branch">Branch of the drag law.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L.</param>
    /// <param name="decay">1/s; without spin the angular deceleration itself, rad/s².</param>
    /// <returns>|ω|.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Factors<TAir>(
        ref TAir air,
        double ux,
        double uy,
        double uz,
        double wx,
        double wy,
        double wz,
        DragBranch branch,
        out double drag,
        out double lift,
        out double decay)
        where TAir : struct, IAir
    {
        double rate = Math.Sqrt((wx * wx) + (wy * wy) + (wz * wz));
        rate = rate > NoSpin ? rate : 0;
        drag = 0;
        lift = 0;
        decay = 0;
        if (air.Drags || air.Lifts || air.SpinDecays)
        {
            double perRate = rate > 0 ? 1.0 / rate : 0;
            double x = (wy * uz) - (wz * uy);
            double y = (wz * ux) - (wx * uz);
            double z = (wx * uy) - (wy * ux);
            double acrossSquared = perRate * perRate * ((x * x) + (y * y) + (z * z));
            air.Begin(rate, branch, out PointStep step);
            air.AtStart(ref step, (ux * ux) + (uy * uy) + (uz * uz), rate, acrossSquared, out drag, out lift, out decay);
            if (rate > 0)
            {
                lift *= perRate;
                decay *= perRate;
            }
        }

        return rate;
    }

    /// <summary>What air that does not vary does at one instant.</summary>
    /// <returns>|ω|.</returns>
    public static double Evaluate<TAir>(ref TAir air, in ForceInput ball, DragBranch branch, out AirFactors factors)
        where TAir : struct, IAir
    {
        Vector3d u = ball.AirVelocity;
        Vector3d w = ball.Spin;
        factors.AirVelocity = u;
        factors.AirSpeed = 0;
        factors.Acceleration = Vector3d.Zero;
        factors.SpinAcceleration = Vector3d.Zero;
        return Factors(ref air, u.X, u.Y, u.Z, w.X, w.Y, w.Z, branch, out factors.Drag, out factors.Lift, out factors.Decay);
    }
}
