using System.Text.Json.Serialization;

namespace FootballPhysics;

/// <summary>A material: how the ball bounces off it, slides on it and rolls on it. The pitch and every object have one. The default numbers are those of <see cref="MatchTurf"/>.</summary>
/// <remarks><see cref="Presets"/> lists the presets by name. Each preset states its evidence: measured, derived, guess (no measurement found), or published (the thesis).</remarks>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public sealed partial record SurfaceMaterial
{
    /// <summary>Normal restitution e at an approach speed of 6 m/s. 0 … 3, at most 1 for the ground and between balls; above 1 the object is a bumper, which adds energy; default 0.67.</summary>
    public double NormalRestitution { get; init; } = 0.67;

    /// <summary>Approach speed V_e at which the restitution falls, m/s: e ∝ 1/√(1 + (v_n/V_e)²). Above 0; infinite: the same at every speed; default 20.</summary>
    public double RestitutionSpeedScale { get; init; } = 20;

    /// <summary>Rise η of the restitution of oblique impacts. 0 … 1; default 0.45.</summary>
    /// <remarks>A grazing ball ploughs less: e → e + η (1 − e) c⁴/(c⁴ + 2.8⁴), where c is the speed along the surface divided by the approach speed.</remarks>
    public double GrazingRestitutionGain { get; init; } = 0.45;

    /// <summary>Tangential restitution e_t: a contact that grips turns the slip into −e_t times the slip. −1 … 1; default −0.15.</summary>
    public double TangentialRestitution { get; init; } = -0.15;

    /// <summary>Restitution of the spin about the normal, e_ω. 0 … 1; default 1.</summary>
    public double SpinRestitution { get; init; } = 1;

    /// <summary>Coefficient of friction of an impact, μ_i: the tangential impulse is at most μ_i times the normal impulse. 0 or more; infinite: no limit; default 0.42.</summary>
    public double ImpactFriction { get; init; } = 0.42;

    /// <summary>Coefficient of sliding friction μ_s. 0 … 10; default 0.45.</summary>
    public double SlidingFriction { get; init; } = 0.45;

    /// <summary>Coefficient of rolling friction at rest, c₀. 0 … 10; default 0.064.</summary>
    public double RollingResistance { get; init; } = 0.064;

    /// <summary>Growth of the rolling friction with speed, c₁, s/m. 0 … 1; default 0.003.</summary>
    public double RollingResistancePerSpeed { get; init; } = 0.003;

    /// <summary>Damping c_ω of the spin about the normal while the surface carries the ball, N m s. 0 … 1, at most 1e5 1/s times the moment of inertia; default 0.</summary>
    public double SpinDamping { get; init; }

    /// <summary>Lever b of the drilling friction about the normal, m: its torque is b μ_s times the normal force. 0 … 1; default 0.02.</summary>
    public double TorsionalPatchRadius { get; init; } = 0.02;

    /// <summary>The least speed at which the ball leaves an impact along the normal, relative to the surface, m/s: the bumper of a pinball. 0 … 1000, 0 for the ground and between balls; default 0.</summary>
    /// <remarks>A ball that lands on top of the object with less than <see cref="Ground.MinimumBounceSpeed"/> stays down.</remarks>
    public double MinimumExitSpeed { get; init; }

    /// <summary>Checks every number.</summary>
    /// <param name="field">Name of the surface in messages.</param>
    /// <param name="mostDamping">The largest damping of a spin of the ball, N m s.</param>
    /// <param name="mayAdd">Whether the surface may add energy: objects may, balls and the ground may not.</param>
    /// <exception cref="ArgumentOutOfRangeException">A number is out of range.</exception>
    internal void Validate(string field, double mostDamping = 1, bool mayAdd = true)
    {
        SceneFields.Check(SceneFields.Material, this, field + ".");
        if (!mayAdd)
        {
            Check.Within(field + ".normalRestitution", NormalRestitution, 0, 1);
            Check.Within(field + ".minimumExitSpeed", MinimumExitSpeed, 0, 0);
        }

        // The damping is also limited by the ball's moment of inertia.
        Check.Within(field + ".spinDamping", SpinDamping, 0, mostDamping);
    }
}
