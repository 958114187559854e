namespace Football.Physics;

/// <summary>The ground: its shape, and how the ball bounces, slides and rolls on it. Level unless it says otherwise.</summary>
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
}
