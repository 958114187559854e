namespace Football.Physics;

/// <summary>The flat ground: how the ball bounces, slides and rolls on it.</summary>
public sealed record Ground
{
    /// <summary>Normal restitution e_y. 0 … 1; default 0.6.</summary>
    public double NormalRestitution { get; init; } = 0.6;

    /// <summary>Tangential restitution along x, e_x. −1 … 1; default 0.5.</summary>
    public double TangentialRestitutionX { get; init; } = 0.5;

    /// <summary>Tangential restitution along z, e_z. −1 … 1; default 0.5.</summary>
    public double TangentialRestitutionZ { get; init; } = 0.5;

    /// <summary>Restitution of the spin about the vertical, e_ω. 0 … 1; default 0.8.</summary>
    public double SpinRestitution { get; init; } = 0.8;

    /// <summary>Coefficient of sliding friction μ_s. 0 … 1e9; default 0.5.</summary>
    public double SlidingFriction { get; init; } = 0.5;

    /// <summary>Coefficient of rolling friction μ_r. 0 … 1e9; default 0.05.</summary>
    public double RollingFriction { get; init; } = 0.05;

    /// <summary>Damping c_ω of the spin about the vertical on the ground, N m s. 0 … 1e12; default 0.002.</summary>
    public double SpinDamping { get; init; } = 0.002;

    /// <summary>A ball that leaves an impact slower than this, upwards, stays down, m/s. 0.001 … 1e12; default 0.2.</summary>
    public double MinimumBounceSpeed { get; init; } = 0.2;

    /// <summary>A rolling ball with less kinetic energy than this is at rest, J. Above 0; default 1e-4.</summary>
    public double RestEnergy { get; init; } = 1e-4;

    /// <summary>Height of the ground, m: contact is where the centre is one radius above it. Within ±1e6; default 0.</summary>
    public double Height { get; init; }

    /// <summary>What is left of drag and Magnus force on the ground. Default <see cref="GroundAerodynamics.Horizontal"/>.</summary>
    public GroundAerodynamics Aerodynamics { get; init; } = GroundAerodynamics.Horizontal;

    /// <summary>The default: dry, mown turf.</summary>
    public static Ground Turf { get; } = new();

    /// <summary>Wet turf: lower bounce, half the sliding friction, a faster roll.</summary>
    public static Ground WetTurf { get; } = new() { NormalRestitution = 0.5, SlidingFriction = 0.25, RollingFriction = 0.035 };

    /// <summary>A hard, smooth court: high bounce, little rolling friction.</summary>
    public static Ground Court { get; } = new() { NormalRestitution = 0.75, SlidingFriction = 0.6, RollingFriction = 0.015 };

    /// <summary>Sand: hardly a bounce, and a short roll.</summary>
    public static Ground Sand { get; } = new() { NormalRestitution = 0.15, TangentialRestitutionX = 0, TangentialRestitutionZ = 0, SlidingFriction = 0.7, RollingFriction = 0.3 };
}
