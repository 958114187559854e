namespace Football.Physics;

/// <summary>The slip velocity of the contact point, s = v_t + r n × ω; on the level pitch n is ŷ (thesis 2.19, corrected).</summary>
internal static class Slip
{
    /// <summary>Below this slip, m/s, a ball rolls.</summary>
    public const double Rolling = 1e-9;

    /// <summary>Slip velocity.</summary>
    public static Vector3d Of(in Vector3d velocity, in Vector3d spin, double radius) =>
        new(velocity.X + (radius * spin.Z), 0, velocity.Z - (radius * spin.X));

    /// <summary>The spin of a ball that rolls without slip: ω_h = ŷ × v / r.</summary>
    public static Vector3d RollingSpin(in Vector3d velocity, double aboutVertical, double radius) =>
        new(velocity.Z / radius, aboutVertical, -velocity.X / radius);

    /// <summary>Slip velocity on any surface.</summary>
    /// <param name="velocity">Velocity relative to the surface, m/s.</param>
    /// <param name="spin">Spin, rad/s.</param>
    /// <param name="normal">n.</param>
    /// <param name="radius">r, m.</param>
    public static Vector3d Of(in Vector3d velocity, in Vector3d spin, in Vector3d normal, double radius) =>
        velocity - (Vector3d.Dot(in velocity, in normal) * normal) + (radius * Vector3d.Cross(in normal, in spin));

    /// <summary>The spin of a ball that rolls on any surface: ω = n × v / r + ω_n n.</summary>
    /// <param name="velocity">Velocity relative to the surface, m/s.</param>
    /// <param name="aboutNormal">ω_n, rad/s.</param>
    /// <param name="normal">n.</param>
    /// <param name="radius">r, m.</param>
    public static Vector3d RollingSpin(in Vector3d velocity, double aboutNormal, in Vector3d normal, double radius) =>
        (Vector3d.Cross(in normal, in velocity) / radius) + (aboutNormal * normal);
}
