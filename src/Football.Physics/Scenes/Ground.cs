using System.Text.Json.Serialization;

namespace Football.Physics;

/// <summary>The ground: its shape, and how the ball bounces, slides and rolls on it. Level unless it says otherwise.</summary>
[JsonNumberHandling(JsonNumberHandling.AllowNamedFloatingPointLiterals)]
public sealed record Ground
{
    /// <summary>Normal restitution e_y. 0 … 1; default 0.6. Where <see cref="RestitutionSpeed"/> is finite, that at 6 m/s.</summary>
    public double NormalRestitution { get; init; } = 0.6;

    /// <summary>Approach speed V_e at which restitution has fallen, e ∝ 1/√(1 + (v_n/V_e)²), m/s. Above 0; default infinite: the same at every speed.</summary>
    public double RestitutionSpeed { get; init; } = double.PositiveInfinity;

    /// <summary>Tangential restitution along x, e_x. −1 … 1; default 0.5.</summary>
    public double TangentialRestitutionX { get; init; } = 0.5;

    /// <summary>Tangential restitution along z, e_z. −1 … 1; default 0.5.</summary>
    public double TangentialRestitutionZ { get; init; } = 0.5;

    /// <summary>Restitution of the spin about the vertical, e_ω. 0 … 1; default 0.8.</summary>
    public double SpinRestitution { get; init; } = 0.8;

    /// <summary>Coefficient of friction of an impact: the tangential impulse is at most so many times the normal one. Not negative; default infinite: no limit.</summary>
    public double ImpactFriction { get; init; } = double.PositiveInfinity;

    /// <summary>Coefficient of sliding friction μ_s. 0 … 1e9; default 0.5.</summary>
    public double SlidingFriction { get; init; } = 0.5;

    /// <summary>Coefficient of rolling friction μ_r. 0 … 1e9; default 0.05.</summary>
    public double RollingFriction { get; init; } = 0.05;

    /// <summary>What rolling friction gains by speed, c₁, s/m. Not negative; default 0.</summary>
    public double RollingFrictionBySpeed { get; init; }

    /// <summary>Damping c_ω of the spin about the vertical on the ground, N m s. 0 … 1e12; default 0.002.</summary>
    public double SpinDamping { get; init; } = 0.002;

    /// <summary>Lever b of the drilling friction about the normal, which takes b μ_s of the normal force as torque, m. Not negative; default 0.</summary>
    public double DrillingLength { get; init; }

    /// <summary>A ball that leaves an impact slower than this, upwards, stays down, m/s. 0.001 … 1e12; default 0.2.</summary>
    public double MinimumBounceSpeed { get; init; } = 0.2;

    /// <summary>A rolling ball with less kinetic energy than this is at rest, J. Above 0; default 1e-4.</summary>
    public double RestEnergy { get; init; } = 1e-4;

    /// <summary>Height of the ground over the origin, m. Within ±1e6; default 0.</summary>
    public double Height { get; init; }

    /// <summary>Upward normal of a tilted plane through the origin's <see cref="Height"/>; its y above 0. Default straight up: level.</summary>
    public Vector3d Normal { get; init; } = Vector3d.Up;

    /// <summary>Uneven ground: its heights, over <see cref="Height"/>. Default null: a plane.</summary>
    public HeightField? Heights { get; init; }

    /// <summary>What is left of drag and Magnus force on the ground. Default <see cref="GroundAerodynamics.Horizontal"/>.</summary>
    public GroundAerodynamics Aerodynamics { get; init; } = GroundAerodynamics.Horizontal;

    /// <summary>Whether it is a level plane.</summary>
    public bool IsLevel => Heights is null && Normal.X == 0 && Normal.Z == 0;

    /// <summary>No ground at all: the ball falls for ever.</summary>
    public static Ground None { get; } = new() { Height = double.NegativeInfinity };

    /// <summary>Whether it is <see cref="None"/>.</summary>
    public bool IsNone => double.IsNegativeInfinity(Height);

    /// <summary>The default: dry, mown turf.</summary>
    public static Ground Turf { get; } = new();

    /// <summary>Wet turf: lower bounce, half the sliding friction, a faster roll.</summary>
    public static Ground WetTurf { get; } = new() { NormalRestitution = 0.5, SlidingFriction = 0.25, RollingFriction = 0.035 };

    /// <summary>A hard, smooth court: high bounce, little rolling friction.</summary>
    public static Ground Court { get; } = new() { NormalRestitution = 0.75, SlidingFriction = 0.6, RollingFriction = 0.015 };

    /// <summary>Sand: hardly a bounce, and a short roll.</summary>
    public static Ground Sand { get; } = new() { NormalRestitution = 0.15, TangentialRestitutionX = 0, TangentialRestitutionZ = 0, SlidingFriction = 0.7, RollingFriction = 0.3 };

    /// <summary>What all surfaces of the measured profile share: V_e 30 m/s (guess), all of the air's force, no damping but drilling friction.</summary>
    private static Ground Measured { get; } = new()
    {
        RestitutionSpeed = 30,
        SpinRestitution = 1,
        SpinDamping = 0,
        Aerodynamics = GroundAerodynamics.Full,
    };

    /// <summary>Dry turf, measured profile. Evidence: e₆, e_t and c₀ measured (they meet the windows of the FIFA rigs: drop 0.60 … 1.00 m, angle 45 … 60 %, roll 4 … 10 m); impact friction at least 0.91 derived; the rest guess.</summary>
    public static Ground DryTurf { get; } = Measured with
    {
        NormalRestitution = 0.622,
        TangentialRestitutionX = 0.2,
        TangentialRestitutionZ = 0.2,
        ImpactFriction = 1.2,
        SlidingFriction = 0.5,
        RollingFriction = 0.07,
        RollingFrictionBySpeed = 0.006,
        DrillingLength = 0.02,
    };

    /// <summary>Artificial turf, measured profile. Evidence: e₆, e_t and c₀ measured (windows of FIFA Quality Pro: drop 0.60 … 0.85 m, angle 45 … 60 %, roll 4 … 8 m); the rest guess.</summary>
    public static Ground ArtificialTurf { get; } = Measured with
    {
        NormalRestitution = 0.622,
        TangentialRestitutionX = 0.2,
        TangentialRestitutionZ = 0.2,
        ImpactFriction = 1.2,
        SlidingFriction = 0.55,
        RollingFriction = 0.069,
        RollingFrictionBySpeed = 0.008,
        DrillingLength = 0.02,
    };

    /// <summary>Wet turf: it skids, measured profile. Evidence: drop measured (window 0.60 … 1.00 m); the rest guess.</summary>
    public static Ground WateredTurf { get; } = Measured with
    {
        NormalRestitution = 0.57,
        TangentialRestitutionX = 0.2,
        TangentialRestitutionZ = 0.2,
        ImpactFriction = 0.5,
        SlidingFriction = 0.25,
        RollingFriction = 0.064,
        RollingFrictionBySpeed = 0.006,
        DrillingLength = 0.015,
    };

    /// <summary>Hard, dry ground, measured profile. Evidence: guess (drop 1.01 m: the upper end of natural pitches).</summary>
    public static Ground HardGround { get; } = Measured with
    {
        NormalRestitution = 0.74,
        TangentialRestitutionX = 0.2,
        TangentialRestitutionZ = 0.2,
        ImpactFriction = 0.9,
        SlidingFriction = 0.5,
        RollingFriction = 0.04,
        RollingFrictionBySpeed = 0.002,
        DrillingLength = 0.012,
    };

    /// <summary>Long grass, measured profile. Evidence: guess (roll 3.5 m: near the historical limit of 3 m).</summary>
    public static Ground LongGrass { get; } = Measured with
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

    /// <summary>An indoor court, measured profile. Evidence: guess.</summary>
    public static Ground Indoor { get; } = Measured with
    {
        NormalRestitution = 0.77,
        TangentialRestitutionX = 0.2,
        TangentialRestitutionZ = 0.2,
        ImpactFriction = 0.8,
        SlidingFriction = 0.55,
        RollingFriction = 0.015,
        RollingFrictionBySpeed = 0.001,
        DrillingLength = 0.006,
    };

    /// <summary>Concrete, measured profile. Evidence: e₆ measured (a test ball bounces to 1.35 ± 0.03 m from 2 m); the rest guess.</summary>
    public static Ground Concrete { get; } = Measured with
    {
        NormalRestitution = 0.861,
        TangentialRestitutionX = 0.2,
        TangentialRestitutionZ = 0.2,
        ImpactFriction = 0.8,
        SlidingFriction = 0.6,
        RollingFriction = 0.013,
        RollingFrictionBySpeed = 0.001,
        DrillingLength = 0.005,
    };

    /// <summary>Snow, measured profile. Evidence: guess.</summary>
    public static Ground Snow { get; } = Measured with
    {
        NormalRestitution = 0.25,
        TangentialRestitutionX = 0.0,
        TangentialRestitutionZ = 0.0,
        ImpactFriction = 0.4,
        SlidingFriction = 0.2,
        RollingFriction = 0.2,
        RollingFrictionBySpeed = 0.01,
        DrillingLength = 0.03,
    };
}
