using FootballPhysics.Numerics;
using FootballPhysics.Scenes;

namespace FootballPhysics;

/// <summary>The air that the ball moves through.</summary>
public sealed record Air
{
    /// <summary>The density ρ, in kg/m³. 0 … 100; default 1.2.</summary>
    public double Density { get; init; } = 1.2;

    /// <summary>The kinematic viscosity ν, in m²/s. 1e-7 … 0.1; default 1.5e-5.</summary>
    public double KinematicViscosity { get; init; } = 1.5e-5;

    /// <summary>The steady wind, in m/s; at most 1000. Default: none.</summary>
    public Vector3d Wind { get; init; }

    /// <summary>A wind that varies with position and time, added to the steady wind. Default null: none.</summary>
    /// <remarks>Use <see cref="WindByHeight"/>, or implement <see cref="IWind"/>.</remarks>
    public IWind? WindField { get; init; }

    /// <summary>True if there is no wind at all.</summary>
    internal bool IsStill => Wind == Vector3d.Zero && WindField is null;

    internal void Validate()
    {
        SceneFields.Check(SceneFields.Air, this, "air.");
        Check.Size("air.wind", Wind, Limits.Speed, "m/s");

        // A custom wind is code, so only its declared maximum can be checked. Flights rely on this maximum.
        if (WindField is not null)
        {
            Check.Within("air.windField.maximumSpeed", WindField.MaximumSpeed, 0, Limits.Speed);
        }
    }
}
