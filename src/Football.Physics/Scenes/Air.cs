namespace FootballPhysics;

/// <summary>The air that the ball moves through.</summary>
public sealed record Air
{
    /// <summary>Density ρ, kg/m³. 0 … 100; default 1.2.</summary>
    public double Density { get; init; } = 1.2;

    /// <summary>Kinematic viscosity ν, m²/s. 1e-7 … 0.1; default 1.5e-5.</summary>
    public double KinematicViscosity { get; init; } = 1.5e-5;

    /// <summary>Steady wind, m/s. Speed at most 1000; default none.</summary>
    public Vector3d Wind { get; init; }

    /// <summary>Wind by place and time, on top of the steady one: <see cref="WindByHeight"/>, or a game's own. Default null: none.</summary>
    public IWind? WindField { get; init; }

    /// <summary>True when there is no wind at all.</summary>
    internal bool IsStill => Wind == Vector3d.Zero && WindField is null;

    internal void Validate()
    {
        SceneFields.Check(SceneFields.Air, this, "air.");
        Check.Size("air.wind", Wind, Limits.Speed, "m/s");

        // How fast it can be is all that is known of a game's own wind: flights rely on it.
        if (WindField is not null)
        {
            Check.Within("air.windField.maximumSpeed", WindField.MaximumSpeed, 0, Limits.Speed);
        }
    }
}
