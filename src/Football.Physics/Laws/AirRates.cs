using FootballPhysics.State;

namespace FootballPhysics.Laws;

/// <summary>Evaluates the air for a spin vector, for all motions except plain flight.</summary>
internal static class AirRates
{
    /// <summary>A spin below this, in rad/s, counts as zero: its reciprocal would overflow.</summary>
    public const double NoSpin = 1e-100;

    /// <summary>Computes the factors of a = L (ω × u) − D u, ω̇ = −decay ω by the laws of drag, lift and spin decay.</summary>
    /// <param name="laws">The laws.</param>
    /// <param name="ux">The x component of the velocity relative to the air, in m/s.</param>
    /// <param name="uy">The y component of this velocity.</param>
    /// <param name="uz">The z component of this velocity.</param>
    /// <param name="wx">The x component of the spin, in rad/s.</param>
    /// <param name="wy">The y component of the spin.</param>
    /// <param name="wz">The z component of the spin.</param>
    /// <param name="branch">The branch of the drag law.</param>
    /// <param name="drag">D, 1/s.</param>
    /// <param name="lift">L.</param>
    /// <param name="decay">The decay rate, in 1/s; without spin, the angular deceleration, in rad/s².</param>
    /// <returns>|ω|.</returns>
    public static double Factors(
        AirLaws laws,
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
    {
        double rate = Math.Sqrt((wx * wx) + (wy * wy) + (wz * wz));
        rate = rate > NoSpin ? rate : 0;
        double perRate = rate > 0 ? 1.0 / rate : 0;

        // |ω̂ × u|² = |ω × u|²/|ω|²
        double x = (wy * uz) - (wz * uy);
        double y = (wz * ux) - (wx * uz);
        double z = (wx * uy) - (wy * ux);
        double acrossSquared = perRate * perRate * ((x * x) + (y * y) + (z * z));
        laws.Factors((ux * ux) + (uy * uy) + (uz * uz), rate, acrossSquared, branch, out drag, out lift, out decay);

        // Divide by the spin, for L (ω × u) and −decay ω. If there is no spin, the decay stays an angular deceleration.
        if (rate > 0)
        {
            lift *= perRate;
            decay *= perRate;
        }

        return rate;
    }
}
