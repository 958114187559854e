namespace FootballPhysics;

/// <summary>The air for a spin vector: what any motion but plain flight asks.</summary>
internal static class AirRates
{
    /// <summary>Below this, rad/s, there is no spin: a reciprocal of it would overflow.</summary>
    public const double NoSpin = 1e-100;

    /// <summary>The factors of a = L (ω × u) − D u, ω̇ = −decay ω, by the laws of drag, lift and spin decay.</summary>
    /// <param name="laws">The laws.</param>
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

        // Per unit of spin, for L (ω × u) and −decay ω; without spin the decay is an angular deceleration.
        if (rate > 0)
        {
            lift *= perRate;
            decay *= perRate;
        }

        return rate;
    }
}
