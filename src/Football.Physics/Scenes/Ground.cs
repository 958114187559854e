using System.Text.Json.Serialization;

namespace Football.Physics;

/// <summary>The ground: its shape, and how the ball bounces, slides and rolls on it. Level unless it says otherwise; its numbers are those of <see cref="DryTurf"/> by default.</summary>
/// <remarks>Numbers of presets are tagged: measured (by test rigs), derived, guess (no measurement found), or the thesis'.</remarks>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public sealed record Ground
{
    /// <summary>Normal restitution e_y. 0 … 1; that at an approach of 6 m/s where <see cref="RestitutionSpeed"/> is finite. Default 0.622 (measured).</summary>
    public double NormalRestitution { get; init; } = 0.622;

    /// <summary>Approach speed V_e at which restitution has fallen, e ∝ 1/√(1 + (v_n/V_e)²), m/s. Above 0; infinite for the same at every speed; default 30 (guess, 20 … ∞).</summary>
    public double RestitutionSpeed { get; init; } = 30;

    /// <summary>
    /// Rise η of restitution with obliqueness: the share of what it lacks of 1 that a grazing impact gives back, as the ball ploughs less there,
    /// e → e + η (1 − e) c⁴/(c⁴ + 2.8⁴) with c the speed along the ground by that towards it. 0 … 1; default 0.
    /// </summary>
    public double RestitutionRise { get; init; }

    /// <summary>Tangential restitution along x, e_x. −1 … 1; default 0.2 (measured).</summary>
    public double TangentialRestitutionX { get; init; } = 0.2;

    /// <summary>Tangential restitution along z, e_z. −1 … 1; default 0.2 (measured).</summary>
    public double TangentialRestitutionZ { get; init; } = 0.2;

    /// <summary>Restitution of the spin about the vertical, e_ω. 0 … 1; default 1: it is drilling friction that takes of it.</summary>
    public double SpinRestitution { get; init; } = 1;

    /// <summary>Coefficient of friction of an impact: the tangential impulse is at most so many times the normal one. Not negative; infinite for no limit; default 1.2 (at least 0.91 derived, the value guess).</summary>
    public double ImpactFriction { get; init; } = 1.2;

    /// <summary>Coefficient of sliding friction μ_s. 0 … 10; default 0.5 (guess).</summary>
    public double SlidingFriction { get; init; } = 0.5;

    /// <summary>Coefficient of rolling friction μ_r, or c₀. 0 … 10; default 0.07 (measured, given c₁).</summary>
    public double RollingFriction { get; init; } = 0.07;

    /// <summary>Growth of rolling friction with speed, c₁, s/m. 0 … 1; default 0.006 (guess).</summary>
    public double RollingFrictionBySpeed { get; init; } = 0.006;

    /// <summary>Damping c_ω of the spin about the vertical on the ground, N m s. 0 … 1, at most 1e5 1/s times the moment of inertia; default 0: it is drilling friction that takes of it.</summary>
    public double SpinDamping { get; init; }

    /// <summary>Lever b of the drilling friction about the normal, which takes b μ_s of the normal force as torque, m. 0 … 1; default 0.02 (guess).</summary>
    public double DrillingLength { get; init; } = 0.02;

    /// <summary>A ball that leaves an impact slower than this, upwards, stays down, m/s. 0.001 … 10; default 0.2, a hop of 2 mm (guess).</summary>
    public double MinimumBounceSpeed { get; init; } = 0.2;

    /// <summary>A rolling ball with less kinetic energy than this is at rest, J. 1e-12 … 100; default 1e-4.</summary>
    public double RestEnergy { get; init; } = 1e-4;

    /// <summary>Height of the ground over the origin, m. Within ±1e6; default 0.</summary>
    public double Height { get; init; }

    /// <summary>Upward normal of a tilted plane through the origin's <see cref="Height"/>; its y above 0. Default straight up: level.</summary>
    public Vector3d Normal { get; init; } = Vector3d.Up;

    /// <summary>Uneven ground: its heights, over <see cref="Height"/>. Default null: a plane.</summary>
    public HeightField? Heights { get; init; }

    /// <summary>Parts of it that are made of something else. Default null: it is the same everywhere.</summary>
    public ISurfacePattern? Pattern { get; init; }

    /// <summary>The part of drag and Magnus force that acts on the ground. Default <see cref="GroundAerodynamics.Full"/>.</summary>
    public GroundAerodynamics Aerodynamics { get; init; } = GroundAerodynamics.Full;

    /// <summary>True when it is a level plane.</summary>
    public bool IsLevel => Heights is null && Normal.X == 0 && Normal.Z == 0;

    /// <summary>The most that an impact at 6 m/s may keep of its normal speed, however oblique.</summary>
    internal double LargestRestitution => NormalRestitution + (RestitutionRise * (1.0 - NormalRestitution));

    /// <summary>True when it is <see cref="None"/>.</summary>
    public bool IsNone => double.IsNegativeInfinity(Height);

    /// <summary>
    /// The default: dry, mown turf. Restitution 0.622, e_t 0.20 and c₀ 0.070 measured (they meet the windows of the FIFA rigs: drop 0.60 … 1.00 m,
    /// angle 45 … 60 %, roll 4 … 10 m); impact friction 1.2, at least 0.91 derived; the rest guess.
    /// </summary>
    public static Ground DryTurf { get; } = new();

    /// <summary>
    /// Artificial turf. Restitution 0.622, e_t 0.20 and c₀ 0.069 measured (windows of FIFA Quality Pro: drop 0.60 … 0.85 m, angle 45 … 60 %,
    /// roll 4 … 8 m); impact friction 1.2, at least 0.91 derived; the rest guess.
    /// </summary>
    public static Ground ArtificialTurf { get; } = new() { SlidingFriction = 0.55, RollingFriction = 0.069, RollingFrictionBySpeed = 0.008 };

    /// <summary>Watered turf: it skids. Restitution 0.570 measured (window: drop 0.60 … 1.00 m); the rest guess (impact friction 0.50 so that the ball skids at an angle of 67 %).</summary>
    public static Ground WetTurf { get; } = new()
    {
        NormalRestitution = 0.57,
        ImpactFriction = 0.5,
        SlidingFriction = 0.25,
        RollingFriction = 0.064,
        DrillingLength = 0.015,
    };

    /// <summary>
    /// The turf of a match, mown and watered, as balls bounce on it in play: restitution 0.61 at a vertical drop, rising with obliqueness to 0.8 and more (η 0.85, measured on the impacts of one
    /// minute of one match), impact friction 0.41 (likewise: 0.28 … 0.46), e_t −0.10 (likewise, of slow balls: −0.2 … 0.05). Meets the windows of the rigs for a wet natural pitch (drop 0.60 … 1.00 m, angle 45 … 80 %, roll 4 … 10 m);
    /// the rest guess.
    /// </summary>
    public static Ground MatchTurf { get; } = new()
    {
        NormalRestitution = 0.61,
        RestitutionRise = 0.85,
        TangentialRestitutionX = -0.1,
        TangentialRestitutionZ = -0.1,
        ImpactFriction = 0.41,
        SlidingFriction = 0.35,
    };

    /// <summary>Hard, dry ground: all guess (drop 1.01 m, the upper end of natural pitches).</summary>
    public static Ground HardGround { get; } = new()
    {
        NormalRestitution = 0.74,
        ImpactFriction = 0.9,
        RollingFriction = 0.04,
        RollingFrictionBySpeed = 0.002,
        DrillingLength = 0.012,
    };

    /// <summary>Long grass: all guess (roll 3.5 m, near the historical limit of 3 m).</summary>
    public static Ground LongGrass { get; } = new()
    {
        NormalRestitution = 0.5,
        TangentialRestitutionX = 0.1,
        TangentialRestitutionZ = 0.1,
        ImpactFriction = 1.3,
        SlidingFriction = 0.6,
        RollingFriction = 0.13,
        RollingFrictionBySpeed = 0.015,
        DrillingLength = 0.03,
    };

    /// <summary>An indoor court: all guess.</summary>
    public static Ground Indoor { get; } = new()
    {
        NormalRestitution = 0.77,
        ImpactFriction = 0.8,
        SlidingFriction = 0.55,
        RollingFriction = 0.015,
        RollingFrictionBySpeed = 0.001,
        DrillingLength = 0.006,
    };

    /// <summary>Concrete: restitution 0.861 measured (a test ball bounces to 1.35 ± 0.03 m from 2 m); the rest guess.</summary>
    public static Ground Concrete { get; } = new()
    {
        NormalRestitution = 0.861,
        ImpactFriction = 0.8,
        SlidingFriction = 0.6,
        RollingFriction = 0.013,
        RollingFrictionBySpeed = 0.001,
        DrillingLength = 0.005,
    };

    /// <summary>Snow: all guess.</summary>
    public static Ground Snow { get; } = new()
    {
        NormalRestitution = 0.25,
        TangentialRestitutionX = 0,
        TangentialRestitutionZ = 0,
        ImpactFriction = 0.4,
        SlidingFriction = 0.2,
        RollingFriction = 0.2,
        RollingFrictionBySpeed = 0.01,
        DrillingLength = 0.03,
    };

    /// <summary>
    /// The turf of the published profile, by its laws of contact: one restitution at every speed, no limit by friction in an impact, the horizontal part of
    /// drag and Magnus force alone. Restitution 0.6, sliding friction 0.5, rolling friction 0.05; all numbers as published.
    /// </summary>
    public static Ground PublishedTurf { get; } = new()
    {
        NormalRestitution = 0.6,
        RestitutionSpeed = double.PositiveInfinity,
        TangentialRestitutionX = 0.5,
        TangentialRestitutionZ = 0.5,
        SpinRestitution = 0.8,
        ImpactFriction = double.PositiveInfinity,
        RollingFriction = 0.05,
        RollingFrictionBySpeed = 0,
        SpinDamping = 0.002,
        DrillingLength = 0,
        Aerodynamics = GroundAerodynamics.Horizontal,
    };

    /// <summary>Wet turf by the laws of contact of <see cref="PublishedTurf"/>: restitution 0.5, half its sliding friction, rolling friction 0.035; all guess.</summary>
    public static Ground PublishedWetTurf { get; } = PublishedTurf with { NormalRestitution = 0.5, SlidingFriction = 0.25, RollingFriction = 0.035 };

    /// <summary>A hard, smooth court by the laws of contact of <see cref="PublishedTurf"/>: restitution 0.75, rolling friction 0.015; all guess.</summary>
    public static Ground PublishedCourt { get; } = PublishedTurf with { NormalRestitution = 0.75, SlidingFriction = 0.6, RollingFriction = 0.015 };

    /// <summary>Sand by the laws of contact of <see cref="PublishedTurf"/>: restitution 0.15, rolling friction 0.3; all guess.</summary>
    public static Ground PublishedSand { get; } = PublishedTurf with
    {
        NormalRestitution = 0.15,
        TangentialRestitutionX = 0,
        TangentialRestitutionZ = 0,
        SlidingFriction = 0.7,
        RollingFriction = 0.3,
    };

    /// <summary>No ground at all: the ball falls for ever.</summary>
    public static Ground None { get; } = PublishedTurf with { Height = double.NegativeInfinity };
}
