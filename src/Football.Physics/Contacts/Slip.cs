namespace FootballPhysics.Contacts;

/// <summary>The slip velocity of the contact point, s = v_t + r n × ω; on the level pitch n is ŷ (thesis 2.19, corrected).</summary>
internal static class Slip
{
    /// <summary>Returns the spin of a ball that rolls without slip: ω_h = ŷ × v / r.</summary>
    public static Vector3d RollingSpin(in Vector3d velocity, double aboutVertical, double radius) =>
        new(velocity.Z / radius, aboutVertical, -velocity.X / radius);

    /// <summary>Returns the slip velocity on any surface.</summary>
    /// <param name="velocity">Velocity relative to the surface, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <param name="normal">n.</param>
    /// <param name="radius">r, m.</param>
    public static Vector3d Of(in Vector3d velocity, in Vector3d spin, in Vector3d normal, double radius) =>
        velocity - (Vector3d.Dot(in velocity, in normal) * normal) + (radius * Vector3d.Cross(in normal, in spin));

    /// <summary>Returns the spin of a ball that rolls on any surface: ω = n × v / r + ω_n n.</summary>
    /// <param name="velocity">Velocity relative to the surface, m/s.</param>
    /// <param name="aboutNormal">ω_n, rad/s.</param>
    /// <param name="normal">n.</param>
    /// <param name="radius">r, m.</param>
    public static Vector3d RollingSpin(in Vector3d velocity, double aboutNormal, in Vector3d normal, double radius) =>
        (Vector3d.Cross(in normal, in velocity) / radius) + (aboutNormal * normal);
}

/// <summary>The end of a slide in closed form.</summary>
/// <remarks>
/// With a constant push c on the slip, ṡ = −k ŝ + c has two integrals, however the slip turns: k|s| + c·s falls at the rate k² − |c|²,
/// and ∫ŝ dt = (s₀ − s + c t)/k.
/// </remarks>
internal readonly struct SlipDecay
{
    /// <summary>Time at which the slip ends, s.</summary>
    public readonly double Time;

    /// <summary>k² − |c|², m²/s⁴: the rate at which the slip loses k|s| + c·s.</summary>
    public readonly double Left;

    /// <summary>∫ŝ dt up to then, s.</summary>
    public readonly Vector3d Direction;

    /// <summary>∫∫ŝ dt² up to then, s².</summary>
    public readonly Vector3d Twice;

    /// <param name="slip">s₀, m/s.</param>
    /// <param name="push">c, m/s²; smaller than k.</param>
    /// <param name="k">Deceleration of the slip by friction, (1 + 1/α) μ_s N/m, m/s².</param>
    public SlipDecay(in Vector3d slip, in Vector3d push, double k)
    {
        double size = slip.Length;
        double c = push.Length;

        // The slip s, its direction ŝ, friction k and a constant push c: ṡ = c − k ŝ.
        // k|s| + c·s decreases at the rate k² − |c|² to zero at the end, where ∫ŝ = (s₀ + c t)/k.
        Left = (k * k) - (c * c);
        Time = ((k * size) + Vector3d.Dot(in slip, in push)) / Left;
        Direction = (slip + (Time * push)) / k;

        // Compute ∫s dt. Along c, use d|s|²/dt = 2(−k|s| + c·s). Across c, use d(|s| s⊥)/dt and d(s∥ s⊥)/dt.
        Vector3d area = 0.5 * Time * slip;
        if (c > 1e-3 * k)
        {
            Vector3d along = push / c;
            double alongSlip = Vector3d.Dot(in slip, in along);
            double alongArea = 0.5 * ((0.5 * Left * Time * Time) - (0.5 * size * size)) / c;
            Vector3d across = slip - (alongSlip * along);
            area = (alongArea * along) + (((2.0 * k * size) + (c * alongSlip)) / ((4.0 * k * k) - (c * c)) * across);
        }

        // ∫∫ŝ = (s₀ t − ∫s + c t²/2)/k.
        Twice = ((Time * slip) - area + ((0.5 * Time * Time) * push)) / k;
    }
}
