namespace Football.Physics;

/// <summary>The air that the ball moves through.</summary>
public sealed record Air
{
    /// <summary>Density ρ, kg/m³. 0 … 1e12; default 1.2.</summary>
    public double Density { get; init; } = 1.2;

    /// <summary>Kinematic viscosity ν, m²/s. 1e-15 … 1e15; default 1.5e-5.</summary>
    public double KinematicViscosity { get; init; } = 1.5e-5;

    /// <summary>Wind velocity, m/s. Speed at most 1000; default none.</summary>
    public Vector3d Wind { get; init; }
}
