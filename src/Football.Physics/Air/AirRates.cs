using System.Runtime.CompilerServices;

namespace Football.Physics;

/// <summary>The aerodynamic laws for a spin vector: what the general systems share.</summary>
internal static class AirRates
{
    /// <summary>Below this, rad/s, there is no spin: a reciprocal of it would overflow.</summary>
    private const double NoSpin = 1e-100;

    /// <summary>The factors of a = L (ω × u) − D u, ω̇ = −decay ω.</summary>
    /// <param name="air">The laws.</param>
    /// <param name="u">Velocity relative to the air, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <param name="branch">Branch of the drag law.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L.</param>
    /// <param name="decay">1/s; without spin the angular deceleration itself, rad/s².</param>
    /// <returns>|ω|.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Factors<TAir>(
        ref TAir air, in Vector3d u, in Vector3d spin, DragBranch branch, out double drag, out double lift, out double decay)
        where TAir : struct, IAerodynamics
    {
        double rate = Math.Sqrt((spin.X * spin.X) + (spin.Y * spin.Y) + (spin.Z * spin.Z));
        rate = rate > NoSpin ? rate : 0;
        drag = 0;
        lift = 0;
        decay = 0;
        if (air.Drags || air.Lifts || air.SpinDecays)
        {
            air.Begin(rate, branch, out AirStep step);
            double acrossSquared = air.NeedsSpinAcross && rate > 0 ? Vector3d.Cross((1.0 / rate) * spin, in u).LengthSquared : 0;
            air.Evaluate(in step, (u.X * u.X) + (u.Y * u.Y) + (u.Z * u.Z), rate, acrossSquared, out drag, out lift, out decay);
            if (rate > 0)
            {
                double perRate = 1.0 / rate;
                lift *= perRate;
                decay *= perRate;
            }
        }

        return rate;
    }
}
