using FootballPhysics.Numerics;

namespace FootballPhysics.Laws;

/// <summary>The gusts of a wind: turbulence with a Dryden spectrum that drifts with the mean wind.</summary>
/// <remarks>The gusts are a pure function of seed, position and time.</remarks>
public sealed record Gusts
{
    /// <summary>The seed: each value gives different gusts of the same strength. Default 0.</summary>
    public long Seed { get; init; }

    /// <summary>The standard deviation of the gusts along the wind, relative to the wind speed. 0 … 1; default 0.18.</summary>
    /// <remarks>The wind speed is that at the reference height. The deviation is 0.8 times this value across the wind, and 0.5 times vertically. Guess: open
    /// grassland at 10 m.</remarks>
    public double Intensity { get; init; } = 0.18;

    /// <summary>The length L of the largest gusts, in m. 1 … 1000; default 40 (guess).</summary>
    public double Length { get; init; } = 40;

    internal void Validate()
    {
        Check.Within("air.wind.gusts.intensity", Intensity, 0, 1);
        Check.Within("air.wind.gusts.length", Length, 1, 1000);
    }
}
