namespace Football.Physics;

/// <summary>The slip velocity of the contact point, s = v + r ŷ × ω (horizontal part; thesis 2.19, corrected).</summary>
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
}
