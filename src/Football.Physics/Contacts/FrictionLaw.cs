using System.Runtime.CompilerServices;

namespace FootballPhysics.Contacts;

/// <summary>Coulomb's limit of friction, for impulses and forces.</summary>
internal static class FrictionLaw
{
    /// <summary>Returns the greatest friction of a contact, μ N. Without a load it is zero, also if μ is infinite.</summary>
    /// <remarks>An infinite μ means that the surfaces stick: no load limits the friction, but a contact without a load has none.</remarks>
    /// <param name="friction">μ; 0 … ∞.</param>
    /// <param name="load">N or J_n; not negative.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double Limit(double friction, double load) => load > 0 ? friction * load : 0;
}

/// <summary>How a surface resists the motion of a ball in sustained contact: sliding friction, rolling resistance, and friction and damping about the
/// normal.</summary>
/// <remarks>The limits are forces or impulses, as is the load.</remarks>
/// <param name="sliding">μ_s.</param>
/// <param name="rolling">μ_r or c₀.</param>
/// <param name="rollingBySpeed">c₁, s/m.</param>
/// <param name="damping">c_ω, N m s.</param>
/// <param name="patch">b, m.</param>
internal readonly struct Resistance(double sliding, double rolling, double rollingBySpeed, double damping, double patch)
{
    /// <summary>μ_s.</summary>
    public readonly double Sliding = sliding;

    /// <summary>μ_r or c₀.</summary>
    public readonly double Rolling = rolling;

    /// <summary>c₁, s/m.</summary>
    public readonly double RollingBySpeed = rollingBySpeed;

    /// <summary>c_ω, N m s.</summary>
    public readonly double Damping = damping;

    /// <summary>b, m.</summary>
    public readonly double Patch = patch;

    /// <summary>b μ_s, m; 0 if b is 0 and μ_s infinite.</summary>
    public double Drilling => Patch > 0 ? Patch * Sliding : 0;

    /// <summary>The larger of μ_s and c₀.</summary>
    public double Largest => Math.Max(Sliding, Rolling);

    /// <summary>True if it ends a slip.</summary>
    public bool Rubs => Sliding > 0;

    /// <summary>True if it ends a spin about the normal.</summary>
    public bool Drills => Drilling > 0;

    /// <summary>Returns the greatest friction, μ_s N.</summary>
    public double MostFriction(double load) => FrictionLaw.Limit(Sliding, load);

    /// <summary>Returns the rolling resistance, (c₀ + c₁ |v|) N.</summary>
    public double MostRolling(double load, double speed) => (Rolling + (RollingBySpeed * speed)) * load;

    /// <summary>Returns the greatest torque about the normal, b μ_s N.</summary>
    public double MostDrilling(double load) => FrictionLaw.Limit(Drilling, load);
}
