using System.Text.Json.Serialization;
using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>A material: how the ball bounces off it, slides on it and rolls on it.</summary>
/// <remarks>
/// The pitch and every object have a material. The default numbers are those of <see cref="MatchTurf"/>; <see cref="Presets"/> lists the presets by name.
/// Each preset states its evidence: measured, derived, guess (no measurement found), or published (the thesis).
/// </remarks>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public sealed partial record SurfaceMaterial
{
    /// <summary>The normal restitution e at an approach speed of 6 m/s. 0 … 3; default 0.67.</summary>
    /// <remarks>At most 1 for the ground and between balls. Above 1 the object is a bumper, which adds energy.</remarks>
    public double NormalRestitution { get; init; } = 0.67;

    /// <summary>The approach speed V_e above which the restitution falls, in m/s: e ∝ 1/√(1 + (v_n/V_e)²).</summary>
    /// <remarks>Above 0; default 20. If infinite, the restitution is the same at every speed.</remarks>
    public double RestitutionSpeedScale { get; init; } = 20;

    /// <summary>The increase η of the restitution for oblique impacts. 0 … 1; default 0.45.</summary>
    /// <remarks>A grazing ball ploughs less: e → e + η (1 − e) c⁴/(c⁴ + 2.8⁴). Here c is the speed along the surface divided by the approach speed.</remarks>
    public double GrazingRestitutionGain { get; init; } = 0.45;

    /// <summary>The tangential restitution e_t: a contact that grips multiplies the slip by −e_t. −1 … 1; default −0.15.</summary>
    public double TangentialRestitution { get; init; } = -0.15;

    /// <summary>The restitution of the spin about the normal, e_ω. 0 … 1; default 1.</summary>
    public double SpinRestitution { get; init; } = 1;

    /// <summary>The coefficient of friction in an impact, μ_i. At least 0; default 0.42.</summary>
    /// <remarks>The tangential impulse is at most μ_i times the normal impulse. If infinite, there is no limit.</remarks>
    public double ImpactFriction { get; init; } = 0.42;

    /// <summary>The coefficient of sliding friction μ_s. 0 … 10; default 0.45.</summary>
    public double SlidingFriction { get; init; } = 0.45;

    /// <summary>The coefficient of rolling friction at zero speed, c₀. 0 … 10; default 0.064.</summary>
    public double RollingResistance { get; init; } = 0.064;

    /// <summary>The growth of the rolling friction with speed, c₁, in s/m. 0 … 1; default 0.003.</summary>
    public double RollingResistancePerSpeed { get; init; } = 0.003;

    /// <summary>The damping c_ω of the spin about the normal while the surface supports the ball, in N m s.</summary>
    /// <remarks>0 … 1, and at most the moment of inertia times 1e5/s; default 0.</remarks>
    public double SpinDamping { get; init; }

    /// <summary>The lever arm b of the drilling friction about the normal, in m. 0 … 1; default 0.02.</summary>
    /// <remarks>The torque is b μ_s times the normal force.</remarks>
    public double TorsionalPatchRadius { get; init; } = 0.02;

    /// <summary>The minimum rebound speed along the normal, in m/s; above 0 for a pinball bumper.</summary>
    /// <remarks>
    /// The speed is relative to the surface. 0 … 1000; always 0 for the ground and between balls; default 0. A ball that lands on top of the object with less
    /// than <see cref="Ground.MinimumBounceSpeed"/> stays there.
    /// </remarks>
    public double MinimumExitSpeed { get; init; }

    /// <summary>Checks every number.</summary>
    /// <param name="field">The name of the surface in messages.</param>
    /// <param name="mostDamping">The maximum damping of the ball's spin, in N m s.</param>
    /// <param name="mayAdd">True if the surface may add energy: objects may, balls and the ground may not.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    internal void Validate(string field, double mostDamping = 1, bool mayAdd = true)
    {
        SceneFields.Check(SceneFields.Material, this, field + ".");
        if (!mayAdd)
        {
            Check.Within(field + ".normalRestitution", NormalRestitution, 0, 1);
            Check.Within(field + ".minimumExitSpeed", MinimumExitSpeed, 0, 0);
        }

        // The ball's moment of inertia limits the damping further.
        Check.Within(field + ".spinDamping", SpinDamping, 0, mostDamping);
    }
}
